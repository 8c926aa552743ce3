// Skips: what a plan leaves out because a scene does not need it, as switches.
//
// All are on in every render; `pathmark bench skip` turns them off one by one, to measure what each
// saves. They are looked at when a scene is loaded, never while rays are traced.
#pragma once

#include <cstdint>

namespace pathmark {

enum class Skip : std::uint32_t {
  kHierarchyOfFew = 1,    // few triangles are met in a flat loop, without a hierarchy
  kLoopOverMany = 2,      // many are met through a hierarchy, without a loop over all
  kBoundingSurfaces = 4,  // shadow rays are not tested against what bounds the scene
  kSecondTriangles = 8,   // two triangles that make a quad are met as one
  kBackTests = 16,        // backs are not asked for where no triangle has a front only
  kEmptyKinds = 32,       // no sphere test without spheres, no triangle test without triangles
  kSingleCameraRays = 64  // those of a pixel go through a hierarchy together, not one by one
};

class Skips {
 public:
  constexpr Skips() = default;
  explicit constexpr Skips(std::uint32_t bits) : bits_(bits) {}

  constexpr bool has(Skip skip) const { return (bits_ & static_cast<std::uint32_t>(skip)) != 0; }
  constexpr Skips without(Skip skip) const {
    return Skips(bits_ & ~static_cast<std::uint32_t>(skip));
  }
  constexpr std::uint32_t bits() const { return bits_; }

 private:
  std::uint32_t bits_ = ~0u;  // of all skips
};

}  // namespace pathmark
