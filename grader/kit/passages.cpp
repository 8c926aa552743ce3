#include "kit/passages.h"

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
  constexpr std::array kBeginnings = std::to_array<std::string_view>(
      {"include<", "include\"", "pragmaonce", "namespace", "usingnamespace"});
  return std::none_of(letters.begin(), letters.end(), isWord) ||
         (letters.size() <= kLongest &&
          std::any_of(kBeginnings.begin(), kBeginnings.end(),
                      [&](std::string_view b) { return letters.starts_with(b); }));
}

std::string lettersOf(std::string_view line) {
  constexpr std::string_view kMarks = "/*>+#|-";
  std::string letters;
  for (const char c : line)
    if (!isSpace(c) && (!letters.empty() || kMarks.find(c) == std::string_view::npos)) letters += c;
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

// The lines of a patch that begin with a space or with `kept`; others stay as empty lines, so that
// lines keep their numbers.
std::string linesOfPatch(std::string_view patch, char kept) {
  std::string lines;
  bool inHunk = false;
  forEachLine(patch, [&](int, std::string_view line) {
    const bool isHeader = line.starts_with("--- ") || line.starts_with("+++ ");
    if (line.starts_with("@@"))
      inHunk = true;
    else if (inHunk && !isHeader && !line.empty() && (line[0] == ' ' || line[0] == kept))
      lines += line.substr(1);
    lines += '\n';
  });
  return lines;
}

// Calls take(hash, where it begins) with every run of this many letters.
template <class Take>
void forEachRun(std::string_view letters, std::size_t length, const Take& take) {
  constexpr std::uint64_t kBase = 0x9e3779b97f4a7c15ull;
  if (letters.size() < length) return;
  std::uint64_t highest = 1, hash = 0;
  for (std::size_t k = 0; k + 1 < length; ++k) highest *= kBase;
  for (std::size_t k = 0; k < letters.size(); ++k) {
    if (k >= length) hash -= highest * static_cast<unsigned char>(letters[k - length]);
    hash = hash * kBase + static_cast<unsigned char>(letters[k]);
    if (k + 1 >= length) take(hash, k + 1 - length);
  }
}

}  // namespace

Squeezed squeeze(std::string_view text, Comments comments) {
  Squeezed squeezed;
  forEachLine(text, [&](int number, std::string_view line) {
    if (comments == Comments::kDropped && isComment(line)) return;
    const std::string letters = lettersOf(line);
    if (isTheSameEverywhere(letters)) return;
    squeezed.letters += letters;
    squeezed.lines.resize(squeezed.letters.size(), number);
  });
  return squeezed;
}

std::string afterPatch(std::string_view patch) { return linesOfPatch(patch, '+'); }
std::string beforePatch(std::string_view patch) { return linesOfPatch(patch, '-'); }

void Passages::allow(std::string_view text) {
  for (const Comments comments : {Comments::kKept, Comments::kDropped})
    forEachRun(squeeze(text, comments).letters, letters_,
               [&](std::uint64_t hash, std::size_t) { allowed_.insert(hash); });
}

void Passages::hide(const std::string& file, std::string_view text) {
  for (const Comments comments : {Comments::kKept, Comments::kDropped}) {
    const auto number = static_cast<std::uint32_t>(texts_.size());
    texts_.push_back({file, squeeze(text, comments)});
    forEachRun(texts_.back().squeezed.letters, letters_, [&](std::uint64_t hash, std::size_t at) {
      if (!allowed_.contains(hash))
        places_.try_emplace(hash, Place{number, static_cast<std::uint32_t>(at)});
    });
  }
}

std::vector<Quotation> Passages::find(std::string_view text) const {
  std::vector<Quotation> found;
  findIn(squeeze(text, Comments::kKept), found);
  if (found.empty()) findIn(squeeze(text, Comments::kDropped), found);
  return found;
}

bool Passages::isAt(const Place& place, std::string_view letters) const {
  const std::string_view hidden = texts_[place.text].squeezed.letters;
  return hidden.substr(place.letter, letters.size()) == letters;
}

void Passages::findIn(const Squeezed& text, std::vector<Quotation>& found) const {
  const std::string_view letters = text.letters;
  std::size_t clearOf = 0;  // the next letter that belongs to no run found so far
  forEachRun(letters, letters_, [&](std::uint64_t hash, std::size_t at) {
    const auto place = places_.find(hash);
    if (place == places_.end() || !isAt(place->second, letters.substr(at, letters_))) return;
    if (at >= clearOf) {
      const Hidden& hidden = texts_[place->second.text];
      found.push_back({text.lines[at], hidden.file, hidden.squeezed.lines[place->second.letter]});
    }
    clearOf = at + letters_;
  });
}

}  // namespace pathmark::kit
