// What a worker that records has seen of the paths of a pixel.
//
//   PathEvent       one call of the framework or of the coursework, with what came of it
//   PathEventKind   which
//
// The events of a path are in the order in which they happened, from its kPath to its kRadiance;
// paths follow one another.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pathmark {

// In brackets, the fields that are set.
enum class PathEventKind : std::uint32_t {
  kPath = 1,     // a path begins: camera ray with origin [a] and direction [b]
  kHit,          // a ray with origin [d] has met a surface: point [a], normal [b], radiance that
                 // its front emits [c], material [integer], or -1 of a triangle of part 0
  kMiss,         // a ray with origin [a] and direction [b] leaves the scene, or is not followed
                 // since no light is let through along it [flag]
  kDirectBegin,  // directLighting has been called for the point [a] and wo [b]
  kDirectEnd,    // ... and has returned the radiance [a]
  kLightSample,  // a point [a] of a light, normal [b], density [x] per unit area, emission [c]
  kShadowRay,    // from [a] to the point [b] of a light: visible [flag]; what is in the way [c],
                 // or nothing is, and no light is let through there [integer: 1]
  kReflection,   // for wo [a] and normal [c], the direction [b] has been drawn with density [x]
  kBrdf,         // for wo [a] and wi [b], the BRDF has the value [c]
  kPdf,          // for wo [a] and wi [b], the density is [x]
  kRoulette,     // for throughput [a], depth [integer] and the number [x]: survives [flag] with
                 // weight [y]
  kRadiance,     // the path has ended, and has returned [a]; [integer] events of it were too many
  kLightPdf,  // for lighting the point [a], the point [b] of a light has the density [x] per unit
              // area
};

struct PathEvent {
  PathEventKind kind = PathEventKind::kPath;
  std::int32_t integer = 0;
  std::uint32_t flag = 0;  // 0 or 1
  float a[3] = {}, b[3] = {}, c[3] = {}, d[3] = {};
  float x = 0.0f, y = 0.0f;
};

// What is more than that is counted and not recorded.
inline constexpr std::size_t kMostEventsOfAPath = 4096;
inline constexpr std::size_t kMostPathEvents = std::size_t{1} << 18;  // of a request

}  // namespace pathmark
