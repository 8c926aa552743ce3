#include "preview/camera_pose.h"

#include "preview/same_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::preview {

namespace {

glm::dvec3 toDouble(const Float3& v) { return {v[0], v[1], v[2]}; }
glm::dvec3 toDouble(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
Float3 toFloat(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// As near as the camera may come to looking along `up`.
constexpr double kSteepest = 0.49 * std::numbers::pi;

}  // namespace

CameraPose::CameraPose(const LoadedScene& scene)
    : file_(scene.flat.camera),
      fileEye_(toDouble(scene.flat.camera.eye)),
      fileTarget_(toDouble(scene.target)),
      fileUp_(toDouble(scene.up)) {
  reset();
  const Axes a = axes();
  const glm::dvec3 topLeft = toDouble(file_.topLeft);
  topLeft_ = {dot(topLeft, a.right), dot(topLeft, a.up), dot(topLeft, a.forward)};
  pixel_ = length(toDouble(file_.pixelRight));
}

bool CameraPose::isOf(const LoadedScene& scene) const {
  return sameCamera(file_, scene.flat.camera) && fileTarget_ == toDouble(scene.target) &&
         fileUp_ == toDouble(scene.up);
}

void CameraPose::reset() {
  eye_ = fileEye_;
  target_ = fileTarget_;
  up_ = fileUp_;
  moved_ = false;
}

CameraPose::Axes CameraPose::axes() const {
  const glm::dvec3 forward = normalize(target_ - eye_);
  const glm::dvec3 right = normalize(cross(forward, up_));
  return {right, cross(right, forward), forward};
}

void CameraPose::orbit(double right, double upwards) {
  const glm::dvec3 fromTarget = eye_ - target_;
  const double distance = length(fromTarget);
  const double height = std::clamp(dot(fromTarget, up_) / distance, -1.0, 1.0);
  const double elevation = std::asin(height);
  const double wanted = std::clamp(elevation + upwards, -kSteepest, kSteepest);
  const glm::dvec3 level = normalize(fromTarget - dot(fromTarget, up_) * up_);
  const glm::dvec3 aside = cross(up_, level);
  const glm::dvec3 turned = std::cos(right) * level + std::sin(right) * aside;
  eye_ = target_ + distance * (std::cos(wanted) * turned + std::sin(wanted) * up_);
  moved_ = true;
}

void CameraPose::pan(double right, double down) {
  const Axes a = axes();
  const double pixelAtTarget = pixel_ * length(target_ - eye_) / topLeft_.z;
  const glm::dvec3 by = pixelAtTarget * (-right * a.right + down * a.up);
  eye_ += by;
  target_ += by;
  moved_ = true;
}

void CameraPose::dolly(double factor) {
  const double fileDistance = length(fileTarget_ - fileEye_);
  const double distance =
      std::clamp(factor * length(target_ - eye_), 1e-3 * fileDistance, 1e3 * fileDistance);
  eye_ = target_ + distance * normalize(eye_ - target_);
  moved_ = true;
}

FlatCamera CameraPose::camera() const {
  if (!moved_) return file_;
  const Axes a = axes();
  FlatCamera camera = file_;
  camera.eye = toFloat(eye_);
  camera.topLeft = toFloat(topLeft_.x * a.right + topLeft_.y * a.up + topLeft_.z * a.forward);
  camera.pixelRight = toFloat(pixel_ * a.right);
  camera.pixelDown = toFloat(-pixel_ * a.up);
  return camera;
}

}  // namespace pathmark::preview
