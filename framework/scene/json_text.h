// A scene's text before it has a meaning.
//
//   checkSyntax   whether it is JSON, with comments allowed
//   lineOf        where a value stands
#pragma once

#include "scene/source.h"

#include <cstddef>
#include <string_view>

namespace pathmark {

// A first walk over the text that builds nothing. Throws SceneError, with line and column, for what
// is no JSON, nests too deep for any scene, or says a key twice.
void checkSyntax(const SceneSource& source);

// The line, counted from 1, of the value at this JSON pointer (RFC 6901); 0 if there is none. Of an
// object or array it is the line of its opening bracket.
std::size_t lineOf(std::string_view text, std::string_view pointer);

}  // namespace pathmark
