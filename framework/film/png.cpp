#include "film/image_formats.h"
#include "film/image_limits.h"
#include "film/srgb.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace pathmark {

namespace {

constexpr std::array<std::uint8_t, 3> kMagenta{255, 0, 255};

// PNG specification (ISO/IEC 15948), sections 5.2 and 11.2.2: the signature, then the header chunk,
// whose first two numbers are the size, most significant byte first.
void refuseHeader(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::size_t kSizeAt = 16;
  const auto number = [&](std::size_t at) {
    std::int64_t value = 0;
    for (const char c : bytes.substr(at, 4)) value = value << 8 | static_cast<std::uint8_t>(c);
    return value;
  };
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n\0\0\0\rIHDR"sv) || bytes.size() < kSizeAt + 8)
    throw ImageError("this is no PNG image: its first bytes are not those of the format.");
  requireImageSize(number(kSizeAt), number(kSizeAt + 4));
}

void appendToString(void* to, void* data, int size) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                        static_cast<std::size_t>(size));
}

}  // namespace

std::string encodePngBytes(int width, int height, std::span<const std::uint8_t> srgb) {
  std::string png;
  if (stbi_write_png_to_func(appendToString, &png, width, height, 3, srgb.data(), 3 * width) == 0)
    throw ImageError("the image could not be encoded as PNG.");
  return png;
}

std::string encodePng(const Image& image, double exposure) {
  const SrgbBytes& srgb = SrgbBytes::table();
  std::vector<std::uint8_t> bytes;
  bytes.reserve(image.rgb.size());
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const std::span<const float, 3> rgb(&image.rgb[i], 3);
    const bool nan = std::isnan(rgb[0]) || std::isnan(rgb[1]) || std::isnan(rgb[2]);
    const bool invalid = nan || (!image.invalid.empty() && image.invalid[i / 3] != 0);
    for (std::size_t c = 0; c < 3; ++c)
      bytes.push_back(invalid ? kMagenta[c] : srgb(static_cast<double>(rgb[c]) * exposure));
  }
  return encodePngBytes(image.width, image.height, bytes);
}

Image decodePng(std::string_view bytes) {
  refuseHeader(bytes);
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> srgb(
      stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 3),
      stbi_image_free);
  if (!srgb) throw ImageError("this PNG image is damaged, or ends before its last pixel.");
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = static_cast<float>(decodeSrgb(static_cast<double>(i) / 255.0));
  const std::size_t values =
      3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.rgb.reserve(values);
  for (std::size_t i = 0; i < values; ++i) image.rgb.push_back(linear[srgb.get()[i]]);
  return image;
}

}  // namespace pathmark
