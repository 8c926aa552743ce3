// What the preview makes of scene files, without a window and without coursework that compiles.
#include "preview/engine.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>

namespace pathmark::preview::test {
namespace {

using pathmark::test::TemporaryFolder;

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* kTwoTriangles = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n";

class PreviewEngine : public testing::Test {
 protected:
  PreviewEngine() { std::filesystem::create_directory(folder_ / "coursework"); }

  void writeScene(const std::string& size) const {
    std::ofstream(folder_ / "own.json") << R"({
      "camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "fieldOfView": 40}, "size": )" +
                                               size +
                                               R"(,
      "materials": {"white": {"type": "lambertian", "Kd": [1, 1, 1]}},
      "shapes": [{"type": "mesh", "file": "own.obj", "material": "white"},
        {"type": "sphere", "centre": [0, 0, 2], "radius": 0.1, "material": "white",
         "emission": [1, 1, 1]}]})";
  }
  void writeMesh(const std::string& text) const { std::ofstream(folder_ / "own.obj") << text; }

  EngineRequest request() const {
    EngineRequest request;
    request.with = (folder_ / "coursework").string();
    request.scene = folder_ / "own.json";
    return request;
  }

  // The first state of which this holds.
  template <class Condition>
  std::shared_ptr<const EngineState> waitFor(Engine& engine, const Condition& condition) {
    std::unique_lock lock(mutex_);
    std::shared_ptr<const EngineState> state;
    changed_.wait(lock, [&] { return condition(*(state = engine.state())); });
    return state;
  }
  std::function<void()> wake() {
    return [this] {
      const std::lock_guard lock(mutex_);
      changed_.notify_all();
    };
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;

 protected:
  TemporaryFolder folder_;
};

TEST_F(PreviewEngine, ReadsTheSceneAnewWhenAMeshIsSaved) {
  writeScene("[8, 8]");
  writeMesh(kTriangle);
  Engine engine(request(), wake());
  const auto triangles = [](const EngineState& s) {
    return s.scene ? s.scene->loaded.flat.triangles.size() : 0;
  };
  waitFor(engine, [&](const EngineState& s) { return triangles(s) == 1; });
  writeMesh(kTwoTriangles);
  waitFor(engine, [&](const EngineState& s) { return triangles(s) == 2; });
  writeMesh("nonsense");
  waitFor(engine, [](const EngineState& s) { return !s.sceneFailure.empty(); });
  writeMesh(kTriangle);
  waitFor(engine,
          [&](const EngineState& s) { return triangles(s) == 1 && s.sceneFailure.empty(); });
}

TEST_F(PreviewEngine, RefusesASceneOfMorePixelsThanARenderMayHave) {
  writeScene("[16384, 8192]");
  writeMesh(kTriangle);
  Engine engine(request(), wake());
  const auto state =
      waitFor(engine, [](const EngineState& s) { return s.scene || !s.sceneFailure.empty(); });
  EXPECT_EQ(state->scene, nullptr);
  EXPECT_NE(state->sceneFailure.find("16384x8192"), std::string::npos) << state->sceneFailure;
}

}  // namespace
}  // namespace pathmark::preview::test
