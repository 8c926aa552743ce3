// Stands in for bonus part 9 where another part is checked, and where a coursework has no file of
// it: says that it is not written.
#include <pathmark/coursework.h>

namespace pathmark {

LightSample Polygon::SphericalTriangleSampling(const Point&, float, float) const {
  PATHMARK_UNIMPLEMENTED("part9_solid_angle.cpp", "Polygon::SphericalTriangleSampling");
  return {};
}

float Polygon::SphericalTrianglePdf(const Point&, const Point&) const {
  PATHMARK_UNIMPLEMENTED("part9_solid_angle.cpp", "Polygon::SphericalTrianglePdf");
  return 0.0f;
}

LightSample Polygon::SphericalRectangleSampling(const Point&, float, float) const {
  PATHMARK_UNIMPLEMENTED("part9_solid_angle.cpp", "Polygon::SphericalRectangleSampling");
  return {};
}

float Polygon::SphericalRectanglePdf(const Point&, const Point&) const {
  PATHMARK_UNIMPLEMENTED("part9_solid_angle.cpp", "Polygon::SphericalRectanglePdf");
  return 0.0f;
}

}  // namespace pathmark
