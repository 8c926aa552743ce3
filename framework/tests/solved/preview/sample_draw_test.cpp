// The solutions' samples have the expected density, and claim it; what is wrong is seen, and what
// is only another sampler is told from it.
#include "preview/samples/sample_draw.h"
#include "host/coursework_builder.h"
#include "preview/sampler_cases.h"
#include "preview/samples/sample_remarks.h"
#include "stats/quantiles.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pathmark::preview::test {
namespace {

using F = CourseworkFunction;
using pathmark::test::TestCoursework;

// Probability that one p-value or one histogram of right samples fails, roughly: the tails are
// those of chi-square only nearly. There are about 1,000 of them.
constexpr double kFalseFail = 1e-8;

std::unique_ptr<WorkerProcess> startPart(const CourseworkBuild& build, int part) {
  const std::array parts{part};
  const LinkedWorker linked = linkWithStandIns(build, parts);
  if (linked.worker.empty()) throw std::runtime_error(linked.failure);
  WorkerProcess::Options options;
  options.program = linked.worker;
  options.courseworkFolder = build.folder;
  return std::make_unique<WorkerProcess>(std::move(options));
}

class SolvedSamples : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const CourseworkBuild build =
        buildCoursework(courseworkFolder("solutions"), Incomplete::kCompileOnly);
    ASSERT_TRUE(build.complete()) << build.failure();
    for (int part = 0; part <= 4; ++part) workers_.push_back(startPart(build, part));
  }
  static void TearDownTestSuite() { workers_.clear(); }

  static SampleSet draw(const SampleSettings& settings) {
    return drawSamples(*workers_.at(static_cast<std::size_t>(contractOf(settings.function).part)),
                       settings);
  }

 private:
  static inline std::vector<std::unique_ptr<WorkerProcess>> workers_;
};

// Whether the bars of a histogram are as far from what is expected as chance allows.
void expectBarsFit(const Histogram& histogram) {
  double statistic = 0.0;
  int bars = 0;
  for (const Bar& bar : histogram.bars) {
    if (bar.sigma <= 0.0) continue;
    statistic += std::pow((bar.share - bar.expected) / bar.sigma, 2);
    ++bars;
  }
  EXPECT_LT(statistic, stats::chiSquareCritical(kFalseFail, bars)) << histogram.name;
}

TEST_F(SolvedSamples, IndependentOnesHaveTheExpectedDensity) {
  for (const SamplerCase& c : samplerCases())
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE(c.name + ", seed " + std::to_string(seed));
      SampleSettings settings = c.settings;
      settings.count = 4096;
      settings.seed = seed;
      const SampleSet set = draw(settings);
      EXPECT_EQ(set.count(SampleKind::kGood) + set.count(SampleKind::kNone), set.samples.size());
      EXPECT_TRUE(set.plain.test.possible);
      EXPECT_GT(set.plain.test.pValue, kFalseFail);
      EXPECT_GT(set.weighted.test.pValue, kFalseFail);
      if (settings.strata == 1 || settings.function != F::kStratifiedRandomRay)
        for (const Histogram& histogram : set.plain.histograms) expectBarsFit(histogram);
    }
}

TEST_F(SolvedSamples, ClaimTheExpectedDensity) {
  for (const SamplerCase& c : samplerCases()) {
    SCOPED_TRACE(c.name);
    SampleSettings settings = c.settings;
    settings.count = 4096;
    const SampleSet set = draw(settings);
    if (!set.claims) continue;
    ASSERT_TRUE(set.claimedOverExpected);
    EXPECT_NEAR(set.claimedOverExpected->low, 1.0, 2e-3);
    EXPECT_NEAR(set.claimedOverExpected->high, 1.0, 2e-3);
    EXPECT_TRUE(remarksOn(set).empty());
  }
}

TEST_F(SolvedSamples, OfPointSetsAreMoreEvenThanChance) {
  for (const SamplerKind points : {SamplerKind::kSobol, SamplerKind::kStratified}) {
    SampleSettings settings;
    settings.function = F::kLambertianReflection;
    settings.points = points;
    const SampleSet set = draw(settings);
    EXPECT_GT(set.plain.test.pValue, 0.99);
    EXPECT_NE(describe(set.plain.test, points).find("more even"), std::string::npos);
  }
}

TEST_F(SolvedSamples, OfAPixelAreOneInEachStratumAndPass) {
  SampleSettings settings;
  settings.function = F::kStratifiedRandomRay;
  settings.strata = 16;
  settings.count = 256;
  for (const SamplerKind points :
       {SamplerKind::kPcg, SamplerKind::kStratified, SamplerKind::kSobol}) {
    settings.points = points;
    std::vector<int> found(256, 0);
    for (const Sample& s : draw(settings).samples)
      ++found.at(static_cast<std::size_t>(s.place.y * 16.0) * 16 +
                 static_cast<std::size_t>(s.place.x * 16.0));
    EXPECT_EQ(found, std::vector<int>(256, 1));
  }
}

// The p-value means what it says: of 400 pictures of right samples, 4 are below 1% on average, and
// 20 or more with probability 1e-8.
TEST_F(SolvedSamples, HaveSmallPValuesAsOftenAsThePValuesSay) {
  int small = 0;
  SampleSettings settings;
  for (settings.seed = 0; settings.seed < 400; ++settings.seed)
    small += draw(settings).plain.test.pValue < 0.01 ? 1 : 0;
  EXPECT_LT(small, 20);
}

TEST_F(SolvedSamples, AreOtherOnesWithAnotherSeedAndTheSameWithTheSame) {
  SampleSettings settings;
  const SampleSet first = draw(settings), again = draw(settings);
  settings.seed = 1;
  const SampleSet other = draw(settings);
  EXPECT_EQ(first.samples[7].place, again.samples[7].place);
  EXPECT_NE(first.samples[7].place, other.samples[7].place);
}

