// ExpressionReader: the grammar of light path expressions, by recursive descent.
#pragma once

#include "light_paths/expression.h"

namespace pathmark {

class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, PathExpression& expression)
      : text_(text), expression_(expression) {}

  void read();

  // Where in the text each letter stands.
  const std::vector<std::size_t>& places() const { return places_; }

 private:
  // What a part of the expression adds to the automaton of the letters.
  struct Part {
    bool empty = false;  // it stands for nothing, too
    PathExpression::Letters first = 0, last = 0;
  };

  Part readChoice();
  Part readSequence();
  Part readRepeated();
  Part readOne();
  Part readGroup();
  Part readLetter(char symbol);

  // A letter of `first` may come right after each of `last`.
  void connect(PathExpression::Letters last, PathExpression::Letters first);

  char peek();  // the next character but for spaces; 0 at the end
  [[noreturn]] void refuse(std::size_t position, const std::string& what) const;

  std::string_view text_;
  PathExpression& expression_;
  std::size_t at_ = 0;
  std::vector<std::size_t> places_;
};

}  // namespace pathmark
