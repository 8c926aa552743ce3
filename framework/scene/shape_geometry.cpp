#include "scene/shape_geometry.h"

#include "scene/limits.h"
#include "scene/obj_mesh.h"
#include "scene/place.h"
#include "scene/syntax_sentence.h"
#include "scene/transform.h"
#include "scene/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

namespace pathmark {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestCommand = 200;

// Corner k has the high x, y and z where bit 0, 1 and 2 of k is set.
std::vector<glm::dvec3> boxCorners(const ShapeDescription& box) {
  std::vector<glm::dvec3> corners;
  for (unsigned k = 0; k < 8; ++k) {
    corners.emplace_back((k & 1) != 0 ? box.high.x : box.low.x,
                         (k & 2) != 0 ? box.high.y : box.low.y,
                         (k & 4) != 0 ? box.high.z : box.low.z);
  }
  return corners;
}

// With the corners of each edge along x exchanged, every face runs the other way round.
void turnInsideOut(std::vector<glm::dvec3>& corners) {
  for (std::size_t k = 0; k < corners.size(); k += 2) std::swap(corners[k], corners[k + 1]);
}

bool staysBelow(const fs::path& path) {
  return !path.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

// The file of a mesh, wherever links lead to.
fs::path findMesh(const ShapeDescription& shape, const SceneSource& source, const Place& place) {
  const fs::path name(shape.file);
  if (!staysBelow(name) || name.extension() != ".obj") {
    place.refuse(inQuotes(shape.file),
                 "a mesh is an .obj file in the scene's own folder or below it");
  }
  const fs::path folder = source.file.has_parent_path() ? source.file.parent_path() : fs::path(".");
  fs::path file = folder / name;
  std::error_code error;
  if (!fs::exists(file, error)) {
    place.refuse(inQuotes(shape.file),
                 shape.madeBy.empty()
                     ? fmt::format("there is no file {}", file.string())
                     : fmt::format("there is no file {} yet; the scene says that this makes it: {}",
                                   file.string(), shown(shape.madeBy, kLongestCommand)));
  }
  const fs::path real = fs::canonical(file, error), top = fs::canonical(folder, error);
  if (error || !staysBelow(real.lexically_relative(top))) {
    place.refuse(inQuotes(shape.file), "this link leads out of the scene's folder");
  }
  return file;
}

class GeometryMaker {
 public:
  GeometryMaker(const SceneDescription& scene, const SceneSource& source) : source_(source) {
    for (const ShapeDescription& shape : scene.shapes) {
      if (shape.kind == ShapeKind::kMesh) ++uses_[shape.file];
    }
  }

  void make(ShapeDescription& shape, const Place& place) {
    if (shape.kind == ShapeKind::kBox) {
      shape.vertices = boxCorners(shape);
    } else {
      Mesh mesh = read(shape, Place(place, "file"));
      shape.vertices = std::move(mesh.vertices);
      shape.triangles = std::move(mesh.triangles);
    }
    put(shape, place);
  }

 private:
  // A file that several shapes share is read once, and kept until the last of them.
  Mesh read(const ShapeDescription& shape, const Place& place) {
    const fs::path file = findMesh(shape, source_, place), name(shape.file);
    auto found = meshes_.find(name);
    if (found == meshes_.end()) found = meshes_.emplace(name, readObj(file)).first;
    count(found->second, place);
    if (--uses_[name] > 0) return found->second;
    Mesh last = std::move(found->second);
    meshes_.erase(found);
    return last;
  }

  // Before it is copied: a mesh takes far more memory than the lines that name it.
  void count(const Mesh& mesh, const Place& place) {
    const auto add = [&](std::uint64_t& sum, std::size_t more, std::uint64_t most,
                         std::string_view what) {
      sum += more;
      if (sum > most) {
        place.refuse(fmt::format("a mesh with which the scene has {} {}", sum, what),
                     fmt::format("the meshes of a scene may have at most {} together", most));
      }
    };
    add(triangles_, mesh.triangles.size(), kMostMeshTriangles, "triangles");
    add(vertices_, mesh.vertices.size(), kMostMeshVertices, "vertices");
  }

  static void put(ShapeDescription& shape, const Place& place) {
    const glm::dmat3 linear = linearPart(shape.transform);
    for (glm::dvec3& v : shape.vertices) {
      v = placed(linear, shape.transform, v);
      const glm::dvec3 size = glm::abs(v);
      if (!(std::max({size.x, size.y, size.z}) <= kLargestCoordinate)) {
        Place(place, "transform")
            .refuse("a transform that moves a vertex out of reach",
                    fmt::format("a coordinate must be from {} to {}", -kLargestCoordinate,
                                kLargestCoordinate));
      }
    }
    const bool mirrored = mirrors(shape.transform);
    if (shape.kind == ShapeKind::kBox) {
      if (mirrored != shape.inward) turnInsideOut(shape.vertices);
    } else if (mirrored) {
      for (TriangleIndices& t : shape.triangles) std::swap(t[1], t[2]);
    }
  }

  const SceneSource& source_;
  std::map<fs::path, std::size_t> uses_;  // that are still to come
  std::map<fs::path, Mesh> meshes_;
  std::uint64_t triangles_ = 0, vertices_ = 0;  // of all meshes so far
};

}  // namespace

void makeGeometry(SceneDescription& scene, const SceneSource& source) {
  GeometryMaker maker(scene, source);
  const Place top(source), shapes(top, "shapes");
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    ShapeDescription& shape = scene.shapes[i];
    if (shape.kind == ShapeKind::kBox || shape.kind == ShapeKind::kMesh) {
      maker.make(shape, Place(shapes, i));
    }
  }
}

}  // namespace pathmark
