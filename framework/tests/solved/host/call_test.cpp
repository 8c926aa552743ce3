// Every function of the contract can be called from the host, its words in their places: the
// solutions' answers to questions whose answers are plain.
#include "host/coursework_builder.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <concepts>
#include <numbers>

namespace pathmark::test {
namespace {

using F = CourseworkFunction;

constexpr float kPi = std::numbers::pi_v<float>;

// Floats and integers as words.
template <class... T>
std::vector<std::uint32_t> words(T... values) {
  const auto word = [](auto value) -> std::uint32_t {
    if constexpr (std::floating_point<decltype(value)>)
      return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    else
      return static_cast<std::uint32_t>(value);
  };
  return {word(values)...};
}

class Call : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const CourseworkBuild build = buildCoursework(courseworkFolder("solutions"));
    ASSERT_FALSE(build.worker.empty()) << build.failure();
    WorkerProcess::Options options;
    options.program = build.worker;
    options.courseworkFolder = build.folder;
    worker_ = std::make_unique<WorkerProcess>(std::move(options));
    worker_->loadScene(glowingRoom());
  }
  static void TearDownTestSuite() { worker_.reset(); }

  // The camera is inside a sphere of reflectance 1/2 that emits 1/2 inwards; two bounces at most.
  static FlatScene glowingRoom() {
    FlatScene scene = emptyScene(8, 8);
    scene.maxBounces = 2;
    scene.shapes.push_back({0, 0, {0.5f, 0.5f, 0.5f}});
    scene.spheres.push_back({{0, 0, 0}, 3.0f, 0, 1});
    scene.lights.push_back({0, 0, 0, {0.5f, 0.5f, 0.5f}});
    return scene;
  }

  static void expectFloats(F function, const std::vector<std::uint32_t>& object,
                           const std::vector<std::uint32_t>& input,
                           const std::vector<float>& expected, float tolerance = 1e-6f) {
    SCOPED_TRACE(contractOf(function).name);
    // Two calls in one request: the second must begin where the first ends.
    std::vector<std::uint32_t> twice = input;
    twice.insert(twice.end(), input.begin(), input.end());
    const std::vector<std::uint32_t> answer = worker_->call(function, object, twice);
    ASSERT_EQ(answer.size(), 2 * expected.size());
    for (std::size_t i = 0; i < answer.size(); ++i)
      EXPECT_NEAR(std::bit_cast<float>(answer[i]), expected[i % expected.size()], tolerance) << i;
  }

  // A unit right triangle in the plane z = 0 that emits 2 and reflects 1/4.
  static std::vector<std::uint32_t> mesh() {
    return words(0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, /*normal*/ 0.f, 0.f, 1.f,
                 /*colour*/ .25f, .25f, .25f, /*emission*/ 2.f, 2.f, 2.f);
  }
  // A rectangle of 2 x 1 in the plane y = 0.
  static std::vector<std::uint32_t> rectangle() {
    return words(4, 2, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 2.f, 0.f, 1.f, 2.f, 0.f, 0.f, 0,
                 1, 2, 0, 2, 3);
  }

  static inline std::unique_ptr<WorkerProcess> worker_;
};

TEST_F(Call, PartZero) {
  const auto hit = worker_->call(
      F::kRayTriangleIntersection, {},
      words(.25f, .25f, 2.f, 0.f, 0.f, -1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f));
  EXPECT_EQ(hit, words(1, 2.f));
  const auto nearest =
      worker_->call(F::kRayMeshIntersection, mesh(), words(.25f, .25f, 3.f, 0.f, 0.f, -1.f));
  ASSERT_EQ(nearest.size(), 20u);
  EXPECT_EQ(nearest[0], 1u);
  EXPECT_EQ(std::bit_cast<float>(nearest[1]), 3.0f);
  EXPECT_EQ(std::vector(nearest.begin() + 2, nearest.end()), mesh());
  const auto numbers = worker_->call(F::kGetRandomNumbers, {}, words(0, 0));
  ASSERT_EQ(numbers.size(), 4u);
  EXPECT_EQ(numbers[2], 0x18e431a7u);
  EXPECT_EQ(numbers[3], 0x055df4d1u);
  expectFloats(F::kSampleSphere, {}, words(.25f, .5f), {0, 1, 0});
  expectFloats(F::kSampleHemisphere, {}, words(.25f, .5f, 0.f, -1.f, 0.f), {0, -1, 0});
  const auto direct =
      worker_->call(F::kComputeDirectIllumination, mesh(), words(.25f, .25f, 0.f, 0, 0, 0));
  ASSERT_EQ(direct.size(), 5u);
  EXPECT_EQ(std::bit_cast<float>(direct[0]), 2.0f) << "nothing else is there to be seen";
  EXPECT_EQ(direct[3], 0x18e431a7u);
  const auto radiance =
      worker_->call(F::kGetRayRadiance, mesh(), words(.25f, .25f, 2.f, 0.f, 0.f, -1.f, 0, 0));
  ASSERT_EQ(radiance.size(), 5u);
  EXPECT_EQ(std::bit_cast<float>(radiance[1]), 2.0f);
}

