// --size WxH.
#pragma once

#include <array>
#include <string>

namespace pathmark {

// Width and height; what they may be is the scene loader's business. Throws UsageError.
std::array<int, 2> parseSize(const std::string& text);

}  // namespace pathmark
