#include "checks/direct_cases.h"

#include "checks/calls.h"
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/means.h"
#include "sampling/mix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace pathmark::checks {

namespace {

constexpr double kDelta = 0.005, kTolerance = 1e-4;

// A receiver that emits must be met in the scene: a call alone tells nothing of its emission. So a
// ray meets it along -wo, and the path tracer's stand-in asks for direct light there.
bool isMetByARay(const Receiver& x) { return x.emits() || x.onLight; }

Words wordsOf(const LitRoom& room, const FlatScene& flat) {
  constexpr float kDistance = 0.5f;
  constexpr int kBounces = 1;
  const Receiver& x = room.receiver;
  if (isMetByARay(x)) return Words().add(Ray{x.p + kDistance * x.wo, -x.wo}, kBounces);
  return Words().add(x.p, x.n, room.rounding(), flat.materials.size() - 1, x.wo);
}

std::vector<Estimate> estimate(CheckRun& run, const LitRoom& room, std::uint64_t seed,
                               std::uint32_t replicates, std::uint32_t rays) {
  const FlatScene flat = room.flat();
  run.worker.loadScene(flat);
  EstimateRequest request;
  request.function =
      static_cast<std::uint32_t>(isMetByARay(room.receiver) ? CourseworkFunction::kTracePath
                                                            : CourseworkFunction::kDirectLighting);
  request.seed = seed;
  request.replicates = replicates;
  request.calls = 1;
  request.rays = rays;
  return run.worker.estimate(request, wordsOf(room, flat).words());
}

struct Suspect {
  const char* mistake;
  Kernel kernel;                           // per unit area, as LightTerms says
  int albedos = 1;                         // how often Kd is a factor
  bool (*isOf)(const LitRoom&) = nullptr;  // says something only where there is such a room
  bool ownEmission = false;                // the receiver's is added
};

bool hasScreens(const LitRoom& room) { return !room.screens.empty(); }
bool hasSeveralLights(const LitRoom& room) { return room.lights.size() > 1; }

double over(const LightTerms& t) { return 1.0 / (t.distance * t.distance); }

constexpr Suspect kSuspects[] = {
    {"no light arrives at all: the visibility test the wrong way round, wi or a cosine turned "
     "round, or the first light is left out",
     [](const LightTerms&) { return 0.0; }},
    {"the density of the sample is not divided out",
     [](const LightTerms& t) { return rightKernel(t) * t.density; }},
    {"the density of the sample is multiplied with instead of divided by",
     [](const LightTerms& t) { return rightKernel(t) * t.density * t.density; }},
    {"r stands where r^2 belongs", [](const LightTerms& t) { return rightKernel(t) * t.distance; }},
    {"r^3 stands where r^2 belongs: wi is made a unit vector already",
     [](const LightTerms& t) { return rightKernel(t) / t.distance; }},
    {"r^2 is divided out twice", [](const LightTerms& t) { return rightKernel(t) * over(t); }},
    {"r^2 is not divided out", [](const LightTerms& t) { return rightKernel(t) / over(t); }},
    {"the cosine at the receiver is missing",
     [](const LightTerms& t) { return rightKernel(t) / t.cosX; }},
    {"the cosine at the light is missing",
     [](const LightTerms& t) { return rightKernel(t) / t.cosY; }},
    {"both cosines are missing",
     [](const LightTerms& t) { return rightKernel(t) / (t.cosX * t.cosY); }},
    {"the cosine at the receiver is multiplied with twice",
     [](const LightTerms& t) { return rightKernel(t) * t.cosX; }},
    {"the cosine at the light is multiplied with twice",
     [](const LightTerms& t) { return rightKernel(t) * t.cosY; }},
    {"the cosine at the receiver stands in both places",
     [](const LightTerms& t) { return rightKernel(t) * t.cosX / t.cosY; }},
    {"the cosine at the light stands in both places",
     [](const LightTerms& t) { return rightKernel(t) * t.cosY / t.cosX; }},
    {"wo and wi are exchanged in the call of brdf",
     [](const LightTerms& t) { return rightKernel(t) * t.exchanged / t.brdf; }},
    {"wi is not made a unit vector",
     [](const LightTerms& t) { return rightKernel(t) / over(t) * t.stretched / t.brdf; }},
    {"the BRDF is missing",
     [](const LightTerms& t) { return rightKernel(t) / t.brdf * std::numbers::pi; }, 0},
    {"Kd is multiplied with twice: it is in the BRDF", rightKernel, 2},
    {"pi is divided out once too often: it is in the BRDF already",
     [](const LightTerms& t) { return rightKernel(t) / std::numbers::pi; }},
    {"a factor pi too many", [](const LightTerms& t) { return rightKernel(t) * std::numbers::pi; }},
    {"whether something lies between is not asked",
     [](const LightTerms& t) { return t.brdf * t.cosX * t.cosY / (t.distance * t.distance); }},
    {"the visibility test is the wrong way round: what is hidden shines",
     [](const LightTerms& t) {
       return t.open ? 0.0 : t.brdf * t.cosX * t.cosY / (t.distance * t.distance);
     },
     1, hasScreens},
    {"points are drawn again until one is visible: hidden ones must count, with 0",
     [](const LightTerms& t) { return t.openShare > 0.0 ? rightKernel(t) / t.openShare : 0.0; }},
    {"the sum over the lights is divided by their number, or the probability of choosing one is "
     "not divided out",
     [](const LightTerms& t) { return rightKernel(t) / static_cast<double>(t.lightCount); }},
    {"the sum over the lights is divided by their number plus 1",
     [](const LightTerms& t) { return rightKernel(t) / static_cast<double>(t.lightCount + 1); }},
    {"only the first light shines",
     [](const LightTerms& t) { return t.light == 0 ? rightKernel(t) : 0.0; }},
    {"only the last light shines: what each sends must be added",
     [](const LightTerms& t) { return t.light + 1 == t.lightCount ? rightKernel(t) : 0.0; }},
    {"the first light is left out",
     [](const LightTerms& t) { return t.light == 0 ? 0.0 : rightKernel(t); }, 1, hasSeveralLights},
    {"the emission of the surface itself is added: directLighting is the light that arrives and is "
     "scattered once",
     rightKernel, 1, nullptr, true},
};

// What was measured in a case.
struct Measured {
  glm::dvec3 mean{0.0}, error{0.0};
};

Measured measureOnce(CheckRun& run, const DirectCase& c) {
  constexpr std::uint32_t kReplicates = 64;
  glm::dvec3 sum(0.0), sum2(0.0);
  for (const Estimate& e : estimate(run, c.room, mix(run.seed), kReplicates, c.rays)) {
    const glm::dvec3 mean(e.mean[0], e.mean[1], e.mean[2]);
    sum += mean;
    sum2 += mean * mean;
  }
  Measured result;
  const double n = kReplicates;
  result.mean = sum / n;
  result.error = glm::sqrt(glm::max(sum2 / n - result.mean * result.mean, glm::dvec3(0.0)) / n);
  return result;
}

enum class Match { kNo, kLikeRight, kYes };

Match compare(const glm::dvec3& suspected, const DirectCase& c, const Measured& m) {
  constexpr double kSigmas = 5.0, kSame = 1e-3;
  bool differs = false;
  for (int k = 0; k < 3; ++k) {
    const double slack = kSigmas * m.error[k] + kSame * c.expected[k];
    if (!(std::abs(m.mean[k] - suspected[k]) <= slack)) return Match::kNo;
    differs = differs || std::abs(suspected[k] - c.expected[k]) > 4.0 * slack;
  }
  return differs ? Match::kYes : Match::kLikeRight;
}

glm::dvec3 suspectedRadiance(const Suspect& suspect, const DirectCase& c) {
  const glm::dvec3 radiance = radianceBy(suspect.kernel, c.room), kd(kReceiverKd);
  if (suspect.ownEmission) return radiance + glm::dvec3(c.room.receiver.emission);
  return suspect.albedos == 0 ? radiance / kd : suspect.albedos == 2 ? radiance * kd : radiance;
}

// The one mistake that explains all cases, some of them by being wrong.
std::string causeOf(CheckRun& run, const std::vector<DirectCase>& cases) {
  const auto saysSomething = [&](const Suspect& suspect) {
    return suspect.isOf == nullptr ||
           std::any_of(cases.begin(), cases.end(),
                       [&](const DirectCase& c) { return suspect.isOf(c.room); });
  };
  std::array<Match, std::size(kSuspects)> matches;
  for (std::size_t k = 0; k < matches.size(); ++k)
    matches[k] = saysSomething(kSuspects[k]) ? Match::kLikeRight : Match::kNo;
  for (const DirectCase& c : cases) {
    if (!c.comparable) continue;
    const Measured measured = measureOnce(run, c);
    for (std::size_t k = 0; k < matches.size(); ++k) {
      if (matches[k] == Match::kNo) continue;
      const Match match = compare(suspectedRadiance(kSuspects[k], c), c, measured);
      if (match != Match::kLikeRight) matches[k] = match;
    }
  }
  std::string cause;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (matches[k] != Match::kYes) continue;
    if (!cause.empty()) return {};
    cause = kSuspects[k].mistake;
  }
  return cause;
}