// A worker with this reflection, and samples of it.
std::unique_ptr<WorkerProcess> startWithReflection(const std::string& body) {
  TestCoursework coursework;
  coursework.setFile("part3_lambertian.cpp", R"(
Colour lambertianBRDF::brdf(const Vector&, const Vector&, const Vector&) const { return Kd; }
float lambertianBRDF::pdf(const Vector&, const Vector&, const Vector&) const { return 1.0f; }
DirectionSample lambertianBRDF::reflection(const Vector&, const Vector& n, float s, float t,
                                           float) const {
)" + body + "\n}");
  return startPart(buildCoursework(coursework.folder(), Incomplete::kCompileOnly), 3);
}

SampleSet drawReflection(WorkerProcess& worker, std::uint32_t seed = 0) {
  SampleSettings settings;
  settings.function = F::kLambertianReflection;
  settings.seed = seed;
  return drawSamples(worker, settings);
}

SampleSet drawReflection(const std::string& body) {
  return drawReflection(*startWithReflection(body));
}

std::string remarkOn(const SampleSet& set) {
  std::string all;
  for (const std::string& remark : remarksOn(set)) all += remark + "\n";
  return all;
}

constexpr const char* kUniform =
    "const vec2 c = std::sqrt(1.0f - t * t) * onUnitCircle(s);\n"
    "const Vector wi = normalize(Frame(n).toWorld({c.x, t, c.y}));\n";
constexpr const char* kCosine =
    "const vec2 c = std::sqrt(1.0f - t) * onUnitCircle(s);\n"
    "const Vector wi = Frame(n).toWorld({c.x, std::sqrt(t), c.y});\n";

TEST(WrongSamples, OfAnotherDensityHaveATinyPValue) {
  const SampleSet set = drawReflection(std::string(kUniform) + "return {wi, dot(wi, n) * kInvPi};");
  EXPECT_LT(set.plain.test.pValue, 1e-9);
  EXPECT_LT(set.weighted.test.pValue, 1e-9);
  EXPECT_NE(remarkOn(set).find("neither"), std::string::npos);
}

TEST(WrongSamples, OfAnotherDensityThatTheyClaimFitWhenTheyAreWeighted) {
  const auto worker = startWithReflection(std::string(kUniform) + "return {wi, 0.5f * kInvPi};");
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const SampleSet set = drawReflection(*worker, seed);
    EXPECT_LT(set.plain.test.pValue, 1e-9);
    EXPECT_GT(set.weighted.test.pValue, kFalseFail);
    for (const Histogram& histogram : set.weighted.histograms) expectBarsFit(histogram);
    EXPECT_NE(remarkOn(set).find("not a wrong one"), std::string::npos);
  }
}

TEST(WrongSamples, WithTwiceTheDensityAreToldTheFactor) {
  const SampleSet set =
      drawReflection(std::string(kCosine) + "return {wi, 2.0f * dot(wi, n) * kInvPi};");
  EXPECT_GT(set.plain.test.pValue, kFalseFail);
  EXPECT_LT(set.weighted.test.pValue, 1e-9);
  EXPECT_NE(remarkOn(set).find("2 times"), std::string::npos);
}

TEST(WrongSamples, BelowTheSurfaceAreCounted) {
  const SampleSet set =
      drawReflection(std::string(kCosine) + "return {s < 0.5f ? wi : -wi, dot(wi, n) * kInvPi};");
  EXPECT_GT(set.count(SampleKind::kAstray), 0u);
  EXPECT_EQ(set.plain.test.pValue, 0.0);
  EXPECT_NE(remarkOn(set).find("lie below the surface"), std::string::npos);
}

TEST(WrongSamples, ThatAreNoNumbersAreCounted) {
  const SampleSet set = drawReflection(std::string(kCosine) +
                                       "return {s < 0.5f ? wi : wi * std::sqrt(-1.0f - s), 1.0f};");
  EXPECT_GT(set.count(SampleKind::kNoNumber), 0u);
  EXPECT_NE(remarkOn(set).find("not numbers"), std::string::npos);
}

TEST(WrongSamples, OfASeedThatIsNotUpdatedAreSeen) {
  TestCoursework coursework;
  coursework.setFile("part0_warmup.cpp", R"(
bool ray_triangle_intersection(float&, const Ray&, const Triangle&) { return false; }
bool ray_mesh_intersection(float&, Triangle&, const Ray&, const Mesh&) { return false; }
vec2 get_random_numbers(uvec2& seed) {
  uvec2 v = seed * 1664525u + 1013904223u;
  for (int round = 0; round < 2; ++round) {
    v.x += 1664525u * v.y;
    v.y += 1664525u * v.x;
    v ^= v >> 16u;
  }
  return vec2(v >> 8u) * 0x1p-24f;
}
vec3 sample_sphere(vec2) { return vec3(0, 0, 1); }
vec3 sample_hemisphere(vec2, vec3 n) { return n; }
vec3 compute_direct_illumination(vec3, const Triangle&, const Mesh&, uvec2&) { return vec3(0); }
vec3 get_ray_radiance(vec3, vec3, const Mesh&, uvec2&) { return vec3(0.75f); }
)");
  const CourseworkBuild build = buildCoursework(coursework.folder(), Incomplete::kCompileOnly);
  SampleSettings settings;
  settings.function = F::kGetRandomNumbers;
  EXPECT_LT(drawSamples(*startPart(build, 0), settings).plain.test.pValue, 1e-9);
}

}  // namespace
}  // namespace pathmark::preview::test
