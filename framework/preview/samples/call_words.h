// CallWords: arguments of a coursework function as the words of contract.h, and answers read.
#pragma once

#include <pathmark/types.h>

#include <bit>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

namespace pathmark::preview {

class CallWords {
 public:
  template <typename... T>
  CallWords& add(const T&... values) {
    (append(values), ...);
    return *this;
  }
  const std::vector<std::uint32_t>& words() const { return words_; }

 private:
  void append(std::floating_point auto x) {
    words_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
  }
  void append(std::integral auto x) { words_.push_back(static_cast<std::uint32_t>(x)); }
  void append(const vec3& v) { add(v.x, v.y, v.z); }

  std::vector<std::uint32_t> words_;
};

// From word number `at` on.
inline double numberAt(std::span<const std::uint32_t> answer, std::size_t at) {
  return static_cast<double>(std::bit_cast<float>(answer[at]));
}
inline glm::dvec3 vectorAt(std::span<const std::uint32_t> answer, std::size_t at) {
  return {numberAt(answer, at), numberAt(answer, at + 1), numberAt(answer, at + 2)};
}

}  // namespace pathmark::preview