std::string invalidText(std::uint64_t invalid, std::uint64_t all) {
  return fmt::format("{} of {} values are negative, infinite or not a number", invalid, all);
}

Finding judgeCase(CheckRun& run, const DirectCase& c, std::uint64_t seed) {
  std::vector<Mean> means;
  for (int k = 0; k < 3; ++k) {
    Mean mean;
    mean.what = inChannel("mean radiance", k);
    mean.expected = mean.scale = c.expected[k];
    mean.tolerance = kTolerance;
    mean.delta = kDelta;
    means.push_back(mean);
  }
  std::uint64_t invalid = 0, all = 0;
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    const auto estimates = estimate(run, c.room, mix(seed + first), count, c.rays);
    all += std::uint64_t{count} * c.rays;
    for (std::size_t r = 0; r < estimates.size(); ++r) {
      invalid += estimates[r].invalid;
      for (std::size_t k = 0; k < 3; ++k)
        values[3 * r + k] =
            invalid == 0 ? estimates[r].mean[k] : std::numeric_limits<double>::quiet_NaN();
    }
  };
  Finding finding = judgeMeans(run, means, measure, c.room.text(), {}, 3);
  finding.calls = all;
  if (invalid > 0) {
    finding.expected = "finite values of at least 0";
    finding.got = invalidText(invalid, all);
    finding.tolerance.clear();
  }
  return finding;
}

