#include "film/image_formats.h"
#include "film/image_limits.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <sstream>

namespace pathmark {

static_assert(std::endian::native == std::endian::little);

std::string encodePfm(const Image& image) {
  std::string text = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
  const std::size_t row = static_cast<std::size_t>(image.width) * 3;
  for (int j = image.height - 1; j >= 0; --j)
    text.append(reinterpret_cast<const char*>(image.rgb.data() + static_cast<std::size_t>(j) * row),
                row * sizeof(float));
  return text;
}

Image decodePfm(std::string_view bytes) {
  constexpr std::size_t kLongestHeader = 128;
  std::istringstream header(std::string(bytes.substr(0, kLongestHeader)));
  std::string kind;
  std::int64_t width = 0, height = 0;
  double scale = 0.0;
  header >> kind >> width >> height >> scale;
  if (!header || kind != "PF" || !(scale < 0.0) || header.get() < 0)
    throw ImageError(
        "this is no PFM image with three channels and little-endian numbers, which begins with PF, "
        "width, height and -1.0.");
  requireImageSize(width, height);
  const std::string_view pixels = bytes.substr(static_cast<std::size_t>(header.tellg()));
  const auto rows = static_cast<std::size_t>(height);
  const std::size_t row = static_cast<std::size_t>(width) * 3;
  if (pixels.size() < rows * row * sizeof(float))
    throw ImageError(fmt::format("the file ends early: {} bytes of pixels, and {}x{} need {}.",
                                 pixels.size(), width, height, rows * row * sizeof(float)));
  Image image{static_cast<int>(width), static_cast<int>(height), {}, {}, {}};
  image.rgb.resize(rows * row);
  for (std::size_t j = 0; j < rows; ++j)
    std::memcpy(image.rgb.data() + (rows - 1 - j) * row, pixels.data() + j * row * sizeof(float),
                row * sizeof(float));
  return image;
}

}  // namespace pathmark
