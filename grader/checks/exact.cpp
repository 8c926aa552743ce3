#include "checks/exact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::checks {

namespace {

constexpr double kRoundoff = 0x1p-24;

}  // namespace

double relativeTolerance(double condition) { return std::max(1e-4, 16.0 * kRoundoff * condition); }

std::string text(double x) { return fmt::format("{:.6g}", x); }
std::string text(const vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

Exact::Exact(std::initializer_list<const char*> suspects) {
  for (const char* mistake : suspects) suspects_.push_back({mistake});
}

// Kept is the first value that is wrong: inputs come from plain ones to rare ones, and the plain
// one teaches more.
bool Exact::value(std::string_view what, double got, double expected, double allowed,
                  const Where& where, std::initializer_list<double> alternatives) {
  const bool right = std::abs(got - expected) <= allowed;
  std::size_t k = 0;
  for (const double alternative : alternatives) {
    Suspect& suspect = suspects_.at(k++);
    const double relative = expected != 0.0 ? allowed / std::abs(expected) : 0.0;
    const double slack = std::max(allowed, relative * std::abs(alternative));
    const bool bothUndefined = std::isnan(got) && std::isnan(alternative);
    if (!(std::abs(got - alternative) <= slack) && !bothUndefined) suspect.possible = false;
    if (!(std::abs(alternative - expected) <= 2.0 * slack)) suspect.differs = true;
  }
  if (right) return true;
  if (!failed_) {
    first_.status = Status::kFail;
    first_.where = where();
    first_.expected = fmt::format("{} = {}", what, text(expected));
    first_.got = fmt::format("{} = {}", what, text(got));
    first_.tolerance = fmt::format("{:.2g}", allowed);
  }
  failed_ = true;
  return false;
}

bool Exact::holds(bool condition, std::string_view expected,
                  const std::function<std::string()>& got, const Where& where) {
  if (condition) return true;
  if (!failed_) {
    first_.status = Status::kFail;
    first_.where = where();
    first_.expected = expected;
    first_.got = got();
  }
  failed_ = true;
  return false;
}

bool Exact::unit(std::string_view what, const vec3& direction, const Where& where) {
  return value(fmt::format("length of {}", what), glm::length(glm::dvec3(direction)), 1.0,
               8.0 * kRoundoff, where);
}

Finding Exact::finding() const {
  Finding result = first_;
  result.calls = calls_;
  if (!failed_) return result;
  std::vector<std::string> causes;
  for (const Suspect& s : suspects_)
    if (s.possible && s.differs) causes.push_back(s.mistake);
  if (causes.size() == 1) result.cause = causes.front();
  return result;
}

}  // namespace pathmark::checks
