// Lights, screens and a receiver, and the radiance that must leave it.
//
//   RoomLight, Receiver, LitRoom   what is there
//   Kernel                         what is integrated over the lights: the right thing, and others
//   radianceBy                     the integral, by quadrature, of lights wholly above the horizon
//
// The receiver's BRDF is Kd/pi, or the lopsided one that stands in for Phong's.
#pragma once

#include "checks/scenes.h"

#include <functional>
#include <string>
#include <vector>

namespace pathmark::checks {

// A polygon, convex and counter-clockwise seen from the front, or a sphere.
struct RoomLight {
  std::vector<Point> vertices{};
  Point centre{0.0f};
  float radius = 0.0f;
  bool inward = false;
  Colour emission{0.0f};
  bool frontOnly = false;

  // Of a parallelogram: the share of it, from p0 along p1 - p0, that the screens leave open.
  double open = 1.0;

  double area() const;  // of a polygon
  std::vector<glm::dvec3> openOutline() const;
  std::string text() const;
};

struct Receiver {
  Point p;
  Vector n, wo;
  bool lopsided = false;

  // Where it is not black the receiver is a small square of the scene, and its last light: one that
  // sends nothing to itself.
  Colour emission{0.0f};

  // x lies on the room's first light, which then scatters too.
  bool onLight = false;

  bool emits() const { return emission != Colour(0.0f); }
  std::vector<Point> square() const;
  std::string text() const;
};

inline const Colour kReceiverKd(0.9f, 0.5f, 0.2f);

struct LitRoom {
  std::vector<RoomLight> lights;
  std::vector<std::vector<Point>> screens;
  Receiver receiver;

  FlatScene flat() const;          // the receiver's material is the last one
  float rounding() const;          // for Hit::error
  std::size_t lightCount() const;  // with the receiver, if it emits
  std::string text() const;
};

// At a point of a light that is seen from the receiver.
struct LightTerms {
  double cosX, cosY, distance;
  double density;     // of the contract's sample there, per unit area
  double brdf;        // f pi / Kd,
  double exchanged;   // the same with wo and wi exchanged,
  double stretched;   // and with a wi that is as long as the distance
  bool open;          // not behind a screen
  double openShare;   // of its light
  std::size_t light;  // its number
  std::size_t lightCount;
};

// Per unit area of the light; times Kd/pi and the emission.
using Kernel = double (*)(const LightTerms&);

double rightKernel(const LightTerms& terms);

glm::dvec3 radianceBy(Kernel kernel, const LitRoom& room);

// Whether the lights lie above the receiver's horizon, by a cosine of at least `least`, and the
// receiver in front of all of them.
bool whollyLit(const LitRoom& room, double least);

}  // namespace pathmark::checks
