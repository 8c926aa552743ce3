// An error in an expression, for a person.
//
//   sentenceOf      in one sentence
//   textWithCaret   with the expression below it, and a caret where it goes wrong
#pragma once

#include "light_paths/expression.h"

#include <string>
#include <string_view>

namespace pathmark {

std::string sentenceOf(std::string_view text, const ExpressionError& error);

std::string textWithCaret(std::string_view text, const ExpressionError& error);

}  // namespace pathmark
