#include "render/camera_hits.h"

#include <algorithm>
#include <array>

namespace pathmark {

void CameraHits::trace(std::span<const Ray> rays) {
  answers_.clear();
  next_ = 0;
  std::array<Hit, kMostInPacket> hits;
  while (!rays.empty()) {
    const std::size_t count = std::min(core_.packetSize(), rays.size());
    const std::uint32_t met = core_.intersect(rays.first(count), hits);
    for (std::size_t i = 0; i < count; ++i)
      answers_.push_back({rays[i], hits[i], (met >> i & 1u) != 0});
    rays = rays.subspan(count);
  }
}

}  // namespace pathmark
