// Images and files for tests.
#pragma once

#include "film/image_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace pathmark::test {

inline std::string readText(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void writeText(const std::filesystem::path& file, std::string_view text) {
  std::ofstream(file, std::ios::binary) << text;
}

// Every value differs from every other; `variance` gives all values this one.
inline Image gradientImage(int width, int height, float variance = 0.0f) {
  Image image{width, height};
  const int values = 3 * width * height;
  for (int i = 0; i < values; ++i)
    image.rgb.push_back(static_cast<float>(i + 1) / static_cast<float>(values));
  if (variance > 0.0f) image.variance.assign(image.rgb.size(), variance);
  return image;
}

// The sentence that `work` throws as an ImageError; "nothing was thrown" if it does not.
template <typename Work>
std::string sentenceOf(Work&& work) {
  try {
    work();
  } catch (const ImageError& e) {
    return e.what();
  }
  return "nothing was thrown";
}

}  // namespace pathmark::test
