// Part 1: which rays renderPixel sends, seen by a tracePath that records them. This program is
// linked with part 1 alone; no scene is needed.
#include "checks/film_point.h"
#include "checks/strata_matching.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"

#include <pathmark/coursework.h>

#include <gtest/gtest.h>

#include <functional>

namespace pathmark {

class SceneCore {};

namespace {

using namespace testing;
using checks::filmPoint;
using checks::filmTolerance;
using checks::StrataMatching;

// What renderPixel did, in order.
struct Record {
  std::vector<int> started;            // the arguments of startRay
  std::vector<std::size_t> startedBy;  // calls of startRay before the m-th ray
  std::vector<Ray> rays;
  std::vector<int> numbersOf;  // how many numbers the m-th ray took after its startRay
  int numbers = 0;             // since the last startRay, or since the beginning
  int stray = 0;               // numbers taken before any startRay
};

Record record;

// The radiance of the m-th ray: all different, so that no ray can count for another.
Colour radianceOf(std::size_t m) {
  const auto x = static_cast<float>(m);
  return {1.0f + x, 1.0f / (1.0f + x), m % 3 == 0 ? 7.0f : 0.0f};
}

class RecordingSampler final : public Sampler {
 public:
  explicit RecordingSampler(std::function<float()> source) : source_(std::move(source)) {}

  void startRay(int m) override {
    record.started.push_back(m);
    record.numbers = 0;
    forgetNumbers();
  }

 private:
  void refillSingles() override {
    nextSingle_ = kBlock - 1;
    singles_[nextSingle_] = number();
  }

  void refillPairs() override {
    nextPair_ = kBlock - 1;
    pairsX_[nextPair_] = number();
    pairsY_[nextPair_] = number();
  }

  float number() {
    ++(record.started.empty() ? record.stray : record.numbers);
    return source_();
  }

