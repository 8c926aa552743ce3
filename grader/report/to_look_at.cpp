#include "report/to_look_at.h"

#include "diagnosis/diagnosis.h"
#include "report/record_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace pathmark::report {

namespace {

using record::FunctionRecord;
using record::PartRecord;
using record::PictureRecord;
using record::SubmissionRecord;
using record::Verdict;

bool isWritten(const FunctionRecord& function) {
  return function.verdict != Verdict::kNotWritten && function.mistake != diagnosis::kStub;
}

bool isWritten(const PartRecord& part) {
  if (part.functions.empty()) return part.verdict != Verdict::kNotWritten;
  return std::any_of(part.functions.begin(), part.functions.end(),
                     [](const FunctionRecord& function) { return isWritten(function); });
}

bool mayBeACopy(const SubmissionRecord& record) {
  return record.hasMarks() && !record.contents.empty() &&
         std::any_of(record.parts.begin(), record.parts.end(),
                     [](const PartRecord& part) { return isWritten(part); });
}

// "a", "a and b", "a, b and c", "a, b, c, d, e and 3 others".
std::string listOf(std::vector<std::string> names) {
  constexpr std::size_t kMost = 5;
  if (names.size() > kMost + 1) {
    const std::size_t others = names.size() - kMost;
    names.resize(kMost);
    names.push_back(fmt::format("{} others", others));
  }
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += fmt::format("{}{}", i == 0 ? "" : i + 1 == names.size() ? " and " : ", ", names[i]);
  return list;
}

const PictureRecord* lostPicture(const std::vector<PictureRecord>& pictures) {
  for (const PictureRecord& picture : pictures)
    if (!picture.failure.empty()) return &picture;
  return nullptr;
}

}  // namespace

std::vector<std::string> sameFiles(GradedClass graded) {
  std::map<std::string_view, std::vector<const SubmissionRecord*>> byContents;
  for (const Graded& g : graded)
    if (mayBeACopy(*g.record)) byContents[g.record->contents].push_back(g.record);
  std::vector<std::string> sentences;
  for (const Graded& g : graded) {
    std::vector<std::string> others;
    if (const auto same = byContents.find(g.record->contents); same != byContents.end())
      for (const SubmissionRecord* record : same->second)
        if (record != g.record) others.push_back(record->name);
    const bool any = !others.empty() && mayBeACopy(*g.record);
    sentences.push_back(any ? fmt::format("The same files as in {}.", listOf(others))
                            : std::string());
  }
  return sentences;
}

std::vector<std::string> reviewOf(const Graded& graded) {
  std::vector<std::string> sentences = graded.marks->toReview;
  if (!graded.record->hasMarks()) return sentences;
  const auto isSaid = [&](const std::string& why) {
    return std::any_of(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
      return sentence.find(why) != std::string::npos;
    });
  };
  for (const PartRecord& part : graded.record->parts) {
    const PictureRecord* lost = lostPicture(part.pictures);
    // Of what is wrong its verdict says enough.
    if (lost == nullptr || isFault(part.verdict) || !isMarked(*graded.marks, part.part) ||
        isSaid(lost->failure))
      continue;
    sentences.push_back(fmt::format("Part {}: there is no picture of {}: {}", part.part,
                                    lost->scene, lost->failure));
  }
  return sentences;
}

}  // namespace pathmark::report
