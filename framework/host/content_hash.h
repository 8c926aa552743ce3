// contentHash: 32 hexadecimal digits that stand for a text; ContentHasher for one that comes in
// pieces.
//
// Two independent FNV-1a hashes (Fowler, Noll & Vo) of 64 bits: against accidents, not against
// somebody who looks for collisions.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pathmark {

class ContentHasher {
 public:
  void add(std::string_view text) {
    constexpr std::uint64_t kPrime = 0x100000001b3ull;
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      a_ = (a_ ^ byte) * kPrime;
      b_ = (b_ * kPrime) ^ byte;
    }
  }

  void add(std::span<const std::byte> bytes) {
    add(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  }

  std::string digits() const { return fmt::format("{:016x}{:016x}", a_, b_); }

 private:
  std::uint64_t a_ = 0xcbf29ce484222325ull, b_ = 0x84222325cbf29ce4ull;
};

inline std::string contentHash(std::string_view text) {
  ContentHasher hasher;
  hasher.add(text);
  return hasher.digits();
}

}  // namespace pathmark
