#include "film/image.h"

namespace pathmark {

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

}  // namespace pathmark
