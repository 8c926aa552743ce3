// The words of the coursework: points, directions, colours, rays, and what the samplers return.
//
//   Point, Vector, Colour   three floats (GLM); Ray; constants. `Colour c;` is not 0, it has no
//                           value yet: write `Colour c(0.0f);`
//   LightSample             a point on a light, density per unit area
//   DirectionSample         a direction, density per unit solid angle
//   Roulette                whether a path goes on, and with what weight
//
// One convention for all of them: directions are unit length; `wo` and `wi` both point away from
// the surface; the density 0 means "no sample", and its other fields are then not to be used.
#pragma once

#include <glm/glm.hpp>

namespace pathmark {

using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;
using glm::uvec2;
using glm::vec2;
using glm::vec3;

using Point = glm::vec3;
using Vector = glm::vec3;
using Colour = glm::vec3;  // linear RGB: radiance (W m^-2 sr^-1), reflectance or throughput

inline constexpr float kPi = 3.14159265358979323846f;
inline constexpr float kInvPi = 0.31830988618379067154f;

// The half-line origin + t * direction, t > 0. Copied vector by vector: as one block of memory it
// would be read in other pieces than those it has just been written in, and processors wait then.
struct Ray {
  Point origin{0.0f};
  Vector direction{0.0f, 0.0f, 1.0f};  // unit length

  Ray() = default;
  Ray(const Point& from, const Vector& towards) : origin(from), direction(towards) {}
  Ray(const Ray& other) : origin(other.origin), direction(other.direction) {}
  Ray& operator=(const Ray& other) {
    origin = other.origin;
    direction = other.direction;
    return *this;
  }
};

struct LightSample {
  Point p{0.0f};               // on the light
  Vector n{0.0f, 1.0f, 0.0f};  // unit normal of the light at p
  float pdf = 0.0f;            // per unit area
};

struct DirectionSample {
  Vector wi{0.0f, 1.0f, 0.0f};  // away from the surface
  float pdf = 0.0f;             // per unit solid angle

  // Has it returned in memory: in registers, one would be put together from wi and pdf by way of
  // memory, which is slower for the same reason as with Ray.
  ~DirectionSample() {}
};

struct Roulette {
  bool survives = false;
  float weight = 0.0f;  // factor on the throughput of a path that survives: 1/q
};

}  // namespace pathmark
