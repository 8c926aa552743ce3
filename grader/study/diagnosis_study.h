// How good the diagnosis is, measured on mistakes that it knows in disguise, and on some that it
// does not know.
//
//   makeCatalogue      the signatures of all mistakes, for the file in grader/diagnosis
//   catalogueStamp     of what it depends on: variants, solutions, probes
//   measureDiagnosis   rates of right and wrong names
#pragma once

#include "diagnosis/catalogue.h"
#include "study/disguise.h"

#include <functional>
#include <string>
#include <vector>

namespace pathmark::study {

// How far; says whether to go on.
using StudyStep = std::function<bool(std::size_t done, std::size_t all)>;

std::string catalogueStamp();
diagnosis::Catalogue makeCatalogue(const std::vector<Variant>& variants, unsigned threads,
                                   const StudyStep& step);

// What is said of the functions of a file with a mistake.
enum class Named {
  kRight,    // the mistake, or a pair of which it is one
  kWrong,    // another one, of any of the functions
  kNothing,  // nothing clear
  kUnseen,   // no check fails: the difference has mended the mistake
};

struct NamedCase {
  std::string name;
  std::string mistake;                   // that is made; of two the second
  Named known = Named::kNothing;         // by the whole catalogue
  Named leftOut = Named::kNothing;       // without the mistakes that are made
  Named leftOutAlike = Named::kNothing;  // without those that look the same, either
  std::string words;                     // which names were given, where they are not the right one
};

struct DiagnosisReport {
  std::vector<NamedCase> single, disguised, pairs;
  std::string text() const;     // what was not named right, and the rates
  std::string chapter() const;  // the rates, in Markdown
  bool asItMustBe() const;      // the rates that README promises
};

// `most`: files in disguise, and with two mistakes, that are tried.
DiagnosisReport measureDiagnosis(const diagnosis::Catalogue& catalogue,
                                 const std::vector<Variant>& variants, std::size_t most,
                                 unsigned threads, const StudyStep& step);

}  // namespace pathmark::study
