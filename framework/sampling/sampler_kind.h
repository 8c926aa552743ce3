// SamplerKind: which points a render is made with, and the names that people know them by.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace pathmark {

enum class SamplerKind : std::uint32_t {
  kSobol = 0,
  kStratified = 1,
  kPcg = 2,
  kCorners = 3,  // of tests only, and without a name: see corner_sampler.h
};

inline constexpr std::array<std::string_view, 3> kSamplerNames{"sobol", "stratified", "pcg"};

constexpr std::string_view nameOf(SamplerKind kind) {
  const auto k = static_cast<std::size_t>(kind);
  return k < kSamplerNames.size() ? kSamplerNames[k] : "corners";
}

constexpr std::optional<SamplerKind> samplerNamed(std::string_view name) {
  for (std::size_t k = 0; k < kSamplerNames.size(); ++k)
    if (kSamplerNames[k] == name) return static_cast<SamplerKind>(k);
  return std::nullopt;
}

}  // namespace pathmark
