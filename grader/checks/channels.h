// How channels of a colour are called in what is said of them.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace pathmark::checks {

inline constexpr std::array kChannels{"red", "green", "blue"};

// "radiance (red)"; `channel` counts from 0.
inline std::string inChannel(std::string_view what, int channel) {
  return fmt::format("{} ({})", what, kChannels.at(static_cast<std::size_t>(channel)));
}

}  // namespace pathmark::checks
