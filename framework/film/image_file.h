// Image files: what they hold besides pixels, and the formats by the file's ending.
//
//   ImageOrigin   how a picture was made; stored where the format can
//   writeImage    PNG for looking at, PFM for computing with
//   readImage     reads such a file back
#pragma once

#include "film/image.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace pathmark {

struct ImageOrigin {
  std::string scene;       // its name
  std::string sceneHash;   // content hash of the scene as a worker gets it
  std::string coursework;  // "student", "solutions", or the folder's name
  double raysPerPixel = 0.0;
  std::uint32_t raysPerPass = 0;
  std::uint32_t replicates = 1;
  std::uint64_t seed = 0;
  double seconds = 0.0;  // of rendering
};

struct ImageFile {
  Image image;
  ImageOrigin origin;
};

// 8-bit sRGB of exposure * radiance, clipped at 1; invalid pixels in magenta.
std::string encodePng(const Image& image, double exposure);

// 32-bit floats, little-endian, rows from the bottom (Debevec's portable float map).
std::string encodePfm(const Image& image);

// Reads what encodePfm wrote, or another PFM with three channels. Throws ImageError.
Image readPfm(const std::filesystem::path& file);

// Whether the ending of `file` is one that writeImage knows; if not, `why` becomes a sentence that
// says what is allowed.
bool imageFormatKnown(const std::filesystem::path& file, std::string& why);

// Replaces the file in one step: no reader ever sees half of it. Throws ImageError.
void writeImage(const std::filesystem::path& file, const Image& image, double exposure,
                const ImageOrigin& origin = {});

// Throws ImageError.
ImageFile readImage(const std::filesystem::path& file);

}  // namespace pathmark
