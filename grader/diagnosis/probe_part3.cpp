// The Lambertian BRDF.
#include "checks/channels.h"
#include "checks/points.h"
#include "diagnosis/direction_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using F = CourseworkFunction;

const Colour kKd(0.8f, 0.5f, 0.125f);

// The cosines of wo and wi: both above the surface, one of them below it, and both.
constexpr std::pair<double, double> kCosines[] = {{0.9, 0.7},  {0.3, 0.95}, {0.6, 0.2},  {1.0, 1.0},
                                                  {-0.4, 0.5}, {0.5, -0.8}, {-0.7, -0.3}};

Signature values(const ProbeRun& run) {
  const bool isDensity = run.function == F::kLambertianPdf;
  Random random(31);
  Calls calls(run.function, Words().add(kKd));
  std::vector<std::string> where;
  for (const Vector& n : {Vector(0, 1, 0), Vector(0, 0, -1), random.direction()})
    for (const auto& [cosO, cosI] : kCosines) {
      const double azimuth = random.between(0.0, 6.0);
      calls.add(atCosine(n, cosO, azimuth), atCosine(n, cosI, random.between(0.0, 6.0)), n);
      where.push_back(fmt::format(" where wo . n = {} and wi . n = {}", cosO, cosI));
    }
  const Results results = calls.run(run.worker);
  Signature signature;
  for (std::size_t i = 0; i < where.size(); ++i)
    for (int c = 0; c < (isDensity ? 1 : 3); ++c)
      signature.add((isDensity ? "pdf" : inChannel("f", c)) + where[i],
                    results.number(i, static_cast<std::size_t>(c)));
  return signature;
}

Signature samples(const ProbeRun& run) {
  Random random(33);
  Signature signature;
  for (const Vector& n :
       {Vector(0, 0, 1), Vector(0, 1, 0), Vector(0, -1, 0), Vector(1, 0, 0), random.direction()})
    probeDirections(run,
                    {.pdf = F::kLambertianPdf,
                     .object = Words().add(kKd),
                     .wo = atCosine(n, 0.6, 1.0),
                     .n = n,
                     .axis = n,
                     .where = fmt::format(", n = ({:.3g}, {:.3g}, {:.3g})", n.x, n.y, n.z),
                     .named =
                         [n](const Vector& wi) {
                           return std::max(double{dot(wi, n)}, 0.0) / std::numbers::pi;
                         }},
                    signature);
  return signature;
}

}  // namespace

Signature probePart3(const ProbeRun& run) {
  return run.function == F::kLambertianReflection ? samples(run) : values(run);
}

}  // namespace pathmark::diagnosis
