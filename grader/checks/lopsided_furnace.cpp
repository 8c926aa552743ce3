#include "checks/lopsided_furnace.h"

#include "checks/standins/lopsided.h"
#include "checks/standins/unfair_roulette.h"

#include <algorithm>
#include <numbers>

namespace pathmark::checks {

namespace {

// In the cosine; of degree 4 at most.
using Polynomial = std::array<double, 5>;

Polynomial constant(double value) { return {value, 0, 0, 0, 0}; }

Polynomial operator+(Polynomial a, const Polynomial& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}

Polynomial operator*(double factor, Polynomial a) {
  for (double& coefficient : a) coefficient *= factor;
  return a;
}

// What is beyond the highest degree is 0 in all products here.
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial product{};
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; i + k < a.size(); ++k) product[i + k] += a[i] * b[k];
  return product;
}

double at(const Polynomial& p, double x) {
  double value = 0.0;
  for (std::size_t k = p.size(); k-- > 0;) value = value * x + p[k];
  return value;
}

// Integral of x^power p(x) over [0,1].
double moment(const Polynomial& p, int power) {
  double sum = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) sum += p[k] / (static_cast<double>(k) + power + 1.0);
  return sum;
}

// The density of the stand-in's directions.
constexpr double kDensity = double{lopsided::kShareOfSamples} * 0.5 * std::numbers::inv_pi;
constexpr double kShare = double{lopsided::kShareOfSamples};
constexpr double kSurvival = double{unfair::kSurvival};

// Integrals over the directions of f(c, c') g(c') and a cosine. shape(c, c') is
// 0.2 + 0.5 c^2 + 0.4 c', and an integral over the azimuth is a factor of 2 pi.
Polynomial withoutCosine(double kd, const Polynomial& g) {
  const double m0 = moment(g, 0), m1 = moment(g, 1);
  return 2.0 * kd * Polynomial{0.2 * m0 + 0.4 * m1, 0.0, 0.5 * m0, 0.0, 0.0};
}

Polynomial reflect(double kd, const Polynomial& g) {
  const double m1 = moment(g, 1), m2 = moment(g, 2);
  return 2.0 * kd * Polynomial{0.2 * m1 + 0.4 * m2, 0.0, 0.5 * m1, 0.0, 0.0};
}

Polynomial swappedDirections(double kd, const Polynomial& g) {
  const double m1 = moment(g, 1), m3 = moment(g, 3);
  return 2.0 * kd * Polynomial{0.2 * m1 + 0.5 * m3, 0.4 * m1, 0.0, 0.0, 0.0};
}

Polynomial cosineOfTheOther(double kd, const Polynomial& g) {
  return Polynomial{0.0, 1.0, 0.0, 0.0, 0.0} * withoutCosine(kd, g);
}

// The mean of g over the directions, 0 for "no sample".
double meanOverSamples(const Polynomial& g) { return kShare * moment(g, 0); }

using Step = std::function<Polynomial(const Polynomial&)>;

// D + S(D + S(... D_B)), with the direct light D of B hits, that of the last hit perhaps another,
// and the step S from one to the next.
Polynomial sumOfHits(const Polynomial& direct, const Polynomial& last, const Step& step, int hits) {
  if (hits < 1) return constant(0.0);
  Polynomial sum = last;
  for (int k = 1; k < hits; ++k) sum = direct + step(sum);
  return sum;
}

Polynomial directLight(const LopsidedFurnace& f) { return reflect(f.kd, constant(f.emission)); }

using MakeStep = Polynomial (*)(double kd, const Polynomial& g);

FurnaceMistake inStep(const char* words, MakeStep make) {
  return {words, [make](const LopsidedFurnace& f, double cosine, int bounces) {
            const Step step = [&](const Polynomial& g) { return make(f.kd, g); };
            return f.emission +
                   at(sumOfHits(directLight(f), directLight(f), step, bounces), cosine);
          }};
}

using MakeDirect = Polynomial (*)(const LopsidedFurnace& f);

// Of all hits, or of those only from which the path may go on.
enum class Hits { kAll, kAllButLast };

