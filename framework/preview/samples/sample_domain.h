// SampleDomain: where a sampling function's points lie, and how densely they should.
//
//   Answer        what the function returned for one call
//   Marginal      one coordinate of a place, and how it should be distributed
//   Sketch        lines that show the domain
//   SampleDomain  all of this for one function and its parameters
//
// The expected density is the one that the contract names, in double.
#pragma once

#include "preview/samples/call_words.h"
#include "preview/samples/sample_numbers.h"
#include "preview/samples/sample_settings.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::preview {

struct Answer {
  glm::dvec3 place{0.0};          // a point, or a direction from the origin
  std::optional<double> claimed;  // the density that the function returned, if it does that
};

struct Marginal {
  std::string name;
  double low = 0.0, high = 1.0;  // of the axis that is shown
  std::function<double(const glm::dvec3& place)> coordinate;
  std::function<double(double from, double to)> mass;  // expected between these, in the axis
};

enum class StrokeKind { kEdge, kFaint, kNormal, kOutgoing, kMirror };

struct Stroke {
  StrokeKind kind = StrokeKind::kEdge;
  std::vector<glm::dvec3> points;  // an arrow's two, for the kinds after kFaint
};

struct Caption {
  glm::dvec3 at;
  std::string text;
};

struct Sketch {
  std::vector<Stroke> strokes;
  std::vector<Caption> captions;
  glm::dvec3 centre{0.0};
  double radius = 1.0;     // of what is to be seen, around the centre
  glm::dvec3 up{0, 1, 0};  // an axis
  bool flat = false;       // in the plane of x and y, to be looked at from z
};

class SampleDomain {
 public:
  virtual ~SampleDomain() = default;

  // A call, as contract.h lays it out.
  virtual CallWords object() const { return {}; }
  virtual void addCall(CallWords& calls, std::size_t index, const CallNumbers& numbers) const = 0;
  virtual Answer read(std::span<const std::uint32_t> answer) const = 0;

  // 0 where no sample belongs, also for what does not lie on the surface that is sampled.
  virtual double density(const glm::dvec3& place) const = 0;

  // Of samples where the density is 0: "lie below the surface".
  virtual std::string_view astray() const = 0;

  // A partition of the domain into about so many cells, and what is expected in each; of a place
  // of positive density.
  struct Cells {
    std::vector<double> masses;
    std::function<std::size_t(const glm::dvec3& place)> cellOf;
  };
  virtual Cells cells(std::size_t about) const = 0;

  virtual std::vector<Marginal> marginals() const = 0;
  virtual Sketch sketch() const = 0;

  // Where a place is drawn, in the sketch.
  virtual glm::dvec3 shown(const glm::dvec3& place) const { return place; }
};

std::unique_ptr<SampleDomain> makeSampleDomain(const SampleSettings& settings);

}  // namespace pathmark::preview
