// SampleSet: what a sampling function answered, and how it looks beside its contract.
//
//   Sample         one call
//   SampleView     histograms and a p-value, of the samples as they are or weighted
//   makeSampleSet  from answers
#pragma once

#include "preview/samples/sample_histogram.h"

#include <optional>
#include <string>
#include <vector>

namespace pathmark::preview {

enum class SampleKind {
  kGood,
  kAstray,    // where the expected density is 0
  kNone,      // returned with density 0: no sample
  kNoNumber,  // NaN, infinite, or a negative density
};

struct Sample {
  CallNumbers numbers;  // that it was made from; of get_random_numbers there are none
  SampleKind kind = SampleKind::kGood;
  glm::dvec3 place{0.0};
  glm::dvec3 shown{0.0};  // in the sketch
  double claimed = 0.0;   // density, as returned
  double expected = 0.0;  // density of the contract
};

struct SampleView {
  std::vector<Histogram> histograms;
  CellTest test;
};

struct Range {
  double low, high;
};

struct SampleSet {
  SampleSettings settings;
  std::vector<Sample> samples;
  bool claims = false;  // the function returns densities
  SampleView plain;
  SampleView weighted;  // each sample counts with expected / claimed density; of a function that
                        // returns none, the same as `plain`
  // Over good samples, if there are any with a claim.
  std::optional<Range> claimed, claimedOverExpected;
  std::string astray;  // what the samples there do
  Sketch sketch;

  std::size_t count(SampleKind kind) const;
};

// answers: one for each of the numbers, in the words of contract.h.
SampleSet makeSampleSet(const SampleSettings& settings, const SampleDomain& domain,
                        std::span<const CallNumbers> numbers,
                        std::span<const std::uint32_t> answers);

}  // namespace pathmark::preview
