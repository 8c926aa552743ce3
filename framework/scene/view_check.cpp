#include "scene/view_check.h"

#include "scene/to_float.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pathmark {
namespace {

// A shape that touches the border is left to the render.
constexpr double kMargin = 1e-5;

// The four sides of the pyramid through the eye and the film, by their inward unit normals. For
// fields of view below 180 degrees nothing behind the eye is inside of all of them.
class ViewPyramid {
 public:
  explicit ViewPyramid(const FlatCamera& camera) : eye_(toDouble3(camera.eye)) {
    const glm::dvec3 right = toDouble3(camera.pixelRight) * static_cast<double>(camera.width);
    const glm::dvec3 down = toDouble3(camera.pixelDown) * static_cast<double>(camera.height);
    const glm::dvec3 corner = toDouble3(camera.topLeft);
    const std::array corners{corner, corner + right, corner + right + down, corner + down};
    for (std::size_t k = 0; k < 4; ++k) {
      sides_[k] = glm::normalize(glm::cross(corners[(k + 1) % 4], corners[k]));
    }
    if (glm::dot(sides_[0], corners[2]) < 0.0) {
      for (glm::dvec3& side : sides_) side = -side;
    }
  }

  // Whether the hull of spheres of this radius around the points may reach into the pyramid.
  template <std::size_t N>
  bool mayMeet(const std::array<Float3, N>& points, double radius = 0.0) const {
    return std::none_of(sides_.begin(), sides_.end(), [&](const glm::dvec3& side) {
      return std::all_of(points.begin(), points.end(), [&](const Float3& point) {
        const glm::dvec3 fromEye = toDouble3(point) - eye_;
        return glm::dot(side, fromEye) + radius < -kMargin * (glm::length(fromEye) + radius);
      });
    });
  }

 private:
  glm::dvec3 eye_;
  std::array<glm::dvec3, 4> sides_;
};

bool showsAnything(const FlatScene& scene) {
  const ViewPyramid pyramid(scene.camera);
  const FlatSceneView view = viewOf(scene);
  return std::any_of(view.spheres.begin(), view.spheres.end(),
                     [&](const FlatSphere& s) {
                       return pyramid.mayMeet(std::array<Float3, 1>{s.centre},
                                              static_cast<double>(s.radius));
                     }) ||
         std::any_of(view.triangles.begin(), view.triangles.end(),
                     [&](const FlatTriangle& t) { return pyramid.mayMeet(view.corners(t)); });
}

bool isEmpty(const FlatScene& scene) { return scene.triangles.empty() && scene.spheres.empty(); }

}  // namespace

void requireView(const FlatScene& scene, const Place& camera) {
  if (isEmpty(scene) || showsAnything(scene)) return;
  camera.refuse("a camera that sees none of the shapes",
                "\"eye\", \"target\" and \"fieldOfView\" must bring at least one into the image");
}

void noteDarkness(const FlatScene& scene, std::vector<std::string>& notes) {
  if (isEmpty(scene)) {
    notes.emplace_back("The scene has no shapes: its picture is black.");
  } else if (scene.lights.empty()) {
    notes.emplace_back("No shape of the scene has an emission: its picture is black.");
  }
}

}  // namespace pathmark
