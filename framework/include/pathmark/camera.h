// SimpleCamera: a pinhole camera with a rectangular film.
//
//   eye, topLeft, pixelRight, pixelDown   where the film is             (given)
//   StratifiedRandomRay                   a jittered ray of a pixel     (part 1)
#pragma once

#include <pathmark/types.h>

namespace pathmark {

class SimpleCamera {
 public:
  SimpleCamera(const Point& eye, const Vector& topLeft, const Vector& pixelRight,
               const Vector& pixelDown, int width, int height)
      : eye_(eye),
        topLeft_(topLeft),
        pixelRight_(pixelRight),
        pixelDown_(pixelDown),
        width_(width),
        height_(height) {}

  // The film point (x, y), in pixels from the top left corner of the image, x to the right and
  // y downwards, is seen from the eye along the vector topLeft + x pixelRight + y pixelDown:
  // lengths of the scene, at no particular distance.
  const Point& eye() const { return eye_; }
  const Vector& topLeft() const { return topLeft_; }
  const Vector& pixelRight() const { return pixelRight_; }
  const Vector& pixelDown() const { return pixelDown_; }

  int width() const { return width_; }
  int height() const { return height_; }

  // Part 1. The ray from the eye through the film point (i + (k + s)/n, j + (l + t)/n); unit
  // direction. Pixel column i, row j, 0 <= i < width(), 0 <= j < height(); stratum column k, row l
  // of n x n; 0 <= k, l < n, n >= 1; s, t in [0,1).
  Ray StratifiedRandomRay(int i, int j, int k, int l, int n, float s, float t) const;

 private:
  Point eye_;
  Vector topLeft_, pixelRight_, pixelDown_;
  int width_, height_;
};

}  // namespace pathmark
