#include "diagnosis/signature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pathmark::diagnosis {

namespace {

constexpr double kSlack = 5e-5;

}  // namespace

void Signature::add(std::string what, double value, double error, double scale) {
  if (!std::isfinite(value) || !std::isfinite(error)) {
    value = std::numeric_limits<double>::quiet_NaN();
    error = 0.0;
  }
  features_.push_back({std::move(what), value, error, kSlack * scale});
}

void Signature::addAnswer(std::string question, bool yes) {
  add(std::move(question), yes ? 1.0 : 0.0);
  features_.back().isAnswer = true;
}

void Replicates::divideBy(double points) {
  for (double& value : values_) value /= points;
}

double Replicates::mean(std::size_t k) const {
  double sum = 0.0;
  for (std::uint32_t r = 0; r < count_; ++r) sum += values_[r * width_ + k];
  return sum / count_;
}

double Replicates::error(std::size_t k) const {
  const double centre = mean(k), n = count_;
  double squares = 0.0;
  for (std::uint32_t r = 0; r < count_; ++r) {
    const double off = values_[r * width_ + k] - centre;
    squares += off * off;
  }
  return std::sqrt(squares / (n * (n - 1.0)));
}

void Replicates::add(Signature& signature, std::string what, std::size_t k, double scale) const {
  signature.add(std::move(what), mean(k), error(k), scale);
}

void Replicates::addLength(Signature& signature, std::string what,
                           std::initializer_list<std::size_t> means, double scale) const {
  double squares = 0.0, largest = 0.0;
  for (const std::size_t k : means) {
    squares += mean(k) * mean(k);
    largest = std::max(largest, error(k));
  }
  signature.add(std::move(what), std::sqrt(squares), largest, scale);
}

}  // namespace pathmark::diagnosis
