#include "kit/quotation.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace pathmark::kit {

namespace {

bool isSpace(char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; }

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

// Every file of the project begins and ends with such lines. Longer ones may hold more.
bool isTheSameEverywhere(std::string_view letters) {
  constexpr std::size_t kLongest = 60;
  constexpr std::array kBeginnings =
      std::to_array<std::string_view>({"include", "pragmaonce", "namespace", "usingnamespace"});
  return std::none_of(letters.begin(), letters.end(), isWord) ||
         (letters.size() <= kLongest &&
          std::any_of(kBeginnings.begin(), kBeginnings.end(),
                      [&](std::string_view b) { return letters.starts_with(b); }));
}

// Code in a string has quotation marks around it and its line breaks written out.
std::string lettersOf(std::string_view line) {
  constexpr std::string_view kMarksAtTheFront = "/*>+#|-";
  std::string letters;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (line.substr(k, 2) == "\\n" || line.substr(k, 2) == "\\t" || line.substr(k, 2) == "\\\"") {
      ++k;
      continue;
    }
    if (isSpace(c) || c == '"') continue;
    if (letters.empty() && kMarksAtTheFront.find(c) != std::string_view::npos) continue;
    letters += c;
  }
  return letters;
}

bool isComment(std::string_view line) {
  const auto first = std::find_if_not(line.begin(), line.end(), isSpace);
  return line.substr(static_cast<std::size_t>(first - line.begin())).starts_with("//");
}

// Calls take(number, line) with every line of a text.
template <class Take>
void forEachLine(std::string_view text, const Take& take) {
  int number = 1;
  for (std::size_t begin = 0; begin <= text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    take(number, text.substr(begin, end - begin));
    begin = end + 1;
  }
}

// The lines that begin with a space or with `kept`, as they are without that; others are empty.
std::string linesOfPatch(std::string_view patch, char kept) {
  std::string lines;
  bool inHunk = false;
  forEachLine(patch, [&](int, std::string_view line) {
    const bool isHeader = line.starts_with("--- ") || line.starts_with("+++ ");
    const bool isKept = !line.empty() && (line[0] == ' ' || line[0] == kept);
    if (inHunk && isKept && !isHeader) lines += line.substr(1);
    if (line.starts_with("@@")) inHunk = true;
    lines += '\n';
  });
  return lines;
}

}  // namespace

std::vector<Line> linesOf(std::string_view text, Comments comments) {
  std::vector<Line> lines;
  forEachLine(text, [&](int number, std::string_view line) {
    if (comments == Comments::kDropped && isComment(line)) return;
    std::string letters = lettersOf(line);
    if (!isTheSameEverywhere(letters)) lines.push_back({number, std::move(letters)});
  });
  return lines;
}

std::string afterPatch(std::string_view patch) { return linesOfPatch(patch, '+'); }
std::string beforePatch(std::string_view patch) { return linesOfPatch(patch, '-'); }

}  // namespace pathmark::kit