FurnaceMistake inDirectLight(const char* words, Hits hits, MakeDirect make) {
  return {words, [make, hits](const LopsidedFurnace& f, double cosine, int bounces) {
            const Step step = [&](const Polynomial& g) { return reflect(f.kd, g); };
            return f.emission + at(sumOfHits(make(f), hits == Hits::kAll ? make(f) : directLight(f),
                                             step, bounces),
                                   cosine);
          }};
}

FurnaceMistake emissionAgain(const char* words, bool withThroughput, int beyond) {
  return {words, [=](const LopsidedFurnace& f, double cosine, int bounces) {
            const Polynomial emission = constant(f.emission);
            const auto reach = [](const Polynomial& g) {
              return constant(kSurvival * meanOverSamples(g));
            };
            Polynomial again = constant(0.0);
            for (int k = 1; k < bounces + beyond; ++k)
              again = withThroughput ? reflect(f.kd, emission + again) : reach(emission + again);
            return f.radiance(cosine, bounces) + at(again, cosine);
          }};
}

constexpr const char* kEarly =
    "direct light is multiplied by the throughput of the next hit: the update comes too early";
constexpr const char* kOnlyEmission =
    "only what the first hit emits counts: direct light is not added, or the throughput does not "
    "begin with 1";
constexpr const char* kOnlyEmissionForMis =
    "only what the first hit emits counts: the throughput does not begin with 1, or the weight of "
    "a light that the path meets has its densities exchanged (that of the direction comes first), "
    "or is 0 where light samples have the density 0: it is 1 there";
constexpr const char* kShort =
    "one bounce short: hits 1 to B get direct light, and hits 1 to B - 1 go on";
constexpr const char* kShortForMis =
    "one bounce short: hits 1 to B get light samples, and each of them sends a ray on; that of hit "
    "B may still find a light";
constexpr const char* kLong =
    "one bounce too many: hits 1 to B get direct light, and hits 1 to B - 1 go on";
constexpr const char* kLongForMis =
    "one bounce too many: hits 1 to B get light samples and send a ray on; of hit B + 1 only its "
    "emission counts";
constexpr const char* kLost =
    "direct light is added after the roulette: where it ends a path, it is lost";

Polynomial earlyDirectLight(const LopsidedFurnace& f) {
  return directLight(f) * reflect(f.kd, constant(1.0));
}

Polynomial lostDirectLight(const LopsidedFurnace& f) { return kShare * kSurvival * directLight(f); }

}  // namespace

double LopsidedFurnace::radiance(double cosine, int bounces) const {
  const Step step = [&](const Polynomial& g) { return reflect(kd, g); };
  const Polynomial direct = directLight(*this);
  return emission + at(sumOfHits(direct, direct, step, bounces), cosine);
}

const std::string& FurnaceMistake::wordsFor(CourseworkFunction pathTracer) const {
  const bool other = pathTracer == CourseworkFunction::kTracePathMis && !wordsForMis.empty();
  return other ? wordsForMis : words;
}

