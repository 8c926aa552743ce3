#include "film/image_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <fstream>

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

Image readPfm(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw ImageError(fmt::format("{} cannot be read.", file.string()));
  std::string kind;
  double scale = 0.0;
  Image image;
  in >> kind >> image.width >> image.height >> scale;
  in.get();
  constexpr int kLargest = 65536;
  if (!in || kind != "PF" || scale >= 0.0 || image.width < 1 || image.height < 1 ||
      image.width > kLargest || image.height > kLargest)
    throw ImageError(
        fmt::format("{} is no little-endian PFM image with three channels.", file.string()));
  const std::size_t row = static_cast<std::size_t>(image.width) * 3;
  std::error_code error;
  const std::uintmax_t pixels = row * sizeof(float) * static_cast<std::size_t>(image.height);
  if (std::filesystem::file_size(file, error) < pixels || error)
    throw ImageError(fmt::format("{} ends before its last pixel.", file.string()));
  image.rgb.resize(row * static_cast<std::size_t>(image.height));
  for (int j = image.height - 1; j >= 0; --j)
    in.read(reinterpret_cast<char*>(image.rgb.data() + static_cast<std::size_t>(j) * row),
            static_cast<std::streamsize>(row * sizeof(float)));
  if (!in) throw ImageError(fmt::format("{} ends before its last pixel.", file.string()));
  return image;
}

}  // namespace pathmark
