// ProgressBoard: what a worker's render threads tell the host while they work, and the host's one
// word back. Lives in memory that both share; the host believes none of it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace pathmark {

inline constexpr int kMaxThreads = 256;

struct alignas(64) ThreadSlot {
  std::atomic<std::uint64_t> pixelsDone{0};  // pixels times passes, ever growing
  std::atomic<std::uint64_t> raysTraced{0};
  std::atomic<std::int32_t> threadId{0};        // of the operating system; 0 when not running
  std::atomic<std::int32_t> column{0}, row{0};  // of the pixel in work
};

struct ProgressBoard {
  std::atomic<std::uint32_t> cancel{0};  // set by the host: stop at the next pixel
  std::array<ThreadSlot, kMaxThreads> threads;
};

static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

}  // namespace pathmark
