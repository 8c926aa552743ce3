// PathExpression: a light path expression (Heckbert, "Adaptive Radiosity Textures for Bidirectional
// Ray Tracing", SIGGRAPH 1990), read from its text.
//
//   L E        the light at which a path begins, the eye at which it ends
//   D S .      a scattering event by a diffuse lobe, a specular lobe, or either
//   x* x+ x?   any number of x, at least one, at most one
//   x|y        x or y; binds less than the rest
//   (x)        a group; spaces mean nothing
//
// An expression stands for whole paths, and all of it for some path: a letter that no path can have
// is an error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark {

// Half a sentence without a full stop: what is wrong, and where in the text.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(std::size_t position, const std::string& what)
      : std::runtime_error(what), position_(position) {}

  std::size_t position() const { return position_; }  // of a character, or the text's length

 private:
  std::size_t position_;
};

class PathExpression {
 public:
  static constexpr std::size_t kMostLetters = 64, kLongestText = 200;

  // A set of the expression's letters, as bits.
  using Letters = std::uint64_t;

  // Throws ExpressionError.
  explicit PathExpression(std::string_view text);

  const std::string& text() const { return text_; }  // without spaces

  // The expression as the automaton of its letters (Glushkov 1961): a path is a walk from one of
  // `first` by `before` to one of `last`.
  std::size_t letterCount() const { return symbols_.size(); }
  char symbol(std::size_t letter) const { return symbols_[letter]; }  // one of L E S D .
  Letters first() const { return first_; }
  Letters last() const { return last_; }
  Letters before(std::size_t letter) const { return before_[letter]; }

 private:
  friend class ExpressionReader;

  PathExpression() = default;
  Letters withSymbol(std::string_view symbols) const;
  void refuseUselessLetters(std::string_view text, const std::vector<std::size_t>& places) const;

  std::string text_;
  std::string symbols_;
  Letters first_ = 0, last_ = 0;
  std::array<Letters, kMostLetters> before_{};
};

}  // namespace pathmark
