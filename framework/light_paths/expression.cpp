#include "light_paths/expression.h"

#include "light_paths/expression_reader.h"

#include <fmt/format.h>

#include <bit>

namespace pathmark {

namespace {

using Letters = PathExpression::Letters;

constexpr Letters only(std::size_t letter) { return Letters{1} << letter; }

constexpr bool has(Letters letters, std::size_t letter) { return (letters & only(letter)) != 0; }

std::string whyUseless(char symbol) {
  switch (symbol) {
    case 'L':
      return "no path can have this L: a path begins with its only L, at the light, and ends with "
             "E";
    case 'E':
      return "no path can have this E: a path begins with L, and ends with its only E, at the eye";
    default:
      return fmt::format(
          "no path can have this {}: a path begins with L, at the light, and ends with E, at the "
          "eye",
          symbol);
  }
}

}  // namespace

PathExpression::PathExpression(std::string_view text) {
  ExpressionReader reader(text, *this);
  reader.read();
  refuseUselessLetters(text, reader.places());
}

Letters PathExpression::withSymbol(std::string_view symbols) const {
  Letters letters = 0;
  for (std::size_t i = 0; i < symbols_.size(); ++i)
    if (symbols.find(symbols_[i]) != std::string_view::npos) letters |= only(i);
  return letters;
}

// First those that stand at the wrong end, which often make others useless.
void PathExpression::refuseUselessLetters(std::string_view text,
                                          const std::vector<std::size_t>& places) const {
  const Letters lights = withSymbol("L"), eyes = withSymbol("E");
  if (symbols_.front() == 'E' && symbols_.back() == 'L')
    throw ExpressionError(
        0, "a path is written from the light to the eye: it begins with L and ends with E");
  if (lights == 0) throw ExpressionError(0, "a path begins at a light: its L is missing");
  if (eyes == 0) throw ExpressionError(text.size(), "a path ends at the eye: its E is missing");
  for (std::size_t i = 0; i < symbols_.size(); ++i)
    if (has((lights & ~first_) | (eyes & ~last_), i))
      throw ExpressionError(places[i], whyUseless(symbols_[i]));
  // What can be reached from the light, and from what the eye can be reached.
  Letters fromLight = lights & first_, toEye = eyes & last_;
  // Each round adds a letter or is the last.
  for (std::size_t round = 0; round < symbols_.size(); ++round)
    for (std::size_t i = 0; i < symbols_.size(); ++i) {
      if (!has(lights, i) && (before_[i] & fromLight & ~eyes) != 0) fromLight |= only(i);
      if (has(toEye, i) && !has(lights, i)) toEye |= before_[i] & ~eyes;
    }
  for (std::size_t i = 0; i < symbols_.size(); ++i)
    if (!has(fromLight & toEye, i)) throw ExpressionError(places[i], whyUseless(symbols_[i]));
}

}  // namespace pathmark
