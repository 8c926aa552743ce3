#include "scene/flatten.h"

#include "scene/faces.h"
#include "scene/polygon.h"
#include "scene/syntax_sentence.h"
#include "scene/to_float.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

namespace pathmark {
namespace {

// In normalised coordinates, in which a scene's half extent is at least 1e-2.
constexpr float kSmallestRadius = 1e-12f;
constexpr double kSmallestLight = 1e-18;  // an area, whose square float can hold

std::uint32_t count(std::size_t n) { return static_cast<std::uint32_t>(n); }

// Of a triangle as a worker sees it: with its corners in float. 0 if it is a line or a point.
double roundedArea(std::span<const Float3> vertices, const TriangleIndices& t) {
  const auto corner = [&](std::size_t k) { return toDouble3(vertices[t[k]]); };
  const glm::dvec3 a = corner(1) - corner(0), b = corner(2) - corner(0), c = b - a;
  const double doubled = glm::length(glm::cross(a, b));
  const double longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
  return doubled > kFlatArea * longest ? 0.5 * doubled : 0.0;
}

double roundedArea(std::span<const glm::dvec3> vertices, const TriangleIndices& t) {
  const std::array corners{toFloat3(vertices[t[0]]), toFloat3(vertices[t[1]]),
                           toFloat3(vertices[t[2]])};
  return roundedArea(corners, {0, 1, 2});
}

class Flattener {
 public:
  Flattener(const SceneDescription& scene, const Place& shapes, std::vector<std::string>& notes)
      : scene_(scene), shapes_(shapes), notes_(notes) {}

  FlatScene flatten() {
    flat_.camera.eye = toFloat3(scene_.camera.eye);
    flat_.maxBounces = static_cast<std::uint32_t>(scene_.maxBounces);
    reserveArrays();
    for (const MaterialDescription& m : scene_.materials) addMaterial(m);
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i) addShape(i);
    noteDropped();
    return std::move(flat_);
  }

 private:
  // For all that the shapes may have, so that large arrays are neither copied nor half empty.
  void reserveArrays() {
    std::size_t triangles = 0, vertices = 0;
    for (const ShapeDescription& shape : scene_.shapes) {
      const bool isMesh = shape.kind == ShapeKind::kMesh;
      const bool shares = isMesh && toFloat3(shape.emission) == Float3{};
      const std::size_t most = isMesh                          ? shape.triangles.size()
                               : shape.kind == ShapeKind::kBox ? 12
                                                               : shape.vertices.size();
      triangles += most;
      vertices += shares ? shape.vertices.size() : 3 * most;
    }
    flat_.triangles.reserve(triangles);
    flat_.vertices.reserve(vertices);
  }

  void addMaterial(const MaterialDescription& m) {
    const bool phong = m.kind == MaterialKind::kPhong;
    flat_.materials.push_back({phong ? FlatMaterialKind::kPhong : FlatMaterialKind::kLambertian,
                               toFloat3(m.kd), toFloat3(m.ks), static_cast<float>(m.exponent)});
  }

  void addShape(std::size_t index) {
    const ShapeDescription& shape = scene_.shapes[index];
    const Place place(shapes_, index);
    const Float3 emission = toFloat3(shape.emission);
    const bool emits = emission != Float3{};
    flat_.shapes.push_back({count(shape.material), shape.frontOnly ? 1u : 0u, emission});
    if (shape.kind == ShapeKind::kSphere) {
      addSphere(shape, place, emits);
    } else if (shape.kind == ShapeKind::kMesh && !emits) {
      addMesh(shape, place);
    } else {
      addFaces(makeFaces(shape, place), shape, place, emits);
    }
  }

  // Triangles that share vertices, without a face for each.
  void addMesh(const ShapeDescription& mesh, const Place& place) {
    const std::uint32_t first = count(flat_.vertices.size());
    for (const glm::dvec3& v : mesh.vertices) flat_.vertices.push_back(toFloat3(v));
    const std::span<const Float3> rounded = std::span(flat_.vertices).subspan(first);
    std::size_t kept = 0;
    for (const TriangleIndices& t : mesh.triangles) {
      if (roundedArea(rounded, t) == 0.0) continue;
      const glm::dvec3& p = mesh.vertices[t[0]];
      const glm::dvec3 normal = glm::cross(mesh.vertices[t[1]] - p, mesh.vertices[t[2]] - p);
      flat_.triangles.push_back({{first + t[0], first + t[1], first + t[2]},
                                 currentShape(),
                                 toFloat3(glm::normalize(normal))});
      ++kept;
    }
    if (kept < mesh.triangles.size()) drop(mesh.triangles.size() - kept, mesh, place);
    if (kept == 0) refuseNothing(place);
  }

