// Passages: does a file quote a hidden one, however it is laid out?
//
// A quotation is a run of letters that a hidden text has too, white space not counted. So it does
// not matter how lines are broken or indented, nor what surrounds them: prose, a comment, or the
// bytes of a picture. This is Rabin and Karp's search for many words of one length, as in
// Schleimer, Wilkerson & Aiken, "Winnowing", SIGMOD 2003, without their sampling.
#pragma once

#include "kit/quotation.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace pathmark::kit {

// About three lines. The shortest function of the solutions has 112 letters, and the longest
// declaration of one, which is public, has 97.
inline constexpr std::size_t kAnswerLetters = 110;

// About ten lines, for what is hidden and is no answer: programs that do similar things have up to
// 250 letters in common.
inline constexpr std::size_t kOtherLetters = 400;

class Passages {
 public:
  // Runs of this many letters are quotations.
  explicit Passages(std::size_t letters) : letters_(letters) {}

  // What may be quoted; to be said before anything is hidden.
  void allow(std::string_view text);
  void hide(const std::string& file, std::string_view text);

  // All quotations of a text, one for each run.
  std::vector<Quotation> find(std::string_view text) const;

 private:
  struct Place {
    std::uint32_t text = 0, letter = 0;
  };
  struct Text {
    std::string file, letters;
    std::vector<int> lines;  // of each letter
  };

  static Text squeeze(const std::string& file, std::string_view text, Comments comments);
  bool isAt(const Place& place, std::string_view letters) const;
  void findIn(const Text& text, std::vector<Quotation>& found) const;

  std::size_t letters_;
  std::vector<Text> texts_;
  std::unordered_set<std::uint64_t> allowed_;
  std::unordered_map<std::uint64_t, Place> places_;
};

}  // namespace pathmark::kit
