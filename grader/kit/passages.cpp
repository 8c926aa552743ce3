#include "kit/passages.h"

namespace pathmark::kit {

namespace {

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

Passages::Text Passages::squeeze(const std::string& file, std::string_view text,
                                 Comments comments) {
  Text squeezed{.file = file, .letters = {}, .lines = {}};
  for (const Line& line : linesOf(text, comments)) {
    squeezed.letters += line.letters;
    squeezed.lines.resize(squeezed.letters.size(), line.number);
  }
  return squeezed;
}

void Passages::allow(std::string_view text) {
  for (const Comments comments : {Comments::kKept, Comments::kDropped})
    forEachRun(squeeze({}, text, comments).letters, letters_,
               [&](std::uint64_t hash, std::size_t) { allowed_.insert(hash); });
}

void Passages::hide(const std::string& file, std::string_view text) {
  for (const Comments comments : {Comments::kKept, Comments::kDropped}) {
    const auto number = static_cast<std::uint32_t>(texts_.size());
    texts_.push_back(squeeze(file, text, comments));
    forEachRun(texts_.back().letters, letters_, [&](std::uint64_t hash, std::size_t at) {
      if (!allowed_.contains(hash))
        places_.try_emplace(hash, Place{number, static_cast<std::uint32_t>(at)});
    });
  }
}

std::vector<Quotation> Passages::find(std::string_view text) const {
  std::vector<Quotation> found;
  findIn(squeeze({}, text, Comments::kKept), found);
  if (found.empty()) findIn(squeeze({}, text, Comments::kDropped), found);
  return found;
}

bool Passages::isAt(const Place& place, std::string_view letters) const {
  const std::string_view hidden = texts_[place.text].letters;
  return hidden.substr(place.letter, letters.size()) == letters;
}

void Passages::findIn(const Text& text, std::vector<Quotation>& found) const {
  const std::string_view letters = text.letters;
  std::size_t clearOf = 0;  // the next letter that belongs to no run found so far
  forEachRun(letters, letters_, [&](std::uint64_t hash, std::size_t at) {
    const auto place = places_.find(hash);
    if (place == places_.end() || !isAt(place->second, letters.substr(at, letters_))) return;
    if (at >= clearOf) {
      const Text& hidden = texts_[place->second.text];
      found.push_back({text.lines[at], hidden.file, hidden.lines[place->second.letter]});
    }
    clearOf = at + letters_;
  });
}

}  // namespace pathmark::kit
