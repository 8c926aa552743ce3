#include "bench/render_way.h"

#include "host/session.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace pathmark::bench {

namespace {

enum class Word { kMis, kSolidAngle, kSplit, kShareDirect, kReuse, kDirectPaths };

struct WordForm {
  std::string_view text;
  bool numbered;
};

constexpr std::array<WordForm, 6> kForms{{{"mis", false},
                                          {"solid-angle", false},
                                          {"split", true},
                                          {"share-direct", false},
                                          {"reuse", true},
                                          {"direct-paths", true}}};

struct FoundWord {
  Word word;
  std::uint32_t number = 1;
};

bool isNumber(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// Whether `text` is a word of this form, whatever its number.
bool hasForm(std::string_view text, const WordForm& form) {
  if (!form.numbered) return text == form.text;
  return text.starts_with(form.text) && isNumber(text.substr(form.text.size()));
}

std::uint32_t numberOf(std::string_view text, const WordForm& form) {
  std::uint32_t number = 0;
  const std::string_view digits = text.substr(form.text.size());
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool possible = error == std::errc{} && number >= 1 && number <= PathSharing::kMost;
  if (!possible || (form.text == "reuse" && !std::has_single_bit(number)))
    throw UsageError(fmt::format("+{}: {} is followed by {}.", text, form.text,
                                 form.text == "reuse"
                                     ? "1, 2, 4, 8, 16, 32 or 64"
                                     : fmt::format("a number from 1 to {}", PathSharing::kMost)));
  return number;
}

bool findWord(std::string_view text, FoundWord& found) {
  for (std::size_t k = 0; k < kForms.size(); ++k)
    if (hasForm(text, kForms[k])) {
      found = {static_cast<Word>(k), kForms[k].numbered ? numberOf(text, kForms[k]) : 1};
      return true;
    }
  return false;
}

// Which words stand there, with their numbers.
class Wishes {
 public:
  void add(const FoundWord& found, std::string_view words) {
    std::optional<std::uint32_t>& number = numbers_[static_cast<std::size_t>(found.word)];
    if (number)
      throw UsageError(fmt::format("{}: {} stands there twice.", words,
                                   kForms[static_cast<std::size_t>(found.word)].text));
    number = found.number;
  }

  bool has(Word word) const { return numbers_[static_cast<std::size_t>(word)].has_value(); }
  std::uint32_t number(Word word) const {
    return numbers_[static_cast<std::size_t>(word)].value_or(1);
  }

 private:
  std::array<std::optional<std::uint32_t>, kForms.size()> numbers_;
};

void refuseCombinations(const Wishes& wishes, std::string_view words) {
  if ((wishes.has(Word::kMis) ? 1 : 0) + (wishes.has(Word::kSplit) ? 1 : 0) +
          (wishes.has(Word::kReuse) ? 1 : 0) >
      1)
    throw UsageError(fmt::format("{}: mis, split and reuse exclude each other.", words));
  if (wishes.has(Word::kShareDirect) && wishes.number(Word::kSplit) == 1)
    throw UsageError(fmt::format("{}: share-direct goes with split, from split2 on.", words));
  const bool unused = wishes.number(Word::kDirectPaths) > 1 && wishes.number(Word::kReuse) == 1;
  if (unused || (wishes.has(Word::kDirectPaths) && !wishes.has(Word::kReuse)))
    throw UsageError(fmt::format("{}: direct-paths goes with reuse, from reuse2 on.", words));
}

}  // namespace

RenderWay takeWay(std::string_view& text) {
  Wishes wishes;
  const std::string_view whole = text;
  for (;;) {
    const std::size_t plus = text.rfind('+');
    FoundWord found{};
    if (plus == std::string_view::npos || !findWord(text.substr(plus + 1), found)) break;
    wishes.add(found, whole);
    text = text.substr(0, plus);
  }
  refuseCombinations(wishes, whole);
  RenderWay way;
  way.words = whole.substr(text.size());
  if (wishes.has(Word::kSolidAngle)) way.lightSampling = LightSampling::kBySolidAngle;
  if (wishes.has(Word::kMis)) way.estimator = Estimator::kMis;
  if (wishes.number(Word::kSplit) > 1) {
    way.estimator = Estimator::kSplit;
    way.sharing.pathsPerRay = wishes.number(Word::kSplit);
    way.sharing.directLight = wishes.has(Word::kShareDirect) ? 1 : 0;
  }
  if (wishes.number(Word::kReuse) > 1) {
    way.estimator = Estimator::kReuse;
    way.sharing.pixels = wishes.number(Word::kReuse);
    way.sharing.directPaths = wishes.number(Word::kDirectPaths);
  }
  return way;
}

}  // namespace pathmark::bench
