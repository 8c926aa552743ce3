// Exact: values compared one by one with what they must be.
//
// A suspect is a known mistake, with the value that it would give: where it explains every value
// that was seen, and some of them are wrong, it is the likely cause.
#pragma once

#include "checks/check.h"

#include <pathmark/types.h>

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace pathmark::checks {

// The contract's tolerance, relative: 1e-4, or where the value is ill-conditioned 16 roundings of
// its inputs. `condition`: relative change of the value per relative change of an input.
double relativeTolerance(double condition = 1.0);

using Where = std::function<std::string()>;

class Exact {
 public:
  explicit Exact(std::initializer_list<const char*> suspects = {});

  // `allowed` is an absolute error. `alternatives`: the suspects' values, in their order; NaN where
  // a mistake gives NaN. Returns whether the value is right.
  bool value(std::string_view what, double got, double expected, double allowed, const Where& where,
             std::initializer_list<double> alternatives = {});

  // A statement that holds or does not.
  bool holds(bool condition, std::string_view expected, const std::function<std::string()>& got,
             const Where& where);

  // An answer that is right or wrong as a whole, and how to put it. `alternatives`: the suspects'.
  template <typename T>
  bool answer(const T& got, const T& expected, std::string_view expectedText,
              const std::function<std::string()>& gotText, const Where& where,
              std::initializer_list<T> alternatives = {}) {
    std::size_t k = 0;
    for (const T& alternative : alternatives) {
      Suspect& suspect = suspects_.at(k++);
      if (!(alternative == got)) suspect.possible = false;
      if (!(alternative == expected)) suspect.differs = true;
    }
    return holds(got == expected, expectedText, gotText, where);
  }

  // Unit length, to 8 roundings.
  bool unit(std::string_view what, const vec3& direction, const Where& where);

  void count(std::uint64_t calls) { calls_ += calls; }
  bool failed() const { return failed_; }
  Finding finding() const;

 private:
  struct Suspect {
    std::string mistake;
    bool possible = true;
    bool differs = false;  // from what is right, at some input
  };

  std::vector<Suspect> suspects_;
  Finding first_;
  bool failed_ = false;
  double worst_ = 0.0;
  std::uint64_t calls_ = 0;
};

std::string text(const vec3& v);
std::string text(double x);

}  // namespace pathmark::checks
