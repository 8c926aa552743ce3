// Radiance's RGBE files (Ward, "Real Pixels", Graphics Gems II, 1991).
//
// They are written by stb_image_write, and read here: stb_image in the distributions does not end
// on a file that is cut off within a run.
#include "film/image_formats.h"
#include "film/image_limits.h"

#include <fmt/format.h>
#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace pathmark {

namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// stb cuts the mantissas off, which makes a picture darker by 0.3 % in the mean. Multiples of the
// pixel's step pass it unchanged.
std::array<float, 3> nearestRgbe(const float* rgb) {
  constexpr double kLargest = 0x1.fep126;  // 255 steps of the largest exponent that stays finite
  std::array<double, 3> values{};
  for (std::size_t c = 0; c < 3; ++c)
    values[c] = rgb[c] > 0.0f ? std::min(static_cast<double>(rgb[c]), kLargest) : 0.0;
  int exponent = 0;
  const double largest = *std::max_element(values.begin(), values.end());
  const double mantissa = std::frexp(largest, &exponent);
  if (mantissa >= 255.5 / 256.0) ++exponent;
  const double step = std::ldexp(1.0, exponent - 8);
  std::array<float, 3> rounded{};
  for (std::size_t c = 0; c < 3; ++c)
    rounded[c] = static_cast<float>(std::round(values[c] / step) * step);
  return rounded;
}

// Zero bytes read past the end would be black pixels: the reader keeps count of them.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : left_(bytes) {}

  std::uint8_t next() {
    if (left_.empty()) throw ImageError("the file ends before its last pixel.");
    const char c = left_.front();
    left_.remove_prefix(1);
    return static_cast<std::uint8_t>(c);
  }
  Rgbe nextPixel() { return {next(), next(), next(), next()}; }

  // Without the line's end; nothing after the last one.
  std::optional<std::string_view> line() {
    const std::size_t end = left_.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view text = left_.substr(0, end);
    left_.remove_prefix(end + 1);
    return text;
  }
  std::string_view left() const { return left_; }

 private:
  std::string_view left_;
};

// "-Y 480 +X 640": rows from the top, pixels from the left.
bool parseResolution(std::string_view line, std::int64_t& width, std::int64_t& height) {
  const auto number = [&line](std::string_view before, std::int64_t& value) {
    if (!line.starts_with(before)) return false;
    line.remove_prefix(before.size());
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc{}) return false;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return true;
  };
  return number("-Y ", height) && number(" +X ", width) && line.empty();
}

void readHeader(Bytes& in, std::int64_t& width, std::int64_t& height) {
  bool rgbe = false;
  std::optional<std::string_view> line = in.line();
  if (!line || !line->starts_with("#?")) throw ImageError("this is no HDR image: #? comes first.");
  while ((line = in.line()) && !line->empty())
    rgbe = rgbe || line->starts_with("FORMAT=32-bit_rle_rgbe");
  if (!line || !rgbe)
    throw ImageError("the header of this HDR image names no FORMAT=32-bit_rle_rgbe.");
  line = in.line();
  if (!line || !parseResolution(*line, width, height))
    throw ImageError("the header of this HDR image has no line such as -Y 480 +X 640.");
}

// One channel after the other; a length above 128 is a run of one value, else values follow.
void readRuns(Bytes& in, std::span<Rgbe> row) {
  for (std::size_t channel = 0; channel < 4; ++channel)
    for (std::size_t at = 0; at < row.size();) {
      const std::uint8_t code = in.next();
      const std::size_t length = code > 128 ? code - 128u : code;
      if (length == 0 || length > row.size() - at)
        throw ImageError("a run of this HDR image does not fit into its row.");
      const std::uint8_t repeated = code > 128 ? in.next() : std::uint8_t{0};
      for (std::size_t i = 0; i < length; ++i)
        row[at++][channel] = code > 128 ? repeated : in.next();
    }
}

// Rows of 8 to 32767 pixels may come in runs: behind 2, 2 and the width, which is no pixel.
void readRow(Bytes& in, std::span<Rgbe> row) {
  const std::string_view left = in.left();
  const bool runs = row.size() >= 8 && row.size() < 32768 && left.size() >= 4 && left[0] == 2 &&
                    left[1] == 2 && static_cast<std::uint8_t>(left[2]) == row.size() >> 8 &&
                    static_cast<std::uint8_t>(left[3]) == (row.size() & 255);
  if (!runs) {
    for (Rgbe& pixel : row) pixel = in.nextPixel();
    return;
  }
  in.nextPixel();
  readRuns(in, row);
}

void appendToString(void* to, void* data, int size) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                        static_cast<std::size_t>(size));
}

}  // namespace

std::string encodeHdr(const Image& image) {
  std::vector<float> rgb;
  rgb.reserve(image.rgb.size());
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    for (const float value : nearestRgbe(&image.rgb[i])) rgb.push_back(value);
  std::string bytes;
  if (stbi_write_hdr_to_func(appendToString, &bytes, image.width, image.height, 3, rgb.data()) == 0)
    throw ImageError("the image could not be encoded as HDR.");
  return bytes;
}

Image decodeHdr(std::string_view bytes) {
  Bytes in(bytes);
  std::int64_t width = 0, height = 0;
  readHeader(in, width, height);
  requireImageSize(width, height);
  Image image{static_cast<int>(width), static_cast<int>(height), {}, {}, {}};
  std::vector<Rgbe> row(static_cast<std::size_t>(width));
  for (std::int64_t j = 0; j < height; ++j) {
    readRow(in, row);
    for (const auto& [r, g, b, e] : row) {
      // Exponent 0 is black.
      const double step = e == 0 ? 0.0 : std::ldexp(1.0, e - (128 + 8));
      for (const std::uint8_t mantissa : {r, g, b})
        image.rgb.push_back(static_cast<float>(mantissa * step));
    }
  }
  return image;
}

}  // namespace pathmark
