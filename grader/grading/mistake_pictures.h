// MistakePictures: what known mistakes do to the scenes of a class.
#pragma once

#include "host/coursework_builder.h"
#include "marking/pictures.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace pathmark::grading {

// Safe to use from several threads: they wait for each other only where they want the same one.
class MistakePictures {
 public:
  // The solutions must outlive this object.
  MistakePictures(const CourseworkBuild& solutions, std::uint64_t seed)
      : solutions_(solutions), seed_(seed) {}

  // The scene by the solutions with the wrong variant of this name in place of its part, each made
  // once. Nothing if no variant has the name, or if there is no picture of it, since it crashes or
  // never ends.
  const std::optional<Image>& of(const std::string& mistake, const marking::MarkingScene& scene,
                                 unsigned threads);

 private:
  struct Entry {
    std::once_flag made;
    std::optional<Image> picture;
  };

  std::optional<Image> make(const std::string& mistake, const marking::MarkingScene& scene,
                            unsigned threads) const;

  const CourseworkBuild& solutions_;
  std::uint64_t seed_;
  std::mutex mutex_;
  std::map<std::pair<std::string, std::string>, std::unique_ptr<Entry>> entries_;
};

}  // namespace pathmark::grading
