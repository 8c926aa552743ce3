// Image files: what they hold besides pixels, and the formats by the file's ending.
//
//   ImageOrigin         how a picture was made; stored where the format can
//   writeImage          EXR to keep, PFM and HDR to compute with, PNG to look at
//   readImage           reads such a file back
//   whatTheFormatLoses  for judging differences between what was read
#pragma once

#include "film/image.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace pathmark {

struct ImageOrigin {
  std::string scene{};       // its name
  std::string sceneHash{};   // content hash of the scene as a worker gets it
  std::string coursework{};  // "student", "solutions", or the folder's name
  double raysPerPixel = 0.0;
  std::uint32_t raysPerPass = 0;
  std::uint32_t replicates = 1;
  std::uint32_t pixelsPerBlock = 1;  // whose paths served all of them
  std::uint64_t seed = 0;
  std::string sampler{};  // its name; empty if it is not known
  std::string paths{};    // light path expression; empty: all light, or it is not known
  double seconds = 0.0;   // of rendering
  // Of a picture made to a stated error: the wanted one and that of the worst tile, both relative.
  double targetError = 0.0, worstTileError = 0.0;
};

struct ImageFile {
  Image image;
  ImageOrigin origin;  // only .exr stores it
};

// Whether the ending of `file` is one that writeImage knows; if not, `why` becomes a sentence that
// says what is allowed.
bool imageFormatKnown(const std::filesystem::path& file, std::string& why);

// In small letters, with the dot.
std::string imageEnding(const std::filesystem::path& file);

// Half a sentence such as "8 bits a value"; empty if every bit is stored.
std::string_view whatTheFormatLoses(const std::filesystem::path& file);

// Replaces the file in one step: no reader ever sees half of it. Throws ImageError.
void writeImage(const std::filesystem::path& file, const Image& image, double exposure,
                const ImageOrigin& origin = {});

// Trusts nothing in the file, but keeps NaN and infinite pixels as they are. Throws ImageError.
ImageFile readImage(const std::filesystem::path& file);

// The same for a PFM file, whatever its ending.
Image readPfm(const std::filesystem::path& file);

}  // namespace pathmark
