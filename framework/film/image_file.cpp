#include "film/image_file.h"

#include "film/atomic_file.h"
#include "film/image_formats.h"
#include "film/read_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <new>

namespace pathmark {

namespace {

struct Format {
  std::string_view ending;
  std::string (*encode)(const Image&, double exposure, const ImageOrigin&);
  ImageFile (*decode)(std::string_view bytes);
  std::string_view loses;
};

constexpr std::array<Format, 4> kFormats{{
    {".exr",
     [](const Image& image, double, const ImageOrigin& origin) { return encodeExr(image, origin); },
     decodeExr, ""},
    {".hdr", [](const Image& image, double, const ImageOrigin&) { return encodeHdr(image); },
     [](std::string_view bytes) {
       return ImageFile{decodeHdr(bytes), {}};
     },
     "8 bits a value, with an exponent for each pixel"},
    {".pfm", [](const Image& image, double, const ImageOrigin&) { return encodePfm(image); },
     [](std::string_view bytes) {
       return ImageFile{decodePfm(bytes), {}};
     },
     ""},
    {".png",
     [](const Image& image, double exposure, const ImageOrigin&) {
       return encodePng(image, exposure);
     },
     [](std::string_view bytes) {
       return ImageFile{decodePng(bytes), {}};
     },
     "8 bits a value, after exposure and clipping"},
}};

const Format* formatOf(const std::filesystem::path& file) {
  const std::string ending = imageEnding(file);
  for (const Format& format : kFormats)
    if (format.ending == ending) return &format;
  return nullptr;
}

const Format& knownFormatOf(const std::filesystem::path& file) {
  std::string why;
  if (!imageFormatKnown(file, why)) throw ImageError(why);
  return *formatOf(file);
}

// Puts the file's name before what `work` has to say.
template <typename Work>
auto named(const std::filesystem::path& file, Work&& work) {
  try {
    return work();
  } catch (const ImageError& e) {
    throw ImageError(fmt::format("{}: {}", file.string(), e.what()));
  } catch (const std::bad_alloc&) {
    throw ImageError(fmt::format("{}: there is not enough memory for it.", file.string()));
  }
}

}  // namespace

std::string imageEnding(const std::filesystem::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool imageFormatKnown(const std::filesystem::path& file, std::string& why) {
  if (formatOf(file) != nullptr) return true;
  why = fmt::format("{}: the name of an image ends in .exr, .hdr, .png or .pfm.", file.string());
  return false;
}

std::string_view whatTheFormatLoses(const std::filesystem::path& file) {
  const Format* format = formatOf(file);
  return format == nullptr ? "" : format->loses;
}

void writeImage(const std::filesystem::path& file, const Image& image, double exposure,
                const ImageOrigin& origin) {
  const Format& format = knownFormatOf(file);
  writeFileAtomically(file, named(file, [&] { return format.encode(image, exposure, origin); }));
}

ImageFile readImage(const std::filesystem::path& file) {
  const Format& format = knownFormatOf(file);
  return named(file, [&] { return format.decode(readBytes(file)); });
}

Image readPfm(const std::filesystem::path& file) {
  return named(file, [&] { return decodePfm(readBytes(file)); });
}

}  // namespace pathmark
