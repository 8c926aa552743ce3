#include "rubric/lost_file.h"

#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace pathmark::rubric {

namespace {

using record::PartRecord;
using record::SubmissionRecord;

// What such a sentence begins with: "work/Part2_lights (1).cpp"; empty for other sentences.
std::string_view nameIn(std::string_view sentence) {
  for (const std::string_view verb : {" was refused: ", " was ignored: "})
    if (const std::size_t end = sentence.find(verb); end != std::string_view::npos)
      return sentence.substr(0, end);
  return {};
}

// "part2_lights.cpp" and "Part2 (1).cpp" look like part 2's.
bool looksLikeFileOf(std::string_view path, int part) {
  std::string_view name = path.substr(path.find_last_of("/\\") + 1);
  if (name.starts_with('"')) name.remove_prefix(1);
  const std::string begin = fmt::format("part{}", part);
  return name.size() > begin.size() &&
         std::equal(begin.begin(), begin.end(), name.begin(), [](char wanted, char c) {
           return wanted == std::tolower(static_cast<unsigned char>(c));
         });
}

// A bonus part without a file is not in the record at all.
bool isMissing(const SubmissionRecord& record, int number) {
  return std::none_of(record.parts.begin(), record.parts.end(), [&](const PartRecord& part) {
    return part.part == number && part.hasFile();
  });
}

}  // namespace

std::string whatBecameOf(const SubmissionRecord& record, int part) {
  std::string sentences;
  for (const std::string& sentence : record.collecting)
    if (looksLikeFileOf(nameIn(sentence), part))
      sentences += fmt::format("{}{}", sentences.empty() ? "" : " ", sentence);
  return sentences;
}

void reviewLostFiles(const SubmissionRecord& record, std::vector<std::string>& toReview) {
  if (!record.hasMarks()) return;
  for (const PartContract& part : parts()) {
    const std::string became = whatBecameOf(record, part.part);
    if (!became.empty() && isMissing(record, part.part))
      toReview.push_back(fmt::format(
          "Part {} counts as not written, but something was handed in: {}", part.part, became));
  }
}

}  // namespace pathmark::rubric
