#include "host/size_option.h"

#include "host/session.h"
#include "scene/validate.h"

#include <fmt/format.h>

#include <charconv>

namespace pathmark {

std::array<int, 2> parseSize(const std::string& text) {
  std::array<int, 2> size{};
  const char *at = text.data(), *end = text.data() + text.size();
  const auto width = std::from_chars(at, end, size[0]);
  const bool separated = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
  const auto height = std::from_chars(separated ? width.ptr + 1 : end, end, size[1]);
  if (!separated || height.ec != std::errc{} || height.ptr != end)
    throw UsageError(
        fmt::format("--size {}: the size is width x height in pixels, such as 640x480.", text));
  for (const int side : size)
    if (side < 1 || side > kLargestSide)
      throw UsageError(
          fmt::format("--size {}: found a side of {}, but each is from 1 to {} pixels.", text, side,
                      kLargestSide));
  return size;
}

}  // namespace pathmark
