#include "checks/lit_room.h"

#include "checks/exact.h"
#include "checks/points.h"
#include "checks/standins/lopsided.h"

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

constexpr double kPiD = std::numbers::pi;

struct Patch {
  glm::dvec3 y, n;
  double area, density;
  bool open;
};

using Gauss = boost::math::quadrature::gauss<double, 20>;

// visit(x, weight) for the nodes of [0,1].
template <typename Visit>
void forNodes(const Visit& visit) {
  for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
    for (const double side : {-1.0, 1.0})
      visit(0.5 + 0.5 * side * Gauss::abscissa()[i], 0.5 * Gauss::weights()[i]);
}

glm::dvec3 normalOf(const std::vector<glm::dvec3>& v) {
  return glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
}

void addPolygon(std::vector<Patch>& patches, const std::vector<glm::dvec3>& v, double density,
                bool open) {
  const glm::dvec3 n = normalOf(v);
  for (std::size_t k = 2; k < v.size(); ++k) {
    const glm::dvec3 a = v[0], ab = v[k - 1] - a, bc = v[k] - v[k - 1];
    const double twice = glm::length(glm::cross(ab, bc));
    forNodes([&](double x, double wx) {
      forNodes([&](double t, double wt) {
        patches.push_back({a + x * (ab + t * bc), n, twice * x * wx * wt, density, open});
      });
    });
  }
}

// The cap that the receiver sees.
void addSphere(std::vector<Patch>& patches, const RoomLight& light, const glm::dvec3& x) {
  constexpr int kAzimuths = 32;
  const glm::dvec3 c(light.centre);
  const double r = light.radius, d = glm::length(x - c), sine = r / d;
  const double edge = std::acos(sine), cone = 1.0 - std::sqrt((1.0 - sine) * (1.0 + sine));
  const DoubleFrame frame(x - c);
  forNodes([&](double at, double weight) {
    const double alpha = edge * at;
    for (int k = 0; k < kAzimuths; ++k) {
      const glm::dvec3 n = frame.direction(std::cos(alpha), 2.0 * kPiD * (k + 0.5) / kAzimuths);
      const glm::dvec3 y = c + r * n, w = x - y;
      const double cosY = glm::dot(n, w) / glm::length(w);
      patches.push_back({y, n, weight * edge * std::sin(alpha) * r * r * 2.0 * kPiD / kAzimuths,
                         cosY / (2.0 * kPiD * glm::dot(w, w) * cone), true});
    }
  });
}

std::vector<Patch> patchesOf(const RoomLight& light, const glm::dvec3& x) {
  std::vector<Patch> patches;
  if (light.vertices.empty()) {
    addSphere(patches, light, x);
    return patches;
  }
  const double density = 1.0 / light.area();
  if (light.open > 0.0) addPolygon(patches, light.openOutline(), density, true);
  if (light.open < 1.0) {
    const std::vector<glm::dvec3> open = light.openOutline();
    addPolygon(patches,
               {open[1], glm::dvec3(light.vertices[1]), glm::dvec3(light.vertices[2]), open[2]},
               density, false);
  }
  return patches;
}

}  // namespace

double RoomLight::area() const {
  double area = 0.0;
  const glm::dvec3 a(vertices[0]);
  for (std::size_t k = 2; k < vertices.size(); ++k)
    area +=
        0.5 * glm::length(glm::cross(glm::dvec3(vertices[k - 1]) - a, glm::dvec3(vertices[k]) - a));
  return area;
}

std::vector<glm::dvec3> RoomLight::openOutline() const {
  std::vector<glm::dvec3> all;
  for (const Point& v : vertices) all.emplace_back(v);
  if (open == 1.0) return all;
  const glm::dvec3 v1 = open * (all[1] - all[0]);
  return {all[0], all[0] + v1, all[3] + v1, all[3]};
}

std::string RoomLight::text() const {
  std::string shape;
  for (const Point& v : vertices)
    shape += fmt::format("{}{}", shape.empty() ? "polygon " : ", ", checks::text(v));
  if (vertices.empty())
    shape = fmt::format("{}sphere, centre {}, r = {:.6g}", inward ? "inward " : "",
                        checks::text(centre), radius);
  return fmt::format("{}, Le = {}", shape, checks::text(emission));
}

