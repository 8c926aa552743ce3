// contentHash: 32 hexadecimal digits that stand for a text.
//
// Two independent FNV-1a hashes (Fowler, Noll & Vo) of 64 bits: against accidents, not against
// somebody who looks for collisions.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace pathmark {

inline std::string contentHash(std::string_view text) {
  constexpr std::uint64_t kPrime = 0x100000001b3ull;
  std::uint64_t a = 0xcbf29ce484222325ull, b = 0x84222325cbf29ce4ull;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    a = (a ^ byte) * kPrime;
    b = (b * kPrime) ^ byte;
  }
  return fmt::format("{:016x}{:016x}", a, b);
}

}  // namespace pathmark
