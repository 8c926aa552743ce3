// Scenes at the edge of sense: each is refused with a sentence, or gives the picture that it must.
#include "bench/stress/stress.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFloor =
    R"({"type": "rectangle", "material": "grey",
        "vertices": [[-2, 0, 2], [2, 0, 2], [2, 0, -2], [-2, 0, -2]]})";
constexpr const char* kLamp =
    R"({"type": "rectangle", "material": "grey", "emission": [3, 2, 1],
        "vertices": [[-1, 2, -1], [1, 2, -1], [1, 2, 1], [-1, 2, 1]]})";

std::string sceneText(const std::vector<std::string>& shapes,
                      const std::string& camera = R"("eye": [0, 1, 4], "target": [0, 0.5, 0])") {
  return fmt::format(R"({{"camera": {{{}, "fieldOfView": 50}}, "size": [32, 32], "maxBounces": 3,
    "materials": {{"grey": {{"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
                  "black": {{"type": "lambertian", "Kd": [0, 0, 0]}}}}, "shapes": [{}]}})",
                     camera, fmt::join(shapes, ","));
}

// A folder of its own for a mesh.
class MeshFolder {
 public:
  MeshFolder() {
    std::string name = (fs::temp_directory_path() / "pathmark-stress.XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw std::system_error(errno, std::generic_category(), "making a folder");
    path_ = name;
  }
  ~MeshFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  MeshFolder(const MeshFolder&) = delete;
  MeshFolder& operator=(const MeshFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

class Degenerate {
 public:
  explicit Degenerate(Stress& stress) : stress_(stress), worker_(stress) {}

  double faults() const { return faults_; }

  // A case that is refused is right, if that is allowed; otherwise `judge` says what is wrong with
  // the picture, or nothing.
  void look(const std::string& name, const std::string& text, bool mayBeRefused,
            const std::function<std::string(const Image&)>& judge, const fs::path& folder = {}) {
    stress_.progress.show(name);
    std::string verdict;
    try {
      const Image image = render(text, folder);
      verdict = judge(image);
      if (verdict.empty())
        verdict = "right";
      else
        ++faults_;
    } catch (const SceneError& e) {
      verdict = fmt::format("refused: {}", e.what());
      if (!mayBeRefused) ++faults_;
    } catch (const WorkerError& e) {
      verdict = fmt::format("failed: {}", e.what());
      ++faults_;
    }
    stress_.row({name, fmt::format("{:.2f} s", seconds_), verdict});
  }

  Image render(const std::string& text, const fs::path& folder = {}) {
    const auto started = std::chrono::steady_clock::now();
    const LoadedScene scene = loadScene(SceneSource{folder / "scene.json", text});
    RenderOptions options;
    options.raysPerPixel = 16;
    worker_.load(scene.flat);
    Image image = worker_.render(settingsFor(scene, options)).image;
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return image;
  }

 private:
  Stress& stress_;
  StressWorker worker_;
  double faults_ = 0.0;
  double seconds_ = 0.0;
};

std::string everywhere(const Image& image, double value) {
  for (const float x : image.rgb)
    if (!(std::abs(static_cast<double>(x) - value) <= 1e-5 * std::max(value, 1.0)))
      return fmt::format("a value is {:g}, not {:g}", x, value);
  return {};
}

std::string black(const Image& image) { return everywhere(image, 0.0); }

std::string anyRadiance(const Image& image) {
  for (const float x : image.rgb)
    if (!(std::isfinite(x) && x >= 0.0f)) return fmt::format("a value is {:g}", x);
  return {};
}

std::function<std::string(const Image&)> sameAs(const Image& expected) {
  return [&expected](const Image& image) -> std::string {
    const std::size_t different = differingValues(expected, image);
    return different == 0 ? "" : fmt::format("{} values differ", different);
  };
}

// Another way to intersect the same surfaces rounds otherwise.
std::function<std::string(const Image&)> nearlyAs(const Image& expected) {
  return [&expected](const Image& image) -> std::string {
    double difference = 0.0, sum = 0.0;
    auto wanted = expected.rgb.begin();
    for (const float value : image.rgb) {
      difference += std::abs(static_cast<double>(value) - static_cast<double>(*wanted));
      sum += static_cast<double>(*wanted++);
    }
    return difference <= 1e-3 * sum ? "" : fmt::format("off by {:.2g} %", 100.0 * difference / sum);
  };
}

// `times` copies of a triangle of a mesh.
void writeCopies(const fs::path& file, int times, const std::string& extraFaces = {}) {
  std::ofstream out(file);
  out << "v -1 0.5 0\nv 1 0.5 0\nv 0 1.5 0\nv 0 0.5 0\n";
  for (int k = 0; k < times; ++k) out << "f 1 2 3\n";
  out << extraFaces;
}

constexpr const char* kMesh = R"({"type": "mesh", "material": "grey", "file": "mesh.obj"})";

void lookAtLights(Degenerate& d) {
  d.look("empty", sceneText({}), false, black);
  d.look("no light", sceneText({kFloor}), false, black);
  d.look("a lamp that faces away", sceneText({kFloor, R"({"type": "rectangle", "material": "grey",
    "emission": [1, 1, 1], "vertices": [[-1, 2, 1], [1, 2, 1], [1, 2, -1], [-1, 2, -1]]})"}),
         false, black);
  d.look("a lamp behind everything",
         sceneText({R"({"type": "box", "material": "grey", "inward": true, "low": [-5, -5, -5],
                       "high": [5, 5, 5]})",
                    R"({"type": "sphere", "material": "grey", "centre": [0, 9, 0], "radius": 1,
                       "emission": [1, 1, 1]})"}),
         false, black);
  d.look("only lamps, no bounce of light",
         sceneText({R"({"type": "sphere", "material": "black", "centre": [0, 1, 0], "radius": 9,
                       "inward": true, "emission": [0.25, 0.25, 0.25]})"}),
         false, [](const Image& image) { return everywhere(image, 0.25); });
  d.look("two lamps, one in the other's plane",
         sceneText({kFloor, kLamp,
                    R"({"type": "rectangle", "material": "grey", "emission": [3, 2, 1],
                       "vertices": [[1, 2, -1], [2, 2, -1], [2, 2, 1], [1, 2, 1]]})"}),
         false, anyRadiance);
}

void lookFromInside(Degenerate& d) {
  const std::string inside = R"("eye": [0.1, 1, 0.2], "target": [3, 1, 0])";
  d.look("an eye inside a sphere",
         sceneText({kLamp, R"({"type": "sphere", "material": "grey", "centre": [0, 1, 0],
                              "radius": 0.5})"},
                   inside),
         false, black);
  d.look("an eye inside a lamp that shines outwards",
         sceneText({R"({"type": "sphere", "material": "grey", "centre": [0, 1, 0], "radius": 0.5,
                       "emission": [1, 1, 1]})"},
                   inside),
         false, black);
  d.look("an eye inside a box",
         sceneText({kLamp, R"({"type": "box", "material": "grey", "low": [-1, 0, -1],
                              "high": [1, 1.5, 1]})"},
                   inside),
         false, black);
  d.look("an eye on a surface",
         sceneText({kFloor, kLamp}, R"("eye": [0, 0, 0], "target": [0, 1, -1])"), true,
         anyRadiance);
}

