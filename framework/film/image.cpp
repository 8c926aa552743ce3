#include "film/image.h"

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

Image imageFromFilm(int width, int height, std::span<const FilmPixel> film) {
  Image image{width, height, {}, {}};
  image.rgb.reserve(film.size() * 3);
  for (std::size_t i = 0; i < film.size(); ++i) {
    const FilmPixel& pixel = film[i];
    const bool valid = pixel.rays > 0.0;
    if (!valid) {
      image.invalid.resize(film.size());
      image.invalid[i] = 1;
    }
    for (const double sum : pixel.sum)
      image.rgb.push_back(valid ? static_cast<float>(sum / pixel.rays) : 0.0f);
  }
  return image;
}

bool imageFormatKnown(const std::filesystem::path& file, std::string& why) {
  const std::string known = ending(file);
  if (known == ".png" || known == ".pfm") return true;
  why = fmt::format("{}: the name of an image ends in .png or .pfm.", file.string());
  return false;
}

void writeImage(const std::filesystem::path& file, const Image& image, double exposure) {
  std::string why;
  if (!imageFormatKnown(file, why)) throw ImageError(why);
  writeFileAtomically(file, ending(file) == ".png" ? encodePng(image, exposure) : encodePfm(image));
}

}  // namespace pathmark
