// The formats of image files, as bytes in memory. What decoders throw is an ImageError without the
// file's name, to be put after "NAME: ".
//
//   PNG   to look at: 8-bit sRGB
//   EXR   to keep: radiance, variance, invalid pixels and origin
//   PFM   to compute with: radiance
//   HDR   for other programs: radiance with 8 bits
#pragma once

#include "film/image_file.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pathmark {

// 8-bit sRGB of exposure * radiance, clipped at 1; invalid pixels in magenta.
std::string encodePng(const Image& image, double exposure);

// The same for bytes that are sRGB already: 3 x width x height.
std::string encodePngBytes(int width, int height, std::span<const std::uint8_t> srgb);

// Undoes the sRGB curve, but neither exposure nor clipping.
Image decodePng(std::string_view bytes);

enum class ExrBits {
  kAll,
  kAboveNoise  // of roundedToNoise: for files that are handed out
};

// 32-bit floats in the channels R, G and B; variance.R, .G and .B where the variance is known;
// invalid, a whole number that is 1 where the pixel is, if any is. Rows from the top, ZIP. The
// origin becomes the attributes pathmark.scene and so on.
std::string encodeExr(const Image& image, const ImageOrigin& origin, ExrBits bits = ExrBits::kAll);

// Also other programs' files: any compression and sample type, tiles, further channels; one part,
// no deep data. What is not there stays as ImageFile has it without.
ImageFile decodeExr(std::string_view bytes);

// 32-bit floats, little-endian, rows from the bottom (Debevec's portable float map).
std::string encodePfm(const Image& image);
Image decodePfm(std::string_view bytes);

// Radiance RGBE: three 8-bit mantissas with a common exponent, rounded to nearest, which is at most
// 1/256 of the largest of the three off. Values that are negative or NaN become 0.
std::string encodeHdr(const Image& image);
Image decodeHdr(std::string_view bytes);

}  // namespace pathmark
