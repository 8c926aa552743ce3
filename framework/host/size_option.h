// --size WxH.
#pragma once

#include <array>
#include <string>

namespace pathmark {

// Width and height that a scene may have. Throws UsageError.
std::array<int, 2> parseSize(const std::string& text);

}  // namespace pathmark
