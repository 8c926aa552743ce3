// LopsidedFurnace: the inside of a sphere that emits everywhere, and reflects by the BRDF of
// standins/lopsided.h.
//
// A ray that leaves the wall at some cosine to the normal meets it again at the same cosine, so
// that the radiance depends on that cosine and the number of bounces only:
//
//   L_B(c) = E + integral of f(c, c') c' L_(B-1)(c') over the directions,    L_0 = E
//
// The integrals are those of polynomials in c'. What a path tracer with some mistake gives instead
// is the same sum with one of its operators exchanged.
#pragma once

#include "worker/contract.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace pathmark::checks {

struct LopsidedFurnace {
  double emission = 1.0, kd = 0.5;  // of one channel

  double radiance(double cosine, int bounces) const;
};

// A mistake in tracePath with what it makes of the furnace. tracePathMIS finds all light of the
// furnace by the rays of the path, so that the same radiance may have another cause there.
struct FurnaceMistake {
  std::string words;
  std::function<double(const LopsidedFurnace&, double cosine, int bounces)> radiance;
  std::string wordsForMis{};  // empty: the same words

  const std::string& wordsFor(CourseworkFunction pathTracer) const;
};

const std::vector<FurnaceMistake>& furnaceMistakes();

// Then there is a sample always (standins/lopsided.h).
inline constexpr const char* kNumberAgain =
    "reflection gets s or t again as u, which must be a random number of its own";

// The same furnace with a channel that reflects nothing: there the stand-in for the roulette gives
// another weight at each depth (standins/unfair_roulette.h). `first` is the depth it is told at
// hit 1; `updated`: whether it is shown the throughput after its update.
double unfairRadiance(const LopsidedFurnace& furnace, double cosine, int bounces, int first = 1,
                      bool updated = true);

// The same for tracePathMIS, which finds all light of the furnace by its rays. Of which hits it
// finds that light before their roulette is free: of none, of the last one, whose ray goes no
// further, or of all. `factor`: the weight over 1/q that the roulette gives at a hit.
enum class LightBefore { kNone, kLast, kAll };

double unfairMisRadiance(const LopsidedFurnace& furnace, double cosine, int bounces,
                         LightBefore before, const std::function<double(int hit)>& factor);

}  // namespace pathmark::checks
