// What the picture is compared with, or why there is nothing.
//
//   ReferenceWish     what was chosen in the window
//   Reference         an image to compare with
//   FoundReference    that, or the reason why there is none
//   ReferenceFinder   from the wish to the reference
#pragma once

#include "host/reference.h"
#include "preview/picture.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace pathmark::preview {

enum class ReferenceSource {
  kShipped,  // scenes/references/NAME.exr
  kKept,     // a picture that was kept
  kFile
};

struct ReferenceWish {
  ReferenceSource source = ReferenceSource::kShipped;
  std::shared_ptr<const Picture> kept{};
  std::filesystem::path file{};
  std::uint64_t loads = 0;   // how often a file was asked for: it is read anew each time
  std::uint64_t number = 0;  // different for every wish
};

// Immutable once it is found.
struct Reference {
  std::shared_ptr<const Image> image;
  std::uint32_t replicates = 0;  // 0 without variances: it counts as exact
  std::string name;              // "the reference of cornell_box"
  std::uint64_t series = 0;      // of a kept picture; 0 of others
  std::uint64_t id = 0;          // the same as long as the pixels are
};

struct FoundReference {
  std::shared_ptr<const Reference> reference;  // null: `why` says why, and what to do
  std::string why;
  std::string note;  // about a reference that there is; may be empty
};

// Reads files, and is therefore not for the window's thread. What was read is kept.
class ReferenceFinder {
 public:
  // `shippedFile`: where the reference of a scene of this name would be.
  explicit ReferenceFinder(std::filesystem::path (*shippedFile)(const std::string&) = referenceFile)
      : shippedFile_(shippedFile) {}

  // Never throws for what is wrong with a file.
  FoundReference find(const ReferenceWish& wish, const std::shared_ptr<const Picture>& picture);

 private:
  FoundReference findShipped(const Picture& picture);
  FoundReference readShipped(const PreviewScene& scene);
  FoundReference findKept(const ReferenceWish& wish, const Picture& picture);
  FoundReference findFile(const ReferenceWish& wish, const Picture& picture);

  std::filesystem::path (*shippedFile_)(const std::string&);
  std::uint64_t newestId_ = 0;
  std::shared_ptr<const PreviewScene> shippedFor_;
  FoundReference shipped_;
  std::shared_ptr<const Picture> keptFor_;
  std::uint64_t loads_ = 0;
  FoundReference kept_, file_;
  std::string fileScene_;  // hash that the file has; may be empty
  std::string filePaths_;  // its light path expression
};

}  // namespace pathmark::preview
