// nearestName: the name that a misspelt one may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pathmark {

// The name with the fewest letters to insert, delete, replace or swap, capitals counting as small
// letters; nothing if even that one differs in more than a third of its letters.
std::string_view nearestName(std::string_view word, std::span<const std::string_view> names);

// ` Did you mean "name"?`, or nothing if no name is near: to be put after a sentence.
std::string didYouMean(std::string_view word, std::span<const std::string_view> names);

}  // namespace pathmark
