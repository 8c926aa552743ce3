#include "film/image_file.h"

#include "film/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace pathmark {

namespace {

std::string ending(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

bool imageFormatKnown(const std::filesystem::path& file, std::string& why) {
  const std::string known = ending(file);
  if (known == ".png" || known == ".pfm") return true;
  why = fmt::format("{}: the name of an image ends in .png or .pfm.", file.string());
  return false;
}

void writeImage(const std::filesystem::path& file, const Image& image, double exposure,
                const ImageOrigin& origin) {
  static_cast<void>(origin);
  std::string why;
  if (!imageFormatKnown(file, why)) throw ImageError(why);
  writeFileAtomically(file, ending(file) == ".png" ? encodePng(image, exposure) : encodePfm(image));
}

ImageFile readImage(const std::filesystem::path& file) { return {readPfm(file), {}}; }

}  // namespace pathmark
