// Marks of what is correct: all points, but for those of efficiency where a variant is noisier than
// the solutions by its nature.
//
//   VariantMarks     what a correct variant earns for its part
//   withBonusParts   a rubric that also has points for the bonus parts
//   marksOf          from a record
//   markVariants     judges each variant as `grade` judges a submission, its part alone
//   reportMarks      as a table
#pragma once

#include "rubric/rubric.h"
#include "variants/variant.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pathmark::study {

struct Points {
  double points = 0.0, outOf = 0.0;
  bool all() const { return points == outOf; }
};

struct VariantMarks {
  Variant variant;
  std::uint64_t seed = 0;
  Points correctness;  // of the functions
  Points efficiency;
  Points part;                       // of both, rounded as the rubric says: what is given
  std::vector<std::string> reasons;  // for each that is lost, and what a person should look at
  bool toReview = false;             // a person should: what is correct gives no cause for it

  bool asItMustBe() const;
};

// Bonus parts that the rubric leaves out get 10 points, 2 of them for efficiency.
rubric::Rubric withBonusParts(rubric::Rubric rubric);

// What the rubric makes of the record of a submission with this variant in its part.
VariantMarks marksOf(const Variant& variant, const record::SubmissionRecord& record,
                     const rubric::Rubric& rubric);

struct MarksOptions {
  int seeds = 1;
  unsigned threads = 1;
  // Where records are kept; one of the same program, coursework and seed is not made again.
  std::filesystem::path folder;
};

// Seed by seed, each in the order of the variants. `step`, asked with how many of all are done,
// says whether to go on; if it says no, what is missing stays missing.
std::vector<VariantMarks> markVariants(
    const std::vector<Variant>& variants, const rubric::Rubric& rubric, const MarksOptions& options,
    const std::function<bool(std::size_t done, std::size_t all)>& step);

struct MarksReport {
  std::string text;
  bool asItMustBe = true;
};

MarksReport reportMarks(const std::vector<VariantMarks>& marks);

}  // namespace pathmark::study