TEST_F(Call, PartOne) {
  const auto camera = words(1.f, 2.f, 3.f, -2.f, 1.f, 1.f, 1.f, 0.f, 0.f, 0.f, -1.f, 0.f, 4, 2);
  // Film point (2, 1): straight ahead.
  expectFloats(F::kStratifiedRandomRay, camera, words(1, 0, 1, 1, 2, 1.f, 1.f), {1, 2, 3, 0, 0, 1});
  expectFloats(F::kRenderPixel, {}, words(3, 5, 4, 11, 0), {0.875f, 0.875f, 0.875f}, 1e-5f);
}

TEST_F(Call, PartTwo) {
  expectFloats(F::kTriangularSampling, rectangle(), words(0.f, .5f), {0, 0, 0, 0, 1, 0, 1});
  expectFloats(F::kRectangularSampling, rectangle(), words(.5f, .25f), {.5f, 0, .5f, 0, 1, 0, .5f});
  expectFloats(F::kPolygonSampling, rectangle(), words(0.f, 0.f), {0, 0, 0, 0, 1, 0, .5f});
  // From inside: by area. s = 0 is a pole of the sphere, whichever; the density says enough.
  const auto inside =
      worker_->call(F::kSphereSample, {}, words(0.f, 0.f, 0.f, 2.f, .5f, 0.f, 0.f, .5f, .5f));
  ASSERT_EQ(inside.size(), 7u);
  EXPECT_NEAR(std::bit_cast<float>(inside[6]), 1 / (16 * kPi), 1e-8f);
  // The point next to the viewer: distance 2, 1 - cos(thetaMax) = 1 - sqrt(3)/2.
  expectFloats(F::kSpherePdf, {},
               words(0.f, 0.f, 0.f, 2.f, 4.f, 0.f, 0.f, 2.f, 0.f, 0.f, 1.f, 0.f, 0.f),
               {1 / (2 * kPi * 4 * (1 - std::sqrt(3.0f) / 2))});
  // Within the glowing room direct light is Kd Le.
  expectFloats(F::kDirectLighting, {},
               words(3.f, 0.f, 0.f, -1.f, 0.f, 0.f, 1e-5f, 0, -1.f, 0.f, 0.f, 7, 0),
               {.25f, .25f, .25f}, 1e-5f);
}

TEST_F(Call, PartThree) {
  const auto kd = words(.3f, .6f, .9f);
  const auto up = words(0.f, 1.f, 0.f, 0.f, .6f, .8f, 0.f, 1.f, 0.f);
  expectFloats(F::kLambertianBrdf, kd, up, {.3f / kPi, .6f / kPi, .9f / kPi});
  expectFloats(F::kLambertianPdf, kd, up, {.6f / kPi});
  const auto sample = worker_->call(F::kLambertianReflection, kd,
                                    words(0.f, 1.f, 0.f, 0.f, 1.f, 0.f, .1f, .25f, .5f));
  ASSERT_EQ(sample.size(), 4u);
  EXPECT_NEAR(std::bit_cast<float>(sample[1]), .5f, 1e-6f);
  EXPECT_NEAR(std::bit_cast<float>(sample[3]), .5f / kPi, 1e-6f);
}

TEST_F(Call, PartFour) {
  const auto material = words(.1f, .1f, .1f, .5f, .5f, .5f, 2.f);
  const auto mirrored = words(0.f, .6f, .8f, 0.f, .6f, -.8f, 0.f, 1.f, 0.f);
  const float value = .1f / kPi + .5f * 4 / (2 * kPi);
  expectFloats(F::kPhongBrdf, material, mirrored, {value, value, value});
  const float density = (.1f * .6f / kPi + .5f * 3 / (2 * kPi)) / .6f;
  expectFloats(F::kPhongPdf, material, mirrored, {density});
  const auto sample = worker_->call(F::kPhongReflection, material,
                                    words(0.f, 1.f, 0.f, 0.f, 1.f, 0.f, .1f, .125f, .9f));
  ASSERT_EQ(sample.size(), 4u);
  EXPECT_NEAR(std::bit_cast<float>(sample[1]), .5f, 1e-6f) << "the cube root of t";
}

TEST_F(Call, PartsFiveAndSix) {
  expectFloats(F::kTracePath, {}, words(0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 3, 0),
               {0.875f, 0.875f, 0.875f}, 1e-5f);
  const auto dead = worker_->call(F::kRussianRoulette, {}, words(0.f, 0.f, 0.f, 5, .5f));
  EXPECT_EQ(dead, words(0, 0.f));
  const auto alive = worker_->call(F::kRussianRoulette, {}, words(.25f, .1f, .1f, 5, .25f));
  EXPECT_EQ(alive, words(1, 2.f));
}

}  // namespace
}  // namespace pathmark::test