  std::function<float()> source_;
};

const SceneCore kNoScene;

// Offset of the film to the eye and pixels of unequal sides, so that no two axes can be mixed up.
const SimpleCamera kCamera({1, 2, 3}, {-0.3f, 0.4f, -1.1f}, {0.02f, 0.001f, 0.004f},
                           {0.003f, -0.03f, 0.0f}, 40, 30);
constexpr int kColumn = 5, kRow = 22;

Colour renderRecorded(int rays, std::function<float()> source) {
  record = {};
  RecordingSampler sampler(std::move(source));
  return LitScene(kNoScene, 8).renderPixel(kColumn, kRow, kCamera, rays, sampler);
}

// Where the rays went within the pixel, [0,1] by [0,1].
std::vector<glm::dvec2> recordedPoints() {
  std::vector<glm::dvec2> points;
  for (const Ray& ray : record.rays)
    points.push_back(filmPoint(kCamera, ray.direction) - glm::dvec2(kColumn, kRow));
  return points;
}

constexpr std::array kRayCounts{1, 2, 3, 4, 5, 8, 9, 16, 17, 24, 25, 64, 255, 256, 1000, 1024};

int strataPerSide(int rays) {
  int n = 0;
  while ((n + 1) * (n + 1) <= rays) ++n;
  return n;
}

std::vector<std::function<float()>> sources() {
  std::vector<std::function<float()>> result;
  for (const float number : kEdgeNumbers) result.emplace_back([number] { return number; });
  result.emplace_back([random = Uniforms(111)]() mutable { return random.next(); });
  result.emplace_back(
      [random = Uniforms(112)]() mutable { return float(random.between(0.01, 0.99)); });
  return result;
}

TEST(RenderPixel, SendsOneRayThroughEachStratumAndTheRestAnywhere) {
  const double tolerance = filmTolerance(kCamera, kColumn + 1, kRow + 1);
  for (const int rays : kRayCounts) {
    for (const auto& source : sources()) {
      SCOPED_TRACE(::testing::Message() << rays << " rays");
      renderRecorded(rays, source);
      ASSERT_EQ(record.rays.size(), std::size_t(rays));
      const std::vector<glm::dvec2> points = recordedPoints();
      for (const glm::dvec2& p : points) {
        ASSERT_GE(std::min(p.x, p.y), -tolerance);
        ASSERT_LE(std::max(p.x, p.y), 1.0 + tolerance);
      }
      EXPECT_FALSE(StrataMatching(points, strataPerSide(rays), tolerance).emptyStratum());
    }
  }
}

TEST(RenderPixel, SendsUnitRaysFromTheEye) {
  renderRecorded(64, [random = Uniforms(113)]() mutable { return random.next(); });
  for (const Ray& ray : record.rays) {
    EXPECT_EQ(ray.origin, kCamera.eye());
    EXPECT_TRUE(isUnit(ray.direction));
  }
}

TEST(RenderPixel, StartsTheNumbersOfEachRayInOrder) {
  for (const int rays : kRayCounts) {
    renderRecorded(rays, [] { return 0.5f; });
    ASSERT_EQ(record.started.size(), std::size_t(rays));
    for (int m = 0; m < rays; ++m) {
      EXPECT_EQ(record.started[std::size_t(m)], m);
      EXPECT_EQ(record.startedBy[std::size_t(m)], std::size_t(m) + 1) << "startRay comes first";
      EXPECT_GE(record.numbersOf[std::size_t(m)], 2) << "the ray's own numbers place it";
    }
    EXPECT_EQ(record.stray, 0);
  }
}

TEST(RenderPixel, ReturnsTheMeanOfAllRays) {
  for (const int rays : kRayCounts) {
    const Colour mean = renderRecorded(rays, [] { return 0.25f; });
    glm::dvec3 expected(0.0);
    for (int m = 0; m < rays; ++m)
      expected += glm::dvec3(radianceOf(std::size_t(m))) / double(rays);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(isClose(mean[c], expected[c], 1e-5)) << rays << " rays";
  }
}

TEST(RenderPixel, BeginsAnewWithEachCall) {
  const Colour first = renderRecorded(17, [] { return 0.25f; });
  EXPECT_EQ(renderRecorded(17, [] { return 0.25f; }), first);
}

// Within its stratum a ray is uniform, in both axes independently.
TEST(RenderPixel, FillsEachStratumEvenly) {
  constexpr std::size_t kSide = 8;
  constexpr int kStrata = 4;
  stats::WeightedCells cells(kSide * kSide);
  Uniforms random(114);
  for (int pixel = 0; pixel < 2000; ++pixel) {
    renderRecorded(kStrata * kStrata, [&] { return random.next(); });
    for (const glm::dvec2& p : recordedPoints()) {
      const glm::dvec2 within = glm::fract(p * double(kStrata)) * double(kSide);
      cells.add(std::min(std::size_t(within.x), kSide - 1) * kSide +
                std::min(std::size_t(within.y), kSide - 1));
    }
  }
  const std::vector<double> equal(kSide * kSide, 1.0 / (kSide * kSide));
  EXPECT_TRUE(cellsAre(cells, equal, kAlpha));
}

// Of three rays two, and of eight rays four, are without a stratum.
TEST(RenderPixel, SendsTheRemainingRaysEvenlyThroughThePixel) {
  constexpr std::size_t kSide = 8;
  for (const int rays : {3, 7, 8}) {
    stats::WeightedCells cells(kSide * kSide);
    Uniforms random(115);
    for (int pixel = 0; pixel < 10000; ++pixel) {
      renderRecorded(rays, [&] { return random.next(); });
      for (const glm::dvec2& p : recordedPoints()) {
        const glm::dvec2 at = glm::clamp(p, 0.0, 1.0) * double(kSide);
        cells.add(std::min(std::size_t(at.x), kSide - 1) * kSide +
                  std::min(std::size_t(at.y), kSide - 1));
      }
    }
    const std::vector<double> equal(kSide * kSide, 1.0 / (kSide * kSide));
    EXPECT_TRUE(cellsAre(cells, equal, kAlpha)) << rays << " rays";
  }
}

}  // namespace

Colour LitScene::tracePath(const Ray& ray, Sampler&) const {
  record.rays.push_back(ray);
  record.numbersOf.push_back(record.numbers);
  record.startedBy.push_back(record.started.size());
  return radianceOf(record.rays.size() - 1);
}

}  // namespace pathmark