void lookAtAreas(Degenerate& d) {
  MeshFolder folder;
  d.look("a triangle on a line", sceneText({kFloor, R"({"type": "triangle", "material": "grey",
                               "vertices": [[0, 0, 0], [1, 1, 1], [2, 2, 2]]})"}),
         true, anyRadiance);
  d.look("a triangle that is a point",
         sceneText({kFloor, R"({"type": "triangle", "material": "grey",
                               "vertices": [[1, 1, 1], [1, 1, 1], [1, 1, 1]]})"}),
         true, anyRadiance);
  d.look("a lamp without area",
         sceneText({kFloor, R"({"type": "rectangle", "material": "grey", "emission": [1, 1, 1],
                               "vertices": [[0, 2, 0], [1, 2, 0], [1, 2, 0], [0, 2, 0]]})"}),
         true, black);
  d.look("a sphere without radius",
         sceneText({kFloor, R"({"type": "sphere", "material": "grey", "centre": [0, 1, 0],
                               "radius": 0})"}),
         true, anyRadiance);
  const std::string text = sceneText({kFloor, kLamp, kMesh});
  writeCopies(folder.path() / "mesh.obj", 1);
  const Image plain = d.render(text, folder.path());
  writeCopies(folder.path() / "mesh.obj", 1, "f 1 4 2\nf 1 1 3\nf 3 3 3\n");
  d.look("a mesh with faces without area", text, false, sameAs(plain), folder.path());
}

void lookAtCopies(Degenerate& d, bool quick) {
  MeshFolder folder;
  const Image one = d.render(sceneText({kFloor, kLamp}));
  d.look("the same floor twice", sceneText({kFloor, kFloor, kLamp}), false, sameAs(one));
  d.look("a floor and its back in one place",
         sceneText({kFloor, kLamp, R"({"type": "rectangle", "material": "grey",
                                      "vertices": [[-2, 0, -2], [2, 0, -2], [2, 0, 2], [-2, 0, 2]]})"}),
         false, anyRadiance);
  const std::string sphere =
      R"({"type": "sphere", "material": "grey", "centre": [0, 0.6, 0], "radius": 0.5})";
  const Image ball = d.render(sceneText({kFloor, kLamp, sphere}));
  d.look("the same sphere twice", sceneText({kFloor, kLamp, sphere, sphere}), false, sameAs(ball));
  const std::string text = sceneText({kFloor, kLamp, kMesh});
  writeCopies(folder.path() / "mesh.obj", 1);
  const Image single = d.render(text, folder.path());
  for (const int copies : {100, quick ? 20000 : 1000000}) {
    writeCopies(folder.path() / "mesh.obj", copies);
    d.look(fmt::format("{} copies of one triangle", copies), text, false, nearlyAs(single),
           folder.path());
  }
}

}  // namespace

void stressDegenerate(Stress& stress) {
  stress.begin({.key = "degenerate",
                .title = "Degenerate scenes",
                .columns = {{"scene", "scene"}, {"seconds", "time"}, {"verdict", "verdict"}},
                .rows = {}});
  Degenerate degenerate(stress);
  lookAtLights(degenerate);
  lookFromInside(degenerate);
  lookAtAreas(degenerate);
  lookAtCopies(degenerate, stress.quick);
  stress.addFaults("degenerate", "degenerate scenes that are neither right nor refused",
                   degenerate.faults());
  stress.progress.advance(15.0);
}

}  // namespace pathmark::bench