  std::uint32_t currentShape() const { return count(flat_.shapes.size() - 1); }

  void addSphere(const ShapeDescription& shape, const Place& place, bool emits) {
    const auto radius = static_cast<float>(shape.radius);
    if (radius < kSmallestRadius) {
      Place(place, "radius")
          .refuse("a radius that is almost nothing beside the rest of the scene",
                  "it must be at least a part in a million million of it");
    }
    if (emits) {
      FlatLight light;
      light.sphere = count(flat_.spheres.size());
      light.emission = flat_.shapes.back().emission;
      flat_.lights.push_back(light);
    }
    flat_.spheres.push_back(
        {toFloat3(shape.centre), radius, currentShape(), shape.inward ? 1u : 0u});
  }

  void addFaces(std::vector<Face> faces, const ShapeDescription& shape, const Place& place,
                bool emits) {
    for (Face& face : faces) {
      const std::size_t dropped = std::erase_if(face.triangles, [&](const TriangleIndices& t) {
        return roundedArea(face.vertices, t) == 0.0;
      });
      if (dropped > 0) drop(dropped, shape, place);
      for (const TriangleIndices& t : face.triangles) addTriangle(face, t);
    }
    std::erase_if(faces, [](const Face& face) { return face.triangles.empty(); });
    switch (shape.kind) {
      case ShapeKind::kRectangle:
      case ShapeKind::kPolygon:
        if (faces.empty()) refuseNothing(Place(place, "vertices"));
        break;
      case ShapeKind::kBox:
      case ShapeKind::kMesh:
        if (faces.empty()) refuseNothing(place);
        break;
      default:
        break;  // triangles and quads come in numbers, and are counted instead
    }
    if (emits && !faces.empty()) addLight(faces, place);
  }

  [[noreturn]] static void refuseNothing(const Place& place) {
    place.refuse("a shape that is almost nothing beside the rest of the scene",
                 "it must be large enough for its corners to differ");
  }

  void addTriangle(const Face& face, const TriangleIndices& t) {
    std::array<Float3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = toFloat3(face.vertices[t[k]]);
    flat_.addTriangle(corners, toFloat3(face.normal), currentShape());
  }

  void addLight(const std::vector<Face>& faces, const Place& place) {
    std::vector<double> areas;
    double total = 0.0;
    for (const Face& face : faces) {
      for (const TriangleIndices& t : face.triangles) total += roundedArea(face.vertices, t);
      areas.push_back(total);
    }
    if (total < kSmallestLight) {
      place.refuse("a light whose area is almost nothing beside the rest of the scene",
                   "its side must be at least a part in a thousand million of it");
    }
    FlatLight light;
    light.firstFace = count(flat_.faces.size());
    light.faceCount = count(faces.size());
    light.emission = flat_.shapes.back().emission;
    flat_.lights.push_back(light);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const bool last = i + 1 == faces.size();
      addLightFace(faces[i], last ? 1.0f : static_cast<float>(areas[i] / total));
    }
  }

  void addLightFace(const Face& face, float cumulativeArea) {
    flat_.faces.push_back({count(flat_.lightVertices.size()), count(face.vertices.size()),
                           count(flat_.lightTriangles.size()), count(face.triangles.size()),
                           toFloat3(face.normal), cumulativeArea});
    for (const glm::dvec3& v : face.vertices) flat_.lightVertices.push_back(toFloat3(v));
    flat_.lightTriangles.insert(flat_.lightTriangles.end(), face.triangles.begin(),
                                face.triangles.end());
  }

  void drop(std::size_t triangles, const ShapeDescription& shape, const Place& place) {
    if (dropped_ == 0) {
      firstDropped_ = place.pointer();
      if (!shape.name.empty()) firstDropped_ += fmt::format(" ({})", inQuotes(shape.name));
    }
    dropped_ += triangles;
  }

  void noteDropped() {
    if (dropped_ == 0) return;
    notes_.push_back(
        dropped_ == 1 ? fmt::format("A triangle of zero area was left out, of {}.", firstDropped_)
                      : fmt::format("{} triangles of zero area were left out, the "
                                    "first of {}.",
                                    dropped_, firstDropped_));
  }

  const SceneDescription& scene_;
  const Place& shapes_;
  std::vector<std::string>& notes_;
  FlatScene flat_;
  std::size_t dropped_ = 0;
  std::string firstDropped_;
};

}  // namespace

FlatScene flatten(const SceneDescription& scene, const Place& top,
                  std::vector<std::string>& notes) {
  return Flattener(scene, Place(top, "shapes"), notes).flatten();
}

}  // namespace pathmark
