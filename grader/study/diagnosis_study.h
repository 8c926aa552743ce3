// How good the diagnosis is, measured on mistakes that it knows in disguise, and on some that it
// does not know.
//
//   makeCatalogue      the signatures of all mistakes, for the file in grader/diagnosis
//   catalogueStamp     of what it depends on: variants, solutions, probes
//   measureDiagnosis   rates of right and wrong names
#pragma once

#include "diagnosis/catalogue.h"
#include "study/disguise.h"
#include "study/named_case.h"

#include <functional>
#include <string>
#include <vector>

namespace pathmark::study {

// How far; says whether to go on.
using StudyStep = std::function<bool(std::size_t done, std::size_t all)>;

std::string catalogueStamp();
diagnosis::Catalogue makeCatalogue(const std::vector<Variant>& variants, unsigned threads,
                                   const StudyStep& step);

struct DiagnosisReport {
  std::vector<NamedCase> single, disguised, pairs;
  std::string text() const;     // what was not named right, and the rates
  std::string chapter() const;  // the rates, in Markdown
  bool asItMustBe() const;      // the rates that README promises
};

// `most`: files in disguise, and with two mistakes, that are tried. What is in the log already is
// not asked again.
DiagnosisReport measureDiagnosis(const diagnosis::Catalogue& catalogue,
                                 const std::vector<Variant>& variants, std::size_t most,
                                 unsigned threads, const std::filesystem::path& log,
                                 const StudyStep& step);

}  // namespace pathmark::study
