#include "preview/compare/error_curves.h"

#include "preview/same_camera.h"

#include <fmt/format.h>

#include <cmath>

namespace pathmark::preview {

namespace {

constexpr double kSpacing = 1.189207115002721;  // 2^(1/4)
constexpr std::size_t kMostBefore = 3;

bool positive(const std::optional<double>& error) {
  return error && std::isfinite(*error) && *error > 0.0;
}

std::string nameFor(const Picture& picture) {
  const std::string_view way = wayWords(picture.made);
  return fmt::format("{}, {}{}{}", picture.coursework, nameOf(picture.sampler),
                     way.empty() ? "" : ", ", way);
}

}  // namespace

bool ErrorCurves::same(const Subject& a, const Subject& b) {
  return a.scene == b.scene && a.warmUp == b.warmUp && a.paths == b.paths &&
         sameCamera(a.camera, b.camera);
}

void ErrorCurves::begin(const Picture& picture) {
  Subject subject{picture.scene->hash, picture.camera, picture.made.estimator == Estimator::kWarmUp,
                  picture.paths};
  if (subject_ && same(*subject_, subject)) {
    if (current_.points.size() > 1) before_.push_back(std::move(current_));
    if (before_.size() > kMostBefore) before_.erase(before_.begin());
  } else {
    before_.clear();
  }
  subject_ = std::move(subject);
  current_ = {picture.series, nameFor(picture), {}};
}

void ErrorCurves::forgetMeasured() {
  for (ErrorPoint& point : current_.points) point.measured.reset();
  for (ErrorCurve& curve : before_)
    for (ErrorPoint& point : curve.points) point.measured.reset();
}

void ErrorCurves::add(const Picture& picture, std::uint64_t reference, const ErrorPoint& point) {
  if (!subject_ || current_.series != picture.series) begin(picture);
  if (reference != reference_) forgetMeasured();
  reference_ = reference;
  ErrorPoint kept = point;
  if (!positive(kept.measured)) kept.measured.reset();
  if (!positive(kept.expected)) kept.expected.reset();
  if (!kept.measured && !kept.expected) return;
  std::vector<ErrorPoint>& points = current_.points;
  const std::size_t n = points.size();
  const bool near = n > 0 && !(kept.raysPerPixel > points[n - 1].raysPerPixel);
  const bool newestIsExtra =
      n > 1 && points[n - 1].raysPerPixel < kSpacing * points[n - 2].raysPerPixel;
  if (near || newestIsExtra)
    points.back() = kept;
  else
    points.push_back(kept);
}

std::optional<double> expectedError(const Image& image, const Image* reference) {
  if (image.variance.empty()) return std::nullopt;
  const std::vector<float>& values = reference != nullptr ? reference->rgb : image.rgb;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const auto value = static_cast<double>(values[i]);
    const double relative = static_cast<double>(image.variance[i]) / (value * value + 0.01);
    if (!std::isfinite(relative)) continue;
    sum += relative;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

}  // namespace pathmark::preview
