// What a verdict alone is worth.
#pragma once

#include "rubric/rubric.h"

#include <optional>
#include <string>

namespace pathmark::rubric {

struct VerdictCredit {
  double credit = 0.0;
  std::string reason;  // "it crashed"; empty for all points
};

// Nothing for what is wrong or blocked, which is worth what the pictures say.
std::optional<VerdictCredit> creditOf(record::Verdict verdict, const Rubric& rubric);

// Sentences for a person, where the verdict asks for one. `what` is "3.3 lambertianBRDF::pdf".
void reviewVerdict(record::Verdict verdict, const std::string& what,
                   std::vector<std::string>& toReview);

// "Sentence. Another." from phrases without their capitals and full stops.
std::string sentence(std::string phrase);

}  // namespace pathmark::rubric
