#include "kit/file_kind.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace pathmark::kit {

namespace {

std::uint32_t byteAt(std::string_view content, std::size_t k) {
  return static_cast<unsigned char>(content[k]);
}

bool isControl(std::uint32_t byte) {
  return byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r';
}

// The length of the UTF-8 character at k; 0 if there is none. RFC 3629, section 4.
std::size_t characterAt(std::string_view content, std::size_t k) {
  const std::uint32_t first = byteAt(content, k);
  if (first < 0x80) return isControl(first) || first == 0x7f ? 0 : 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || k + length > content.size()) return 0;
  for (std::size_t n = 1; n < length; ++n)
    if ((byteAt(content, k + n) & 0xc0u) != 0x80u) return 0;
  const std::uint32_t second = byteAt(content, k + 1);
  const bool outOfRange = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                          (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return outOfRange ? 0 : length;
}

bool isText(std::string_view content) {
  for (std::size_t k = 0; k < content.size();) {
    const std::size_t length = characterAt(content, k);
    if (length == 0) return false;
    k += length;
  }
  return true;
}

bool isKnownChunk(std::string_view name) {
  constexpr std::array kNames = std::to_array<std::string_view>(
      {"IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "cHRM", "sRGB", "pHYs", "tEXt"});
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kExr = "\x76\x2f\x31\x01";

// Portable Network Graphics, section 5.3: length, name, data, CRC.
std::string whyNoPng(std::string_view content) {
  constexpr std::size_t kAround = 12;
  std::size_t k = kPng.size();
  while (k + kAround <= content.size()) {
    const std::size_t length = byteAt(content, k) << 24 | byteAt(content, k + 1) << 16 |
                               byteAt(content, k + 2) << 8 | byteAt(content, k + 3);
    const std::string_view name = content.substr(k + 4, 4);
    if (!isKnownChunk(name)) return "a PNG file with more in it than a picture";
    if (length > content.size() - k - kAround) break;
    k += kAround + length;
    if (name == "IEND") return k == content.size() ? "" : "a PNG file with more after its picture";
  }
  return "an incomplete PNG file";
}

}  // namespace

std::string whyNot(FileKind kind, std::string_view content) {
  switch (kind) {
    case FileKind::kText:
      return isText(content) ? "" : "not text";
    case FileKind::kImage:
      if (content.starts_with(kPng)) return whyNoPng(content);
      return content.starts_with(kExr) ? "" : "neither a PNG nor an OpenEXR file";
    case FileKind::kBytes:
      break;
  }
  return {};
}

}  // namespace pathmark::kit
