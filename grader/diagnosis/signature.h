// Signature: what a function does with fixed inputs, as numbers.
//
//   Feature        one of them, with its standard error and what rounding may do to it
//   Signature      all of them, in an order that depends on the function only
//   Replicates     means over independently randomised replicates, which become features
//
// Its words are read by students, as evidence: "mean of cos(theta) is 0.6366 (right: 0.6667; ...)",
// "whether the first number is below 1: no (right: yes; ...)".
//
// A feature must not depend on choices that the contract leaves open: which number moves a point
// which way, which frame, which map, which probability of a lobe. So samplers are described by
// moments that are the same for all of those.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace pathmark::diagnosis {

struct Feature {
  std::string what;       // "mean of cos(theta), n = (0, 0, 1)"
  double value = 0.0;     // NaN: it cannot be measured, or is not finite
  double error = 0.0;     // standard error
  double slack = 0.0;     // a difference that rounding may make
  bool isAnswer = false;  // to a question, "whether ...": 1 is yes, 0 is no
};

class Signature {
 public:
  const std::vector<Feature>& features() const { return features_; }

  // `scale`: a typical size of the value, of which rounding may change one part in 20,000.
  void add(std::string what, double value, double error = 0.0, double scale = 1.0);

  // "whether ..."
  void addAnswer(std::string question, bool yes);

 private:
  std::vector<Feature> features_;
};

class Replicates {
 public:
  Replicates(std::uint32_t replicates, std::size_t means)
      : count_(replicates), width_(means), values_(replicates * means, 0.0) {}

  std::uint32_t count() const { return count_; }
  std::span<double> of(std::uint32_t replicate) {
    return std::span(values_).subspan(replicate * width_, width_);
  }
  // All sums, over so many points each, become means.
  void divideBy(double points);

  double mean(std::size_t k) const;
  double error(std::size_t k) const;

  void add(Signature& signature, std::string what, std::size_t k, double scale = 1.0) const;

  // The length of the vector of these means, which no turn and no mirror changes.
  void addLength(Signature& signature, std::string what, std::initializer_list<std::size_t> means,
                 double scale = 1.0) const;

 private:
  std::uint32_t count_;
  std::size_t width_;
  std::vector<double> values_;
};

}  // namespace pathmark::diagnosis
