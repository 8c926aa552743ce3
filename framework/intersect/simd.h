// The vectors of floats that primitives are met in, as many lanes as the processor's registers
// have.
//
//   FloatV, kLanes   the vector
//   LaneArray        memory for one
//   load             memory -> vector
//   plusProduct      a + b c, and
//   minusProduct     a - b c: rounded once where the processor can
//   NearestV         the nearest hit of each lane, and of all of them
#pragma once

#include "intersect/primitive_hit.h"

// GCC 12 warns of its own AVX-512 functions, which begin with an undefined vector on purpose.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <experimental/simd>
#if defined(__FMA__) && defined(__AVX__)
#include <immintrin.h>
#endif
#pragma GCC diagnostic pop

#include <bit>
#include <cstdint>
#include <limits>

namespace pathmark {

namespace simd = std::experimental;

using FloatV = simd::native_simd<float>;

inline constexpr std::size_t kLanes = FloatV::size();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct alignas(simd::memory_alignment_v<FloatV>) LaneArray {
  float lane[kLanes];
};

inline FloatV load(const LaneArray& a) { return {a.lane, simd::vector_aligned}; }

#if defined(__FMA__) && defined(__AVX512F__)
inline FloatV plusProduct(const FloatV& a, const FloatV& b, const FloatV& c) {
  return FloatV(
      _mm512_fmadd_ps(static_cast<__m512>(b), static_cast<__m512>(c), static_cast<__m512>(a)));
}
inline FloatV minusProduct(const FloatV& a, const FloatV& b, const FloatV& c) {
  return FloatV(
      _mm512_fnmadd_ps(static_cast<__m512>(b), static_cast<__m512>(c), static_cast<__m512>(a)));
}
#elif defined(__FMA__) && defined(__AVX__)
inline FloatV plusProduct(const FloatV& a, const FloatV& b, const FloatV& c) {
  return FloatV(
      _mm256_fmadd_ps(static_cast<__m256>(b), static_cast<__m256>(c), static_cast<__m256>(a)));
}
inline FloatV minusProduct(const FloatV& a, const FloatV& b, const FloatV& c) {
  return FloatV(
      _mm256_fnmadd_ps(static_cast<__m256>(b), static_cast<__m256>(c), static_cast<__m256>(a)));
}
#else
inline FloatV plusProduct(const FloatV& a, const FloatV& b, const FloatV& c) { return a + b * c; }
inline FloatV minusProduct(const FloatV& a, const FloatV& b, const FloatV& c) { return a - b * c; }
#endif

// Indices are kept in the bits of floats: nothing is computed with them.
inline float bitsOfIndex(std::uint32_t index) { return std::bit_cast<float>(index); }

// The nearest hit so far in each lane, and which primitive it is with.
struct NearestV {
  FloatV t;
  FloatV index = 0.0f;  // bits

  explicit NearestV(float tMax) : t(tMax) {}

  [[gnu::always_inline]] void take(const FloatV::mask_type& met, const FloatV& newT,
                                   const FloatV& newIndex) {
    const FloatV::mask_type nearer = met && newT > 0.0f && newT < t;
    where(nearer, t) = newT;
    where(nearer, index) = newIndex;
  }

  // The nearest of all lanes: sets `hit` if there is one before tMax.
  bool reduce(float tMax, PrimitiveHit& hit) const {
    const float least = hmin(t);
    if (!(least < tMax)) return false;
    hit.t = least;
    hit.index = std::bit_cast<std::uint32_t>(float{index[find_first_set(t == least)]});
    return true;
  }
};

}  // namespace pathmark
