#include "checks/part8_rooms.h"

#include "checks/double_frame.h"
#include "checks/exact.h"
#include "checks/random_rooms.h"
#include "checks/standins/beam.h"
#include "checks/standins/leaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace pathmark::checks::path {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

Colour without(Colour colour, Black black) {
  (black == Black::kRed ? colour.x : colour.y) = 0.0f;
  return colour;
}

// `width` along an axis of the plane that is turned by `turn`, `height` across.
RoomLight rectangle(const glm::dvec3& centre, const glm::dvec3& normal, double width, double height,
                    double turn, const Colour& emission) {
  const DoubleFrame frame(normal);
  const glm::dvec3 u = std::cos(turn) * frame.u + std::sin(turn) * frame.v,
                   v = glm::cross(frame.n, u);
  const glm::dvec3 corner = centre - 0.5 * width * u - 0.5 * height * v;
  RoomLight light;
  light.emission = emission;
  for (const glm::dvec3& p :
       {corner, corner + width * u, corner + width * u + height * v, corner + height * v})
    light.vertices.emplace_back(p);
  return light;
}

}  // namespace

FlatScene sceneOf(const Case& c) {
  const LitRoom& room = c.room;
  SceneBuilder builder;
  for (const RoomLight& light : room.lights)
    builder.polygon({.emission = light.emission}, light.vertices);
  for (const auto& screen : room.screens) builder.polygon({}, screen);
  const DoubleFrame frame{glm::dvec3(room.receiver.n)};
  const double side = 1e-3 * c.size;
  const glm::dvec3 corner = glm::dvec3(room.receiver.p) - 0.5 * side * (frame.u + frame.v);
  std::vector<Point> vertices{Point(corner), Point(corner + side * frame.u),
                              Point(corner + side * (frame.u + frame.v)),
                              Point(corner + side * frame.v)};
  if (glm::dot(glm::cross(frame.u, frame.v), frame.n) < 0.0)
    std::reverse(vertices.begin(), vertices.end());
  const float exponent = room.receiver.lopsided ? 1.0f : leaning::kExponent;
  builder.polygon({.kd = without(kReceiverKd, c.black), .ks = Colour(0.05f), .exponent = exponent},
                  vertices);
  return builder.flat();
}

LitRoom below(std::vector<RoomLight> lights, Random& random) {
  LitRoom room{std::move(lights), {}, {}};
  room.receiver = {{0, 0, 0}, {0, 1, 0}, {0, 1, 0}, true};
  room.receiver.wo = atCosine({0, 1, 0}, random.between(0.3, 0.9), random.between(0.0, kTwoPi));
  return room;
}

RoomLight above(Random& random, double height, double width, double depth) {
  const double aside = 0.3 * height;
  return rectangle({random.between(-aside, aside), height, random.between(-aside, aside)},
                   {0, -1, 0}, width, depth, random.between(0.0, kTwoPi), randomEmission(random));
}

