#include "scene/light_planes.h"

#include "scene/polygon.h"
#include "scene/to_float.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace pathmark {
namespace {

// Of the largest coordinate: some roundings of a float, of which each is half of 2^-23.
constexpr double kRounding = 1.0 / (1 << 20);
// Of the smaller triangle's area. Triangles that only have an edge in common overlap by less.
constexpr double kLeastOverlap = 1e-4;
constexpr std::size_t kMostTriangles = 10000;
// Boxes that are compared in all: some tens of milliseconds.
constexpr std::size_t kMostComparisons = 10000000;

struct Bounds {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void include(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool meets(const Bounds& other, double gap) const {
    return glm::all(glm::lessThanEqual(low, other.high + gap)) &&
           glm::all(glm::lessThanEqual(other.low, high + gap));
  }
};

struct Triangle {
  std::array<glm::dvec3, 3> corners;
  glm::dvec3 normal;
  Bounds bounds;
};

struct Shape {
  std::uint32_t number = 0;
  std::span<const FlatTriangle> triangles;
  Bounds bounds;
};

// Counter-clockwise seen from its front.
Triangle triangleOf(const FlatSceneView& scene, const FlatTriangle& flat) {
  Triangle triangle;
  const std::array<Float3, 3> corners = scene.corners(flat);
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.corners[k] = toDouble3(corners[k]);
    triangle.bounds.include({triangle.corners[k], triangle.corners[k]});
  }
  const auto& [p, q, r] = triangle.corners;
  triangle.normal = glm::normalize(glm::cross(q - p, r - p));
  if (glm::dot(triangle.normal, toDouble3(flat.normal)) < 0.0) {
    std::swap(triangle.corners[1], triangle.corners[2]);
    triangle.normal = -triangle.normal;
  }
  return triangle;
}

// Without spheres and large meshes. The triangles of a shape follow each other.
std::vector<Shape> shapesOf(const FlatSceneView& scene) {
  std::vector<Shape> shapes;
  for (std::size_t first = 0, end = 0; first < scene.triangles.size(); first = end) {
    const std::uint32_t number = scene.triangles[first].shape;
    while (end < scene.triangles.size() && scene.triangles[end].shape == number) ++end;
    if (end - first > kMostTriangles) continue;
    Shape shape{number, scene.triangles.subspan(first, end - first), {}};
    for (const FlatTriangle& t : shape.triangles)
      for (const Float3& corner : scene.corners(t))
        shape.bounds.include({toDouble3(corner), toDouble3(corner)});
    shapes.push_back(shape);
  }
  return shapes;
}

bool liesInPlaneOf(const Triangle& a, const Triangle& b, double gap) {
  return std::all_of(a.corners.begin(), a.corners.end(), [&](const glm::dvec3& corner) {
    return std::abs(glm::dot(b.normal, corner - b.corners[0])) <= gap;
  });
}

double areaOf(const Outline& outline) {
  double doubled = 0.0;
  for (std::size_t k = 2; k < outline.size(); ++k)
    doubled += orientation(outline[0], outline[k - 1], outline[k]);
  return 0.5 * doubled;
}

// What lies to the left of the line from a to b.
Outline clipped(const Outline& outline, const glm::dvec2& a, const glm::dvec2& b) {
  Outline inside;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const glm::dvec2 &p = outline[k], &q = outline[(k + 1) % outline.size()];
    const double ofP = orientation(a, b, p), ofQ = orientation(a, b, q);
    if (ofP >= 0.0) inside.push_back(p);
    if ((ofP >= 0.0) != (ofQ >= 0.0)) inside.push_back(p + (q - p) * (ofP / (ofP - ofQ)));
  }
  return inside;
}

// Of triangles of one plane, as a share of the smaller one's area (Sutherland & Hodgman 1974).
double overlap(const Triangle& a, const Triangle& b) {
  const Outline there = project(b.corners, a.normal);
  const Outline here = project(a.corners, a.normal);
  Outline common = here;
  for (std::size_t k = 0; k < 3; ++k) common = clipped(common, there[k], there[(k + 1) % 3]);
  return areaOf(common) / std::min(areaOf(here), areaOf(there));
}

class LightPlanes {
 public:
  explicit LightPlanes(const FlatSceneView& scene) : scene_(scene), shapes_(shapesOf(scene)) {
    Bounds all;
    for (const Shape& shape : shapes_) all.include(shape.bounds);
    const glm::dvec3 most = glm::max(glm::abs(all.low), glm::abs(all.high));
    gap_ = kRounding * std::max({most.x, most.y, most.z});
  }

  void find() {
    for (const Shape& light : shapes_)
      if (isLight(light) && compared_ < kMostComparisons) lookAt(light);
  }

  std::string sentence() const {
    if (lights_ == 0) return {};
    const std::string which =
        lights_ == 1
            ? fmt::format("The light /shapes/{} lies in the plane of /shapes/{}, which it overlaps",
                          light_, other_)
            : fmt::format(
                  "{} lights lie in the planes of shapes that they overlap, the first, "
                  "/shapes/{}, in that of /shapes/{}",
                  lights_, light_, other_);
    return fmt::format(
        "{}: which of the two is seen there is by chance; move the light by a thousandth of its "
        "size.",
        which);
  }

 private:
  bool isLight(const Shape& shape) const {
    return scene_.shapes[shape.number].emission != Float3{};
  }

  void lookAt(const Shape& light) {
    for (const Shape& other : shapes_) {
      ++compared_;
      // Two lights are looked at once.
      if (&other == &light || (isLight(other) && other.number < light.number)) continue;
      if (!other.bounds.meets(light.bounds, gap_) || !touch(light, other)) continue;
      if (lights_++ == 0) {
        light_ = light.number;
        other_ = other.number;
      }
      return;
    }
  }

  bool touch(const Shape& light, const Shape& other) {
    const std::vector<Triangle> ofOther = trianglesNear(other, light.bounds);
    for (const Triangle& a : trianglesNear(light, other.bounds)) {
      compared_ += ofOther.size();
      if (compared_ >= kMostComparisons) return false;
      for (const Triangle& b : ofOther)
        if (a.bounds.meets(b.bounds, gap_) && samePlace(a, b)) return true;
    }
    return false;
  }

  std::vector<Triangle> trianglesNear(const Shape& shape, const Bounds& bounds) {
    std::vector<Triangle> near;
    compared_ += shape.triangles.size();
    for (const FlatTriangle& flat : shape.triangles)
      if (const Triangle t = triangleOf(scene_, flat); t.bounds.meets(bounds, gap_))
        near.push_back(t);
    return near;
  }

  // A small triangle has no accurate plane, but lies in that of a large one.
  bool samePlace(const Triangle& a, const Triangle& b) const {
    return glm::dot(a.normal, b.normal) > 0.5 &&
           (liesInPlaneOf(a, b, gap_) || liesInPlaneOf(b, a, gap_)) &&
           overlap(a, b) > kLeastOverlap;
  }

  const FlatSceneView& scene_;
  std::vector<Shape> shapes_;
  double gap_ = 0.0;
  std::size_t compared_ = 0, lights_ = 0;
  std::uint32_t light_ = 0, other_ = 0;
};

}  // namespace

void noteLightsInPlanes(const FlatScene& scene, std::vector<std::string>& notes) {
  if (scene.faces.empty()) return;
  const FlatSceneView view = viewOf(scene);
  LightPlanes planes(view);
  planes.find();
  const std::string sentence = planes.sentence();
  if (!sentence.empty()) notes.push_back(sentence);
}

}  // namespace pathmark
