#include "gallery/palette_png.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace pathmark::gallery {

namespace {

constexpr std::size_t kLevels = 32, kColours = kLevels * kLevels * kLevels, kPalette = 256;

using Rgb = std::array<int, 3>;  // levels of 0 to 31

std::size_t levelOf(std::uint8_t byte) { return (byte * (kLevels - 1) + 127) / 255; }

std::size_t indexOf(const std::uint8_t* rgb) {
  return (levelOf(rgb[0]) * kLevels + levelOf(rgb[1])) * kLevels + levelOf(rgb[2]);
}

Rgb levelsOf(std::size_t index) {
  return {static_cast<int>(index / kLevels / kLevels), static_cast<int>(index / kLevels % kLevels),
          static_cast<int>(index % kLevels)};
}

// Colours that share an entry of the palette.
struct Box {
  std::vector<std::size_t> colours;
  std::size_t channel = 0;  // in which they differ most
  int extent = 0;           // by so many levels

  explicit Box(std::vector<std::size_t> some) : colours(std::move(some)) {
    for (std::size_t c = 0; c < 3; ++c) {
      int low = static_cast<int>(kLevels), high = -1;
      for (const std::size_t index : colours) {
        low = std::min(low, levelsOf(index)[c]);
        high = std::max(high, levelsOf(index)[c]);
      }
      if (high - low > extent) {
        extent = high - low;
        channel = c;
      }
    }
  }
};

// In two at the median of its colours, each counted once: rare ones have a right to be seen.
std::pair<Box, Box> cut(Box box) {
  const auto middle = box.colours.begin() + static_cast<std::ptrdiff_t>(box.colours.size() / 2);
  std::nth_element(box.colours.begin(), middle, box.colours.end(),
                   [&](std::size_t a, std::size_t b) {
                     return levelsOf(a)[box.channel] < levelsOf(b)[box.channel];
                   });
  return {Box({box.colours.begin(), middle}), Box({middle, box.colours.end()})};
}

std::vector<Box> boxesOf(std::vector<std::size_t> colours) {
  std::vector<Box> boxes{Box(std::move(colours))};
  while (boxes.size() < kPalette) {
    const auto widest = std::max_element(
        boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.extent < b.extent; });
    if (widest->extent == 0) break;
    auto [low, high] = cut(std::move(*widest));
    *widest = std::move(low);
    boxes.push_back(std::move(high));
  }
  return boxes;
}

void putNumber(std::string& bytes, std::size_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xffu);
}

const Bytef* asBytes(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

void putChunk(std::string& png, std::string_view kind, std::string_view data) {
  putNumber(png, data.size());
  std::string body(kind);
  body += data;
  png += body;
  putNumber(png, crc32(0, asBytes(body), static_cast<uInt>(body.size())));
}

std::string compressed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, asBytes(bytes), bytes.size(),
                Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib cannot compress a picture");
  result.resize(size);
  return result;
}

}  // namespace

std::string encodePalettePng(int width, int height, std::span<const std::uint8_t> srgb) {
  std::vector<std::size_t> count(kColours, 0);
  for (std::size_t p = 0; p < srgb.size(); p += 3) ++count[indexOf(&srgb[p])];
  std::vector<std::size_t> colours;
  for (std::size_t index = 0; index < kColours; ++index)
    if (count[index] > 0) colours.push_back(index);

  std::vector<std::uint8_t> entry(kColours, 0);
  std::string palette;
  const std::vector<Box> boxes = boxesOf(std::move(colours));
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    double sum[3] = {}, pixels = 0.0;
    for (const std::size_t index : boxes[k].colours) {
      entry[index] = static_cast<std::uint8_t>(k);
      const auto weight = static_cast<double>(count[index]);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * levelsOf(index)[c];
      pixels += weight;
    }
    for (const double s : sum)
      palette += static_cast<char>(static_cast<int>(s / pixels * 255.0 / (kLevels - 1) + 0.5));
  }

  std::string head, rows;
  putNumber(head, static_cast<std::size_t>(width));
  putNumber(head, static_cast<std::size_t>(height));
  head += std::string{8, 3, 0, 0, 0};  // bits, palette, zlib, filters, not interlaced
  for (std::size_t p = 0; p < srgb.size(); p += 3) {
    if (p % (3 * static_cast<std::size_t>(width)) == 0) rows += '\0';  // a row without a filter
    rows += static_cast<char>(entry[indexOf(&srgb[p])]);
  }
  std::string png = "\x89PNG\r\n\x1a\n";
  putChunk(png, "IHDR", head);
  putChunk(png, "PLTE", palette);
  putChunk(png, "IDAT", compressed(rows));
  putChunk(png, "IEND", {});
  return png;
}

}  // namespace pathmark::gallery