std::vector<Point> Receiver::square() const {
  constexpr double kHalf = 0.25;
  const DoubleFrame frame{glm::dvec3(n)};
  const auto corner = [&](double a, double b) {
    return Point(glm::dvec3(p) + kHalf * (a * frame.u + b * frame.v));
  };
  // v = n x u, so that u, v runs counter-clockwise seen from n.
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

std::string Receiver::text() const {
  std::string result = fmt::format("x = {}, n = {}, wo = {}, BRDF {}, Kd = {}", checks::text(p),
                                   checks::text(n), checks::text(wo),
                                   lopsided ? "Kd/pi (0.2 + 0.5 cos(wo)^2 + 0.4 cos(wi))" : "Kd/pi",
                                   checks::text(kReceiverKd));
  if (emits())
    result += fmt::format("; the surface at x is itself a light, Le = {}", checks::text(emission));
  return result;
}

FlatScene LitRoom::flat() const {
  SceneBuilder builder;
  for (const RoomLight& light : lights) {
    const bool scatters = receiver.onLight && &light == &lights.front();
    const Surface surface{.kd = scatters ? kReceiverKd : Colour(0.0f),
                          .emission = light.emission,
                          .frontOnly = light.frontOnly};
    if (light.vertices.empty())
      builder.sphere(surface, light.centre, light.radius, light.inward);
    else
      builder.polygon(surface, light.vertices);
  }
  for (const auto& screen : screens) builder.polygon({.kd = Colour(0.5f)}, screen);
  const Surface ofReceiver{.kd = kReceiverKd,
                           .emission = receiver.emission,
                           .ks = Colour(receiver.lopsided ? 0.05f : 0.0f),
                           .exponent = 1.0f};
  if (receiver.emits()) builder.polygon(ofReceiver, receiver.square());
  builder.material(ofReceiver);
  return builder.camera({0, 0, 3}, {0, 0, 0}, 0.8, 8, 8).flat();
}

float LitRoom::rounding() const {
  float largest = 0.0f;
  const auto see = [&](const Point& p) {
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(p[axis]));
  };
  see(receiver.p);
  for (const RoomLight& light : lights) {
    for (const Point& v : light.vertices) see(v);
    if (light.vertices.empty()) see(light.centre + light.radius);
  }
  return 4.0f * 0x1p-24f * largest;
}

std::size_t LitRoom::lightCount() const { return lights.size() + (receiver.emits() ? 1 : 0); }

std::string LitRoom::text() const {
  std::string result = receiver.text();
  for (std::size_t k = 0; k < lights.size(); ++k)
    result += fmt::format("\nlight{}: {}", lights.size() > 1 ? fmt::format(" {}", k + 1) : "",
                          lights[k].text());
  for (const auto& screen : screens) {
    result += "\nscreen:";
    for (const Point& v : screen) result += fmt::format(" {}", checks::text(v));
  }
  return result;
}

double rightKernel(const LightTerms& t) {
  return t.open ? t.brdf * t.cosX * t.cosY / (t.distance * t.distance) : 0.0;
}

glm::dvec3 radianceBy(Kernel kernel, const LitRoom& room) {
  const glm::dvec3 x(room.receiver.p), n(room.receiver.n), wo(room.receiver.wo);
  const double cosO = glm::dot(n, wo);
  glm::dvec3 sum(0.0);
  for (std::size_t k = 0; k < room.lights.size(); ++k) {
    const RoomLight& light = room.lights[k];
    double integral = 0.0;
    for (const Patch& patch : patchesOf(light, x)) {
      const glm::dvec3 w = patch.y - x;
      LightTerms t{};
      t.distance = glm::length(w);
      t.cosX = glm::dot(n, w) / t.distance;
      t.cosY = -glm::dot(patch.n, w) / t.distance;
      if (t.cosX <= 0.0 || t.cosY <= 0.0) continue;
      t.density = patch.density;
      t.brdf = room.receiver.lopsided ? lopsided::shape(cosO, t.cosX) : 1.0;
      t.exchanged = room.receiver.lopsided ? lopsided::shape(t.cosX, cosO) : 1.0;
      t.stretched = room.receiver.lopsided ? lopsided::shape(cosO, t.cosX * t.distance) : 1.0;
      t.open = patch.open;
      t.openShare = light.open;
      t.light = k;
      t.lightCount = room.lightCount();
      integral += kernel(t) * patch.area;
    }
    sum += integral * glm::dvec3(light.emission);
  }
  return sum * glm::dvec3(kReceiverKd) / kPiD;
}

bool whollyLit(const LitRoom& room, double least) {
  const glm::dvec3 x(room.receiver.p), n(room.receiver.n);
  return std::all_of(room.lights.begin(), room.lights.end(), [&](const RoomLight& light) {
    if (light.vertices.empty()) {
      const glm::dvec3 w = glm::dvec3(light.centre) - x;
      return glm::dot(n, w) - double{light.radius} >= least * glm::length(w);
    }
    const std::vector<glm::dvec3> v = RoomLight{.vertices = light.vertices}.openOutline();
    return std::all_of(v.begin(), v.end(), [&](const glm::dvec3& y) {
      const double distance = glm::length(y - x);
      return glm::dot(n, y - x) >= least * distance &&
             glm::dot(normalOf(v), x - y) >= least * distance;
    });
  });
}

}  // namespace pathmark::checks
