// CompareSession: from a picture and what is wished for to all that the window says about both.
//
//   CompareRequest   a picture, the reference that is wished for, and what is to be shown
//   CompareResult    numbers, verdict, picture of numbers, curves
#pragma once

#include "preview/compare/error_curves.h"
#include "preview/compare/false_colour.h"
#include "preview/compare/looks.h"
#include "preview/compare/reference_choice.h"
#include "preview/compare/verdict.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace pathmark::preview {

// The share of series in which noise alone is called a difference.
constexpr double kAlpha = 1e-3;

struct CompareRequest {
  std::shared_ptr<const Picture> picture;
  ReferenceWish wish;
  View view = View::kPicture;
};

// Immutable once it is made.
struct CompareResult {
  std::shared_ptr<const Picture> picture{};
  std::uint64_t wish = 0;
  View view = View::kPicture;
  FoundReference found{};
  std::optional<Comparison> comparison{};  // if there is a reference
  bool noiseKnown = false;                 // of the picture; z-scores mean nothing where it is not
  bool ownReference = false;               // the reference is an earlier picture of the same series
  Verdict verdict{};
  double nextLook = 0.0;  // rays per pixel at which the next verdict is made
  FalseColours colours{};
  std::string whyNoColours{};  // a sentence where the view is of numbers and there are none
  ErrorCurves curves{};
  std::optional<double> referenceNoise{};  // the expected error of the reference itself
};

// Not for the window's thread.
class CompareSession {
 public:
  explicit CompareSession(double alpha = kAlpha) : alpha_(alpha) {}

  std::shared_ptr<const CompareResult> compare(const CompareRequest& request);

 private:
  // The tests of the series against one reference.
  struct Trial {
    Looks looks;
    Verdict verdict;
  };

  Trial& trialOf(const Picture& picture, const Reference& reference);

  void compareWithReference(const std::shared_ptr<const Image>& known, CompareResult& result);
  static void colour(const std::shared_ptr<const Image>& known, CompareResult& result);

  double alpha_;
  ReferenceFinder finder_;
  std::uint64_t series_ = 0;
  // By the reference's number. Who goes back to a reference must not begin with a new first look.
  std::map<std::uint64_t, Trial> trials_;
  ErrorCurves curves_;
};

}  // namespace pathmark::preview
