// Mistakes as students make them: in code that also differs from the solutions where it may, or
// beside another mistake.
//
//   MistakenCase      one or two mistakes, and perhaps a correct difference, in one file
//   singleCases       every mistake by itself
//   disguisedCases    mistakes in files that differ where they may, at most so many
//   pairedCases       two mistakes in one file, at most so many
//   buildCase         the coursework that has them
#pragma once

#include "host/coursework_builder.h"
#include "variants/reach.h"
#include "variants/variant.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::study {

struct MistakenCase {
  std::vector<Variant> patches;  // applied in this order

  std::string name() const;
  int part() const { return patches.front().part; }
  bool makes(const std::string& mistake) const;
};

std::vector<MistakenCase> singleCases(const std::vector<Variant>& variants);

// Evenly taken from all combinations.
std::vector<MistakenCase> disguisedCases(const std::vector<Variant>& variants, std::size_t most);
std::vector<MistakenCase> pairedCases(const std::vector<Variant>& variants, std::size_t most);

struct CaseBuild {
  CourseworkBuild build;
  std::vector<CourseworkFunction> mayDiffer;  // from the solutions'
};

// Nothing if the patches do not go together: if they change the same lines, or what they make does
// not compile. `others`: the solutions' build, whose other parts are taken.
std::optional<CaseBuild> buildCase(const MistakenCase& c, const CourseworkBuild& others,
                                   const std::filesystem::path& scratch);

}  // namespace pathmark::study
