#include "kit/quoted_lines.h"

#include <algorithm>
#include <cctype>

namespace pathmark::kit {

namespace {

constexpr std::size_t kLines = 3;

// Fewer are a loop or a sum like any other.
constexpr std::size_t kLeastLetters = 40;

// Such as "else {" or "}, 2.0f);".
bool saysLittle(const Line& line) {
  constexpr std::ptrdiff_t kLeastWords = 4;
  return std::count_if(line.letters.begin(), line.letters.end(), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0;
         }) < kLeastWords;
}

// Calls take(letters of three lines, where they begin, which of the runs) with every run.
template <class Take>
void forEachThree(std::string_view text, const Take& take) {
  std::vector<Line> lines = linesOf(text, Comments::kDropped);
  std::erase_if(lines, saysLittle);
  for (std::size_t k = 0; k + kLines <= lines.size(); ++k) {
    std::string letters;
    for (std::size_t n = 0; n < kLines; ++n) letters += lines[k + n].letters + '\n';
    if (letters.size() >= kLeastLetters + kLines) take(letters, lines[k].number, k);
  }
}

}  // namespace

void QuotedLines::allow(std::string_view text) {
  forEachThree(text,
               [&](const std::string& letters, int, std::size_t) { allowed_.insert(letters); });
}

void QuotedLines::hide(const std::string& file, std::string_view text) {
  files_.push_back(file);
  forEachThree(text, [&](const std::string& letters, int line, std::size_t) {
    if (!allowed_.contains(letters)) places_.try_emplace(letters, Place{files_.size() - 1, line});
  });
}

std::vector<Quotation> QuotedLines::find(std::string_view text) const {
  std::vector<Quotation> found;
  std::size_t clearOf = 0;  // the next run that shares no line with those found so far
  forEachThree(text, [&](const std::string& letters, int line, std::size_t k) {
    const auto place = places_.find(letters);
    if (place == places_.end()) return;
    if (k >= clearOf) found.push_back({line, files_[place->second.file], place->second.line});
    clearOf = k + kLines;
  });
  return found;
}

}  // namespace pathmark::kit
