// Calls of coursework functions, put into words and read from them (see worker/contract.h).
#pragma once

#include <pathmark/types.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pathmark::bench {

class CallWords {
 public:
  template <class... Values>
  CallWords& add(const Values&... values) {
    (put(values), ...);
    return *this;
  }
  operator std::span<const std::uint32_t>() const { return words_; }
  std::size_t size() const { return words_.size(); }

 private:
  void put(std::uint32_t word) { words_.push_back(word); }
  void put(int word) { put(static_cast<std::uint32_t>(word)); }
  void put(float number) { put(std::bit_cast<std::uint32_t>(number)); }
  void put(const vec3& v) { add(v.x, v.y, v.z); }

  std::vector<std::uint32_t> words_;
};

class AnswerWords {
 public:
  explicit AnswerWords(std::span<const std::uint32_t> words) : words_(words) {}

  bool atEnd() const { return at_ == words_.size(); }
  std::uint32_t word() { return words_[at_++]; }
  float number() { return std::bit_cast<float>(word()); }
  vec3 vector() {
    const float x = number(), y = number();
    return {x, y, number()};
  }
  LightSample lightSample() {
    LightSample sample;
    sample.p = vector();
    sample.n = vector();
    sample.pdf = number();
    return sample;
  }

 private:
  std::span<const std::uint32_t> words_;
  std::size_t at_ = 0;
};

}  // namespace pathmark::bench
