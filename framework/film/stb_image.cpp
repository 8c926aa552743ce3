#include "film/image_limits.h"

#include <cstdlib>

namespace {

// A few bytes of a PNG file can unpack to gigabytes. The largest image as 16-bit RGBA, with a byte
// for each row, needs no more than this.
constexpr std::size_t kMostBytes =
    std::size_t{pathmark::kMostPixels} * 8 + pathmark::kMostPixelsPerSide;

void* limitedRealloc(void* old, std::size_t bytes) {
  return bytes > kMostBytes ? nullptr : std::realloc(old, bytes);
}

}  // namespace

#define STBI_MALLOC(bytes) limitedRealloc(nullptr, bytes)
#define STBI_REALLOC(old, bytes) limitedRealloc(old, bytes)
#define STBI_FREE(old) std::free(old)

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>