std::vector<Case> directLightCases(std::uint64_t seed) {
  Random random(seed);
  std::vector<Case> all;
  all.push_back({"one light", below({above(random, 1.0, 2.0, 3.0)}, random)});
  all.push_back({"a light that is near", below({above(random, 0.3, 2.0, 2.0)}, random), 1.0, 2048});
  all.push_back({"a light that is far", below({above(random, 2.0, 0.5, 0.3)}, random)});
  for (const int count : {2, 3, 5}) {
    const double largest = 1.5 / count;  // none hides another
    LitRoom room = below({}, random);
    for (int k = 0; k < count; ++k) {
      const double azimuth = kTwoPi * (k + random.between(0.4, 0.6)) / count;
      const glm::dvec3 towards(0.7 * std::cos(azimuth), 0.7, 0.7 * std::sin(azimuth));
      room.lights.push_back(rectangle(
          random.between(1.0, 1.3) * towards, -towards, random.between(0.5, 1.0) * largest,
          random.between(0.5, 1.0) * largest, 0.0, randomEmission(random)));
    }
    all.push_back({fmt::format("{} lights", count), room, 1.0, 1024});
  }
  // A screen halfway hides all of the light but the open share.
  LitRoom hidden = below({above(random, 1.0, 2.0, 2.0)}, random);
  RoomLight& light = hidden.lights[0];
  light.open = random.between(0.4, 0.6);
  const glm::dvec3 p0(light.vertices[0]), v1 = glm::dvec3(light.vertices[1]) - p0,
                                          v2 = glm::dvec3(light.vertices[3]) - p0;
  const auto halfway = [&](double a, double b) { return Point(0.5 * (p0 + a * v1 + b * v2)); };
  hidden.screens.push_back(
      {halfway(light.open, -0.2), halfway(1.2, -0.2), halfway(1.2, 1.2), halfway(light.open, 1.2)});
  all.push_back({"a light half hidden", hidden, 1.0, 1024});
  // What is black in some channel is not black.
  for (const Colour& lit : {Colour(1, 0, 0), Colour(0, 1, 0), Colour(0, 0, 1), Colour(1e-3f)}) {
    LitRoom room = below({above(random, 1.0, 2.0, 2.0)}, random);
    room.lights[0].emission = lit * room.lights[0].emission;
    all.push_back({fmt::format("a light of the emission {}", text(room.lights[0].emission)), room,
                   1.0, 512, lit.x == 1.0f ? Black::kGreen : Black::kRed, true});
  }
  // On the side away from wo, where the leaning BRDF draws most of its directions.
  LitRoom glossy = below({}, random);
  glossy.receiver.lopsided = false;
  glossy.receiver.wo = atCosine({0, 1, 0}, random.between(0.4, 0.7), random.between(0.0, kTwoPi));
  const glm::dvec3 away =
      glm::normalize(glm::dvec3(-glossy.receiver.wo.x, 0.0, -glossy.receiver.wo.z));
  const glm::dvec3 towards = glm::normalize(away + glm::dvec3(0.0, 0.8, 0.0));
  glossy.lights.push_back(
      rectangle(0.9 * towards, -towards, 0.9, 0.9, 0.0, randomEmission(random)));
  all.push_back({"a surface whose directions depend on wo", glossy, 1.0, 1024});
  for (const double size : {1e-3, 1e4}) {
    LitRoom room = below({above(random, 1.0, 2.0, 2.0)}, random);
    for (Point& v : room.lights[0].vertices) v *= static_cast<float>(size);
    all.push_back({fmt::format("a light {:g} times as large", size), room, size});
  }
  return all;
}

namespace {

const Colour kWallAlbedo(0.7f, 0.0f, 0.5f), kConeKd(0.6f, 0.0f, 0.8f);

}  // namespace

ConeInBox::ConeInBox(Random& random)
    : length_(static_cast<float>(random.between(0.5, 2.0))), emission_(randomEmission(random)) {
  wo_ = atCosine({0, 1, 0}, random.between(0.3, 0.9), random.between(0.0, kTwoPi));
}

FlatScene ConeInBox::scene() const {
  // The walls' directions depend on wo, which is another one at each hit.
  const Surface wall{.kd = kWallAlbedo,
                     .emission = emission_,
                     .ks = Colour(0.05f),
                     .exponent = leaning::kExponent};
  const Vector x(length_, 0, 0), y(0, length_, 0), z(0, 0, length_);
  SceneBuilder builder;
  builder.parallelogram(wall, Point(0), x, y)
      .parallelogram(wall, Point(z), y, x)
      .parallelogram(wall, Point(0), z, x)
      .parallelogram(wall, Point(y), x, z)
      .parallelogram(wall, Point(0), y, z)
      .parallelogram(wall, Point(x), z, y);
  const float side = 1e-3f;  // of the box
  builder.parallelogram({.kd = kConeKd, .ks = Colour(0.05f), .exponent = beam::kLeastExponent},
                        Point(0.5f * (x + y + z)) - 0.5f * side * (x + z), side * z, side * x);
  return builder.flat();
}

PathRay ConeInBox::ray(int bounces) const {
  return {{Point(0.5f * length_) + 1e-2f * length_ * wo_, -wo_}, bounces};
}

glm::dvec3 ConeInBox::radiance(int bounces) const {
  glm::dvec3 sum(0.0);
  for (const int channel : kLit) {
    double share = 1.0;
    for (int bounce = 1; bounce <= bounces; ++bounce, share *= double{kWallAlbedo[channel]})
      sum[channel] += share;
    sum[channel] *= double{kConeKd[channel]} * double{emission_[channel]};
  }
  return sum;
}

std::string ConeInBox::text() const {
  return fmt::format(
      "in a box of which all walls emit {} and reflect {}, looking at a small surface that "
      "reflects into a narrow cone only",
      checks::text(emission_), checks::text(kWallAlbedo));
}

}  // namespace pathmark::checks::path
