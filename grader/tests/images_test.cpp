// Small images: everything together.
#include "sampling/pcg_sampler.h"
#include "tests/support/expect.h"
#include "tests/support/reference_tracer.h"
#include "tests/support/test_rooms.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace pathmark {
namespace {

using namespace testing;

constexpr int kRaysPerPixel = 20;  // 4 x 4 strata and four rays more
constexpr int kReplicates = 100;
constexpr int kBounces = 5;

using Image = std::vector<glm::dvec3>;

Image render(const TestScene& scene, int bounces, std::uint64_t seed) {
  const LitScene lit = scene.lit(bounces);
  const SimpleCamera& camera = scene.core().camera();
  Image image;
  PcgSampler sampler(seed);
  for (int j = 0; j < camera.height(); ++j) {
    for (int i = 0; i < camera.width(); ++i) {
      sampler.startPixel(i, j, 0);
      image.emplace_back(lit.renderPixel(i, j, camera, kRaysPerPixel, sampler));
    }
  }
  return image;
}

Image renderReference(const TestScene& scene, int bounces, Uniforms& random) {
  const ReferenceTracer reference(scene.flat());
  const SimpleCamera& camera = scene.core().camera();
  Image image;
  for (int j = 0; j < camera.height(); ++j) {
    for (int i = 0; i < camera.width(); ++i) {
      glm::dvec3 sum(0.0);
      for (int m = 0; m < kRaysPerPixel; ++m) {
        const glm::dvec3 direction = glm::dvec3(camera.topLeft()) +
                                     (i + random.nextDouble()) * glm::dvec3(camera.pixelRight()) +
                                     (j + random.nextDouble()) * glm::dvec3(camera.pixelDown());
        sum += reference.gather(glm::dvec3(camera.eye()), glm::normalize(direction), bounces, 1,
                                random);
      }
      image.push_back(sum / double(kRaysPerPixel));
    }
  }
  return image;
}

// Numbers that describe an image: the mean, the lowest cosine modes, and the means of tiles of
// 4 x 4 pixels; each channel by itself.
std::vector<double> features(const Image& image, const SimpleCamera& camera) {
  constexpr int kModes = 3, kTile = 4;
  std::vector<double> result;
  const int w = camera.width(), h = camera.height();
  const auto pixel = [&](int i, int j) { return image[std::size_t(j * w + i)]; };
  for (int c = 0; c < 3; ++c) {
    for (int a = 0; a < kModes; ++a) {
      for (int b = 0; b < kModes; ++b) {
        double sum = 0.0;
        for (int j = 0; j < h; ++j)
          for (int i = 0; i < w; ++i)
            sum += pixel(i, j)[c] * std::cos(std::numbers::pi * a * (i + 0.5) / w) *
                   std::cos(std::numbers::pi * b * (j + 0.5) / h);
        result.push_back(sum / (w * h));
      }
    }
    for (int y = 0; y + kTile <= h; y += kTile) {
      for (int x = 0; x + kTile <= w; x += kTile) {
        double sum = 0.0;
        for (int j = y; j < y + kTile; ++j)
          for (int i = x; i < x + kTile; ++i) sum += pixel(i, j)[c];
        result.push_back(sum / (kTile * kTile));
      }
    }
  }
  return result;
}

// Stratified rays are not independent, so the samples are whole images with their own seeds.
TEST(Image, AgreesWithAnotherEstimator) {
  const TestScene scene(unevenRoom());
  const SimpleCamera& camera = scene.core().camera();
  Uniforms random(701);
  std::vector<stats::RunningMoments> actual, expected;
  for (int r = 0; r < kReplicates; ++r) {
    const auto a = features(render(scene, kBounces, 1000 + std::uint64_t(r)), camera);
    const auto e = features(renderReference(scene, kBounces, random), camera);
    actual.resize(a.size());
    expected.resize(e.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      actual[k].add(a[k]);
      expected[k].add(e[k]);
    }
  }
  for (std::size_t k = 0; k < actual.size(); ++k)
    EXPECT_TRUE(meansAgree(actual[k], expected[k], {.alpha = kAlpha})) << "feature " << k;
}

TEST(Image, OfAFurnaceIsEven) {
  SceneBuilder builder = furnace();
  builder.camera({-1.2f, 0.3f, 0.2f}, {0.5f, -0.25f, 0.25f}, 1.0, 12, 8);
  const TestScene scene(builder);
  constexpr int kFurnaceReplicates = 64;
  std::vector<stats::RunningMoments> pixels;
  for (int r = 0; r < kFurnaceReplicates; ++r) {
    const Image image = render(scene, 8, 2000 + std::uint64_t(r));
    pixels.resize(image.size());
    for (std::size_t k = 0; k < image.size(); ++k) pixels[k].add(image[k].x);
  }
  for (const stats::RunningMoments& pixel : pixels)
    EXPECT_TRUE(meanIs(pixel, 1.0 - 0x1p-9, {.alpha = kAlpha, .tolerance = 1e-5}));
}

TEST(Image, OfTheSameSeedIsTheSameAndOfAnotherIsNot) {
  const TestScene scene(unevenRoom());
  EXPECT_EQ(render(scene, kBounces, 5), render(scene, kBounces, 5));
  EXPECT_NE(render(scene, kBounces, 5), render(scene, kBounces, 6));
}

// Each pixel has numbers of its own: neighbours under an even light still differ.
TEST(Image, HasNewNumbersInEachPixel) {
  const TestScene scene(unevenRoom());
  const Image first = render(scene, kBounces, 7), second = render(scene, kBounces, 8);
  double product = 0.0, squares = 0.0;
  for (std::size_t k = 0; k + 1 < first.size(); ++k) {
    const double here = first[k].x - second[k].x, next = first[k + 1].x - second[k + 1].x;
    product += here * next;
    squares += here * here;
  }
  EXPECT_LT(std::abs(product / squares), 0.5);
}

FlatScene changed(FlatScene scene, const std::function<Float3(const Float3&)>& change,
                  bool reflectances) {
  for (FlatShape& s : scene.shapes) s.emission = change(s.emission);
  for (FlatLight& l : scene.lights) l.emission = change(l.emission);
  for (FlatMaterial& m : scene.materials) {
    if (!reflectances) break;
    m.kd = change(m.kd);
    m.ks = change(m.ks);
  }
  return scene;
}

TEST(Image, OfTwiceTheEmissionIsTwiceAsBrightBitForBit) {
  const TestScene once(unevenRoom());
  const TestScene twice(changed(
      once.flat(),
      [](const Float3& e) {
        return Float3{2 * e[0], 2 * e[1], 2 * e[2]};
      },
      false));
  const Image dim = render(once, kBounces, 9), bright = render(twice, kBounces, 9);
  for (std::size_t k = 0; k < dim.size(); ++k) EXPECT_EQ(bright[k], 2.0 * dim[k]);
}

TEST(Image, OfPermutedChannelsIsPermuted) {
  FlatScene diffuse = unevenRoom().flat();
  // Phong's choice of a lobe adds the channels up, and sums in float depend on the order.
  for (FlatMaterial& m : diffuse.materials) m.kind = FlatMaterialKind::kLambertian;
  const TestScene rgb(diffuse);
  const TestScene gbr(changed(
      diffuse,
      [](const Float3& e) {
        return Float3{e[1], e[2], e[0]};
      },
      true));
  const Image first = render(rgb, kBounces, 10), second = render(gbr, kBounces, 10);
  for (std::size_t k = 0; k < first.size(); ++k)
    EXPECT_EQ(second[k], glm::dvec3(first[k].y, first[k].z, first[k].x));
}

}  // namespace
}  // namespace pathmark
