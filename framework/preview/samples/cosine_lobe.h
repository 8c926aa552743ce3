// CosineLobe: directions with the density (m + 1)/(2 pi) cos^m(alpha) around an axis, alpha < 90
// degrees. m = 1 is the cosine lobe of a diffuse surface, m = 0 the uniform hemisphere.
//
//   massWithin      of the cone around the axis
//   massWithinOf    of a cone around another axis
//   massOfSector    of a ring around another axis, between two azimuths; for m = 1
#pragma once

namespace pathmark::preview {

struct CosineLobe {
  double m = 1.0;

  double density(double cosAlpha) const;  // per unit solid angle
  double massWithin(double alpha) const;
  double angleWith(double mass) const;  // the inverse

  // Of the cone of directions within `angle` of an axis at the angle `tilt` to the lobe's.
  double massWithinOf(double tilt, double angle) const;
};

// A ring of directions around an axis, between two angles, and two azimuths.
struct RingSector {
  double fromAngle, toAngle;
  double fromAzimuth, toAzimuth;
};

// What the cosine lobe (m = 1) has there, its axis at the angle `tilt`, below 90 degrees, from the
// ring's and at azimuth 0.
double diffuseMass(double tilt, const RingSector& sector);

}  // namespace pathmark::preview
