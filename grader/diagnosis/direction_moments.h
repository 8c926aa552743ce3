// DirectionMoments: how directions, and densities that are returned with them, lie around an axis.
//
// The moments do not depend on where the azimuth begins or which way it runs.
#pragma once

#include "checks/double_frame.h"
#include "diagnosis/signature.h"

#include <pathmark/types.h>

#include <string>

namespace pathmark::diagnosis {

class DirectionMoments {
 public:
  DirectionMoments(const Vector& axis, std::uint32_t replicates);

  // `weight` 1, or one that makes samples of different densities alike.
  void add(std::uint32_t replicate, const Vector& direction, double weight = 1.0);
  void invalid(std::uint32_t replicate);

  // A density that was returned, what the contract names there, and what pdf() says there. The
  // shares a / (a + b) that are taken of them have bounds, whatever they are.
  void densities(std::uint32_t replicate, double returned, double named, double own);

  enum class Densities { kNone, kOwn, kNamed };  // kNamed: both

  void addTo(Signature& signature, const std::string& where, std::uint32_t pointsOfReplicate,
             Densities densities);

 private:
  checks::DoubleFrame frame_;
  Replicates sums_;
};

}  // namespace pathmark::diagnosis
