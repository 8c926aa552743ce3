#include "kit/file_kind.h"

#include "scene/utf8.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace pathmark::kit {

namespace {

std::uint32_t byteAt(std::string_view content, std::size_t k) {
  return static_cast<unsigned char>(content[k]);
}

bool isControl(char32_t code) {
  return code == 0x7f || (code < 0x20 && code != '\t' && code != '\n' && code != '\r');
}

bool isText(std::string_view content) {
  while (!content.empty()) {
    const Utf8Character first = firstCharacter(content);
    if (first.bytes == 0 || isControl(first.code)) return false;
    content.remove_prefix(first.bytes);
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