// Enough to tell light from darkness.
struct FewSamples {
  static constexpr std::uint32_t kReplicates = 4, kRays = 256, kCount = kReplicates * kRays;
  std::uint64_t invalid = 0;
  glm::dvec3 mean{0.0};  // of the replicates with valid samples
};

FewSamples fewSamples(CheckRun& run, const LitRoom& room) {
  FewSamples few;
  for (const Estimate& e :
       estimate(run, room, run.seed, FewSamples::kReplicates, FewSamples::kRays)) {
    few.invalid += e.invalid;
    if (e.invalid < FewSamples::kRays)
      few.mean += glm::dvec3(e.mean[0], e.mean[1], e.mean[2]) / double{FewSamples::kReplicates};
  }
  return few;
}

Finding withCause(Finding finding, const std::string& cause) {
  finding.cause = cause;
  return finding;
}

}  // namespace

DirectCase caseOf(const LitRoom& room, std::uint32_t rays) {
  return {room, radianceBy(rightKernel, room), true, rays};
}

Finding judgeCases(CheckRun& run, const std::vector<DirectCase>& cases) {
  Finding worst;
  std::uint64_t calls = 0, seed = run.seed;
  for (const DirectCase& c : cases) {
    seed = mix(seed);
    Finding finding = judgeCase(run, c, seed);
    calls += finding.calls;
    if (finding.status == Status::kFail && !finding.tolerance.empty())
      finding.cause = causeOf(run, cases);
    if (worst.passed()) worst = finding;
    if (!finding.passed()) break;
  }
  worst.calls = calls;
  return worst;
}

Finding judgeDarkness(CheckRun& run, const std::vector<DarkCase>& cases) {
  Exact exact;
  for (const DarkCase& c : cases) {
    const FewSamples few = fewSamples(run, c.room);
    exact.count(FewSamples::kCount);
    exact.holds(
        few.invalid == 0 && few.mean == glm::dvec3(0.0), fmt::format("no light: {}", c.why),
        [&] {
          return few.invalid > 0 ? invalidText(few.invalid, FewSamples::kCount)
                                 : fmt::format("mean radiance = {}", text(vec3(few.mean)));
        },
        [&] { return c.room.text(); });
    if (exact.failed()) return withCause(exact.finding(), c.cause);
  }
  return exact.finding();
}

// A single light may be chosen of twelve, so that most samples may be 0: that all of them are, by
// right code, has a probability below 1e-38.
Finding judgeSomeLight(CheckRun& run, const std::vector<LitCase>& cases) {
  Exact exact;
  for (const LitCase& c : cases) {
    const FewSamples few = fewSamples(run, c.room);
    exact.count(FewSamples::kCount);
    exact.holds(
        few.mean != glm::dvec3(0.0) || few.invalid > 0, fmt::format("some light: {}", c.why),
        [&] { return fmt::format("0 in each of {} samples", std::uint64_t{FewSamples::kCount}); },
        [&] { return c.room.text(); });
    if (exact.failed()) return withCause(exact.finding(), c.cause);
  }
  return exact.finding();
}

}  // namespace pathmark::checks
