// The paths of a pixel, as they happened.
//
//   TracedPath    one path: its camera ray, its vertices, what it returned
//   PathVertex    where it met a surface, the light there, and how it went on
//   ShadowRay     a question to a light
//   readPaths     from a worker's events to paths
//
// Numbers are what the coursework has given, and may be NaN or infinite.
#pragma once

#include "worker/path_events.h"

#include <pathmark/types.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pathmark::preview {

enum class Visibility {
  kNotAsked,
  kVisible,
  kBlocked,
  kLeftOut,  // by the light path expression
};

// Towards a point of a light that was chosen for lighting a vertex.
struct ShadowRay {
  Point to{0.0f};
  Vector n{0.0f};    // of the light
  float pdf = 0.0f;  // per unit area
  Colour emission{0.0f};
  Visibility visibility = Visibility::kNotAsked;
  Point blocker{0.0f};        // what stands in the way
  std::optional<Colour> f{};  // the BRDF towards it, if that was asked for

  // With which reflection() would have gone there, per unit solid angle, if that was asked for.
  std::optional<float> brdfPdf{};
};

// The direction in which the path goes on.
struct Scattering {
  Vector wi{0.0f};
  float pdf = 0.0f;           // claimed by reflection(), per unit solid angle
  float cosine = 0.0f;        // between wi and the normal
  std::optional<Colour> f{};  // if brdf() was called for it
};

struct RouletteCall {
  Colour throughput{0.0f};  // as the coursework passed it
  int depth = 0;
  float u = 0.0f;
  bool survives = false;
  float weight = 0.0f;
};

struct PathVertex {
  Point origin{0.0f};  // of the ray that met it
  Point p{0.0f};
  Vector n{0.0f};
  Colour emission{0.0f};           // of the front
  int material = -1;               // in the scene's list; -1 in part 0
  std::optional<Colour> direct{};  // what directLighting returned
  std::vector<ShadowRay> shadowRays{};
  std::optional<Scattering> next{};
  std::optional<RouletteCall> roulette{};

  // With which the vertex before would have sampled this point of a light, per unit area, if
  // that was asked for.
  std::optional<float> lightPdf{};

  // Seen from the side that emits. Towards the origin of the ray, which is not on the surface.
  bool seenFromFront() const { return dot(origin - p, n) > 0.0f; }
};

// Without that there is no light from there, whatever lies between.
bool faceEachOther(const PathVertex& vertex, const ShadowRay& ray);

struct TracedPath {
  int number = 0;  // of the pixel's rays, from 0
  Ray camera;
  std::vector<PathVertex> vertices{};
  std::optional<Ray> escape{};  // the last ray, if it left the scene
  bool leftOut = false;         // it was not followed, by the light path expression
  Colour radiance{0.0f};        // returned
  int dropped = 0;              // events for which there was no room
};

// The events are those of whole paths.
std::vector<TracedPath> readPaths(std::span<const PathEvent> events);

bool isFinite(const vec3& v);
double luminance(const Colour& c);  // Rec. 709

}  // namespace pathmark::preview