const std::vector<FurnaceMistake>& furnaceMistakes() {
  static const std::vector<FurnaceMistake> kMistakes{
      {"what the first hit emits is lost",
       [](const LopsidedFurnace& f, double cosine, int bounces) {
         return f.radiance(cosine, bounces) - f.emission;
       }},
      {kOnlyEmission, [](const LopsidedFurnace& f, double, int) { return f.emission; },
       kOnlyEmissionForMis},
      {kShort,
       [](const LopsidedFurnace& f, double cosine, int bounces) {
         return f.radiance(cosine, bounces - 1);
       },
       kShortForMis},
      {kShort,
       [](const LopsidedFurnace& f, double cosine, int bounces) {
         return f.radiance(cosine, std::max(bounces - 1, 1));
       },
       kShortForMis},
      {kLong,
       [](const LopsidedFurnace& f, double cosine, int bounces) {
         return f.radiance(cosine, bounces + 1);
       },
       kLongForMis},
      emissionAgain("emission is added at every hit, though direct light has counted it", true, 0),
      emissionAgain("emission is added at every hit, though direct light has counted it", true, 1),
      emissionAgain("emission is added at every hit, and without the throughput", false, 0),
      emissionAgain("emission is added at every hit, and without the throughput", false, 1),
      {"the path ends at the first light that it meets: a light is a surface like others, and "
       "reflects too",
       [](const LopsidedFurnace& f, double cosine, int bounces) {
         return f.radiance(cosine, std::min(bounces, 1));
       }},
      {"direct light counts half",
       [](const LopsidedFurnace& f, double cosine, int bounces) {
         return 0.5 * (f.emission + f.radiance(cosine, bounces));
       },
       "the weight of a light that the path meets is 1/2 where it must be 1: light samples have "
       "the density 0 here"},
      inStep("the cosine is missing in the throughput", withoutCosine),
      inStep("the throughput takes the cosine of wo: that of wi belongs there", cosineOfTheOther),
      inStep("wo and wi are exchanged in the BRDF of the throughput", swappedDirections),
      inStep("the throughput is multiplied by the density instead of divided",
             [](double kd, const Polynomial& g) { return kDensity * kDensity * reflect(kd, g); }),
      inStep("the throughput is not divided by the density",
             [](double kd, const Polynomial& g) { return kDensity * reflect(kd, g); }),
      inStep(kNumberAgain,
             [](double kd, const Polynomial& g) { return 1.0 / kShare * reflect(kd, g); }),
      inStep("2 pi stands where the density that reflection returns belongs",
             [](double kd, const Polynomial& g) { return kShare * reflect(kd, g); }),
      inStep("the throughput takes Kd, which holds for cosine-distributed directions of a "
             "Lambertian surface only: f cos(theta) / pdf belongs there",
             [](double kd, const Polynomial& g) { return constant(kd * meanOverSamples(g)); }),
      inStep("the BRDF is missing in the throughput",
             [](double, const Polynomial& g) {
               return constant(2.0 * std::numbers::pi * moment(g, 1));
             }),
      inStep("the throughput is never updated with f cos(theta) / pdf",
             [](double, const Polynomial& g) { return constant(meanOverSamples(g)); }),
      inStep("direct light is not multiplied by the throughput",
             [](double, const Polynomial& g) { return constant(kSurvival * meanOverSamples(g)); }),
      inStep("the roulette's weight is missing in the throughput",
             [](double kd, const Polynomial& g) { return kSurvival * reflect(kd, g); }),
      inStep("the roulette's weight is in the throughput twice",
             [](double kd, const Polynomial& g) { return 1.0 / kSurvival * reflect(kd, g); }),
      inDirectLight(kEarly, Hits::kAll, earlyDirectLight),
      inDirectLight(kEarly, Hits::kAllButLast, earlyDirectLight),
      inDirectLight(kLost, Hits::kAll, lostDirectLight),
      inDirectLight(kLost, Hits::kAllButLast, lostDirectLight),
      {"the throughput is assigned (=) where it must be multiplied (*=)",
       [](const LopsidedFurnace& f, double cosine, int bounces) {
         // Of each hit's direct light the last step only, for the paths that come to it.
         Polynomial later = constant(0.0);
         const Polynomial once = reflect(f.kd, directLight(f));
         for (int k = 1; k < bounces; ++k)
           later = once + constant(kSurvival * meanOverSamples(later));
         return f.radiance(cosine, 1) + at(later, cosine);
       }},
  };
  return kMistakes;
}

double unfairRadiance(const LopsidedFurnace& furnace, double cosine, int bounces, int first,
                      bool updated) {
  const Polynomial direct = directLight(furnace);
  Polynomial sum = constant(0.0);
  for (int hit = bounces; hit > 0; --hit) {
    // The channel that reflects nothing is black from the first update on.
    const bool black = updated || hit > 1;
    const double factor = black ? unfair::factor(first + hit - 1) : 1.0;
    sum = hit == bounces ? direct : direct + factor * reflect(furnace.kd, sum);
  }
  return furnace.emission + at(sum, cosine);
}

double unfairMisRadiance(const LopsidedFurnace& furnace, double cosine, int bounces,
                         LightBefore before, const std::function<double(int hit)>& factor) {
  const Polynomial direct = directLight(furnace);
  Polynomial sum = constant(0.0);
  for (int hit = bounces; hit > 0; --hit) {
    const bool bare =
        before == LightBefore::kAll || (before == LightBefore::kLast && hit == bounces);
    sum = (bare ? 1.0 : factor(hit)) * direct + factor(hit) * reflect(furnace.kd, sum);
  }
  return furnace.emission + at(sum, cosine);
}

}  // namespace pathmark::checks
