#include "rubric/verdict_credit.h"

#include <fmt/format.h>

namespace pathmark::rubric {

using record::Verdict;

std::optional<VerdictCredit> creditOf(Verdict verdict, const Rubric& rubric) {
  switch (verdict) {
    case Verdict::kOk:
    case Verdict::kUndecided:
    case Verdict::kInternalError:
      return VerdictCredit{1.0, {}};
    case Verdict::kNotWritten:
      return VerdictCredit{0.0, "it is not written yet"};
    case Verdict::kDoesNotCompile:
      return VerdictCredit{0.0, "its file does not compile"};
    case Verdict::kCrashed:
      return VerdictCredit{rubric.crashed, "it crashed"};
    case Verdict::kTimeLimit:
      return VerdictCredit{rubric.timeLimit, "it did not end within its time"};
    case Verdict::kMemoryLimit:
      return VerdictCredit{rubric.memoryLimit, "it needed more memory than is allowed"};
    case Verdict::kOutputLimit:
      return VerdictCredit{rubric.outputLimit, "it printed more than is allowed"};
    case Verdict::kForbiddenCall:
      return VerdictCredit{rubric.forbiddenCall,
                           "it called the system in a way that coursework must not"};
    case Verdict::kBlocked:
    case Verdict::kWrong:
      break;
  }
  return std::nullopt;
}

void reviewVerdict(Verdict verdict, const std::string& what, std::vector<std::string>& toReview) {
  if (verdict == Verdict::kInternalError)
    toReview.push_back(fmt::format(
        "{}: the grader or the machine failed, which costs no points; grade it again.", what));
  if (verdict == Verdict::kForbiddenCall)
    toReview.push_back(fmt::format(
        "{}: it made a forbidden call; is it a mistake, or an attempt to cheat?", what));
}

std::string sentence(std::string phrase) {
  if (phrase.empty()) return phrase;
  if (phrase.front() >= 'a' && phrase.front() <= 'z')
    phrase.front() = static_cast<char>(phrase.front() - 'a' + 'A');
  if (phrase.back() != '.' && phrase.back() != '!' && phrase.back() != '?') phrase += '.';
  return phrase;
}

}  // namespace pathmark::rubric
