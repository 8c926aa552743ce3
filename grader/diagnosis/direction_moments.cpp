#include "diagnosis/direction_moments.h"

#include <cmath>

namespace pathmark::diagnosis {

namespace {

enum Sum : std::size_t {
  kInvalid,
  kWeight,
  kNotUnit,
  kBelow,
  kZ,
  kZ2,
  kX,
  kY,
  kXz,
  kYz,
  kCos2,
  kSin2,
  kOffOwn,
  kOwn,
  kNamed,
  kNamedZ,
  kNoDensity,
  kSums
};

double share(double a, double b) {
  if (!(a + b > 0.0)) return 0.5;
  return std::isinf(a) && std::isinf(b) ? 0.5 : std::isinf(a) ? 1.0 : a / (a + b);
}

}  // namespace

DirectionMoments::DirectionMoments(const Vector& axis, std::uint32_t replicates)
    : frame_(glm::dvec3(axis)), sums_(replicates, kSums) {}

void DirectionMoments::invalid(std::uint32_t replicate) { sums_.of(replicate)[kInvalid] += 1.0; }

void DirectionMoments::add(std::uint32_t replicate, const Vector& direction, double weight) {
  const auto sums = sums_.of(replicate);
  const glm::dvec3 d = frame_.local(glm::dvec3(direction));
  const double length2 = glm::dot(d, d);
  if (!std::isfinite(length2) || !std::isfinite(weight)) return invalid(replicate);
  sums[kWeight] += weight;
  if (std::abs(length2 - 1.0) > 1e-5) sums[kNotUnit] += 1.0;
  if (d.y < 0.0) sums[kBelow] += 1.0;
  sums[kZ] += weight * d.y;
  sums[kZ2] += weight * d.y * d.y;
  sums[kX] += weight * d.x;
  sums[kY] += weight * d.z;
  sums[kXz] += weight * d.x * d.y;
  sums[kYz] += weight * d.z * d.y;
  sums[kCos2] += weight * (d.x * d.x - d.z * d.z);
  sums[kSin2] += weight * 2.0 * d.x * d.z;
}

void DirectionMoments::densities(std::uint32_t replicate, double returned, double named,
                                 double own) {
  const auto sums = sums_.of(replicate);
  if (!(returned >= 0.0)) return invalid(replicate);
  const double ofOwn = share(returned, own), ofNamed = share(returned, named);
  if (returned == 0.0) sums[kNoDensity] += 1.0;
  if (std::abs(ofOwn - 0.5) > 1e-3) sums[kOffOwn] += 1.0;
  sums[kOwn] += std::isfinite(ofOwn) ? ofOwn : 2.0;
  sums[kNamed] += ofNamed;
  sums[kNamedZ] += ofNamed * ofNamed;
}

void DirectionMoments::addTo(Signature& signature, const std::string& where,
                             std::uint32_t pointsOfReplicate, Densities densities) {
  sums_.divideBy(pointsOfReplicate);
  const auto add = [&](const char* what, std::size_t k) { sums_.add(signature, what + where, k); };
  add("mean of cos(theta)", kZ);
  add("mean of cos(theta)^2", kZ2);
  sums_.addLength(signature, "length of the mean direction across the axis" + where, {kX, kY});
  sums_.addLength(signature, "size of the mean of cos(theta) sin(theta) e^(i phi)" + where,
                  {kXz, kYz});
  sums_.addLength(signature, "size of the mean of sin(theta)^2 e^(2 i phi)" + where,
                  {kCos2, kSin2});
  add("mean weight of the samples", kWeight);
  add("share of directions that are not of unit length", kNotUnit);
  add("share of answers that are no numbers", kInvalid);
  if (densities == Densities::kNone) {
    add("share of directions below the axis' plane", kBelow);
    return;
  }
  add("share of samples whose density is not that of pdf()", kOffOwn);
  add("density / (density + that of pdf())", kOwn);
  if (densities == Densities::kOwn) return;
  add("share of directions below the surface", kBelow);
  add("share of samples of density 0", kNoDensity);
  add("density / (density + that of the contract)", kNamed);
  add("mean square of density / (density + that of the contract)", kNamedZ);
}

}  // namespace pathmark::diagnosis
