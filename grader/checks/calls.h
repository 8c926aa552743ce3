// Calls: many calls of one coursework function at once, with typed arguments and results.
//
//   Calls calls(F::kSampleHemisphere);
//   calls.add(u, n);  calls.add(v, n);
//   const Results results = calls.run(worker);
//   results.vector(1, 0)    of the call number 1, beginning with its word 0
#pragma once

#include "host/worker_process.h"

#include <pathmark/types.h>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

namespace pathmark::checks {

// Appends arguments as the words of contract.h.
class Words {
 public:
  template <typename... T>
  Words& add(const T&... values) {
    (append(values), ...);
    return *this;
  }
  const std::vector<std::uint32_t>& words() const { return words_; }

 private:
  void append(float x) { words_.push_back(std::bit_cast<std::uint32_t>(x)); }
  void append(double x) { append(static_cast<float>(x)); }
  void append(std::integral auto x) { words_.push_back(static_cast<std::uint32_t>(x)); }
  void append(const vec2& v) { add(v.x, v.y); }
  void append(const uvec2& v) { add(v.x, v.y); }
  void append(const vec3& v) { add(v.x, v.y, v.z); }
  void append(const Ray& ray) { add(ray.origin, ray.direction); }
  template <typename T>
  void append(const std::vector<T>& all) {
    for (const T& x : all) append(x);
  }

  std::vector<std::uint32_t> words_;
};

class Results {
 public:
  Results(std::vector<std::uint32_t> words, std::size_t stride)
      : words_(std::move(words)), stride_(stride) {}

  std::size_t count() const { return words_.size() / stride_; }
  std::uint32_t word(std::size_t call, std::size_t at) const { return words_[call * stride_ + at]; }
  float number(std::size_t call, std::size_t at) const {
    return std::bit_cast<float>(word(call, at));
  }
  vec3 vector(std::size_t call, std::size_t at) const {
    return {number(call, at), number(call, at + 1), number(call, at + 2)};
  }
  // Whether two calls gave the same bits.
  bool same(std::size_t a, std::size_t b) const {
    return std::equal(words_.begin() + static_cast<std::ptrdiff_t>(a * stride_),
                      words_.begin() + static_cast<std::ptrdiff_t>((a + 1) * stride_),
                      words_.begin() + static_cast<std::ptrdiff_t>(b * stride_));
  }
  // Whether all words of a call are finite as floats.
  bool finite(std::size_t call) const {
    for (std::size_t at = 0; at < stride_; ++at)
      if (!std::isfinite(number(call, at))) return false;
    return true;
  }

 private:
  std::vector<std::uint32_t> words_;
  std::size_t stride_;
};

class Calls {
 public:
  explicit Calls(CourseworkFunction function, Words object = {})
      : function_(function), object_(std::move(object)) {}

  template <typename... T>
  void add(const T&... arguments) {
    inputs_.add(arguments...);
  }

  std::size_t count() const { return inputs_.words().size() / contractOf(function_).inputWords; }

  Results run(WorkerProcess& worker) const {
    return {worker.call(function_, object_.words(), inputs_.words()),
            contractOf(function_).outputWords};
  }

 private:
  CourseworkFunction function_;
  Words object_, inputs_;
};

}  // namespace pathmark::checks
