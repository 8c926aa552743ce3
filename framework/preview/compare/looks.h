// Looks: when a picture that gets better is judged, so that the whole series has one rate of false
// alarms.
//
// A test that is repeated after every pass would call noise a difference sooner or later. Therefore
// the k-th look has a rate of its own, alpha / (k (k + 1)), which add up to alpha over all looks
// that there may ever be: an alpha spending (Lan & DeMets, "Discrete Sequential Boundaries for
// Clinical Trials", Biometrika 70, 1983) by Bonferroni's inequality. Looks are taken when the rays
// have doubled. The price is small: with alpha = 0.001, after twenty looks, at a million times the
// rays of the first, a mean of the image must be 5.1 standard errors off instead of 3.8, and one of
// 4096 tiles 6.5 instead of 5.5.
#pragma once

namespace pathmark::preview {

class Looks {
 public:
  explicit Looks(double alpha) : alpha_(alpha) {}

  bool due(double raysPerPixel) const { return raysPerPixel >= nextAt_; }

  // Of the k-th look, k = 1, 2, ...
  double alphaOf(int k) const { return alpha_ / (static_cast<double>(k) * (k + 1.0)); }

  void take(double raysPerPixel) {
    ++taken_;
    nextAt_ = 2.0 * raysPerPixel;
  }

  int taken() const { return taken_; }
  double nextAt() const { return nextAt_; }  // rays per pixel

 private:
  double alpha_;
  int taken_ = 0;
  double nextAt_ = 0.0;
};

}  // namespace pathmark::preview
