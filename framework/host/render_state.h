// What a render is to make, and what of it has been made.
//
//   RenderSettings   the image
//   RenderState      as of the last whole step: a render goes on from here to the same bits
//   jobOf            what all jobs of a replicate have in common
//   nextJob          what to ask of the worker next
//   advance          what has been made when it is done
#pragma once

#include "film/replicates.h"
#include "render/render_job.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pathmark {

struct RenderSettings {
  int width = 1, height = 1;
  std::uint64_t raysPerPixel = 64;  // a multiple of replicates
  std::uint32_t replicates = 1;     // independent films that the rays are made in
  std::uint32_t threads = 1;
  std::uint64_t seed = 0;
  SamplerKind sampler = SamplerKind::kSobol;
  Estimator estimator = Estimator::kPath;
  PathSharing sharing{};
  std::string paths{};                 // expression of the light that is let through; empty: all
  PathAutomaton automaton{};           // the same for the worker
  std::optional<FlatCamera> camera{};  // instead of the scene's, of the same size

  std::uint64_t raysPerReplicate() const { return raysPerPixel / replicates; }
  std::uint32_t raysPerPass() const;
  std::uint64_t pixels() const;
};

struct RenderState {
  std::uint64_t replicate = 0;  // in work; those before it are complete
  std::uint64_t firstRay = 0;   // of the replicate: all pixels have those before it
  std::uint64_t row = 0;        // the rows above have those of the next pass too
  std::uint64_t raysTraced = 0;
  double seconds = 0.0;
  InvalidPixels invalid;
  std::vector<FilmPixel> film;  // of the replicate in work; of the image, if there is only one
  ReplicateSums replicates;     // complete ones, if there are several

  bool begun() const { return replicate > 0 || firstRay > 0 || row > 0; }
};

// Whether the framework can have written this into a film: sums of radiances, of at most so many
// rays.
bool isPossible(const FilmPixel& pixel, double mostRays);
inline constexpr const char* kScribbled =
    "The film holds values that the framework never writes: coursework must not write outside its "
    "own variables.";

// Rays of one renderPixel call: the smaller of N and 64.
std::uint32_t raysPerPass(std::uint64_t raysPerPixel);

// The seed of a replicate's random numbers. The first has the image's own, so that one replicate
// is the same image as none.
std::uint64_t replicateSeed(std::uint64_t seed, std::uint64_t replicate);

// Of all pixels together, counting values that were left out.
std::uint64_t raysMade(const RenderSettings& settings, const RenderState& state);

bool finished(const RenderSettings& settings, const RenderState& state);

// Of the whole image, in this replicate; which rays of it is left to be said.
RenderJob jobOf(const RenderSettings& settings, std::uint64_t replicate);

// Of about `pixelPasses` passes of single pixels: whole passes of the image, or rows of one.
RenderJob nextJob(const RenderSettings& settings, const RenderState& state, double pixelPasses);

// The film holds the job's rays already.
void advance(const RenderSettings& settings, const RenderJob& job, RenderState& state);

}  // namespace pathmark
