// How the error of a picture falls while rays are added, beside that of the pictures before it.
//
//   ErrorPoint     the error at one time
//   ErrorCurve     of one series
//   ErrorCurves    of the series in work and some before it
//   expectedError  the error that an image's own variances tell
#pragma once

#include "preview/picture.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::preview {

// Relative mean squared errors: means over pixels and channels of (x - ref)^2 / (ref^2 + 0.01).
struct ErrorPoint {
  double raysPerPixel = 0.0;
  double seconds = 0.0;              // of rendering
  std::optional<double> measured{};  // against the reference, whose own noise it includes
  std::optional<double> expected{};  // from the picture's own variance
};

struct ErrorCurve {
  std::uint64_t series = 0;
  std::string name;
  std::vector<ErrorPoint> points;  // of rising rays
};

class ErrorCurves {
 public:
  // A picture's point. Points are kept whose rays are a quarter of a doubling apart, and the newest
  // one: four for each doubling, however long a series lasts. Curves of another scene, size or
  // camera, and those of the warm-up beside others, are forgotten; measured errors also when the
  // reference is another.
  void add(const Picture& picture, std::uint64_t reference, const ErrorPoint& point);

  const ErrorCurve& current() const { return current_; }
  const std::vector<ErrorCurve>& before() const { return before_; }  // at most three, oldest first

 private:
  struct Subject {
    std::string scene;
    FlatCamera camera;
    bool warmUp = false;
    std::string paths;  // light path expression
  };

  static bool same(const Subject& a, const Subject& b);
  void begin(const Picture& picture);
  void forgetMeasured();

  std::optional<Subject> subject_;
  std::uint64_t reference_ = 0;
  ErrorCurve current_;
  std::vector<ErrorCurve> before_;
};

// The mean of variance / (value^2 + 0.01), with the values of `reference` if there is one, over
// those pixels whose variance is known; nothing if there are none. Noise alone makes the measured
// error of a picture as large on average.
std::optional<double> expectedError(const Image& image, const Image* reference);

}  // namespace pathmark::preview
