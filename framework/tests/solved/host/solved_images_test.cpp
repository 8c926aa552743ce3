// Whole renders with the solutions, from a scene file to an image, against closed forms.
#include "host/build_config.h"
#include "host/coursework_builder.h"
#include "host/session.h"
#include "solved/support/solutions.h"
#include "stats/mean_test.h"
#include "support/test_coursework_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>

namespace pathmark::test {
namespace {

// Chance of one of the statistical assertions of this file to fail a right image.
constexpr double kFalseFail = 1e-7;

Image render(const std::filesystem::path& scene, int maxBounces, std::uint64_t rays,
             std::uint64_t seed = 0) {
  SceneOverrides overrides;
  overrides.size = {16, 16};
  overrides.maxBounces = maxBounces;
  RenderOptions options;
  options.raysPerPixel = rays;
  options.seed = seed;
  return renderScene(solutions(), loadScene(scene, overrides), options).rendered.image;
}

void expectMean(const Image& image, double expected) {
  stats::RunningMoments pixels;
  for (std::size_t i = 1; i < image.rgb.size(); i += 3)
    pixels.add(static_cast<double>(image.rgb[i]));
  stats::MeanTest settings;
  settings.alpha = kFalseFail;
  settings.tolerance = 1e-6 * expected;  // rounding in float
  EXPECT_TRUE(stats::testMean(pixels, expected, settings).pass)
      << pixels.mean() << " +- " << pixels.standardError() << " instead of " << expected;
}

TEST(SolvedImage, AnEmptyFurnaceIsEvenWithoutNoise) {
  for (const int bounces : {0, 1, 2, 3, 4}) {
    const double expected = 1.0 - std::pow(0.5, bounces + 1);
    for (const float value : render(findScene("empty_furnace"), bounces, 4).rgb)
      EXPECT_NEAR(static_cast<double>(value), expected, 2e-6) << bounces;
  }
}

TEST(SolvedImage, AFurnaceWithASphereInItIsEvenInTheMean) {
  for (const int bounces : {1, 2, 8})
    expectMean(render(findScene("furnace"), bounces, 256), 1.0 - std::pow(0.5, bounces + 1));
}

// A lamp over a floor, in three ways: the choice of a face by area must not show.
TEST(SolvedImage, ABoxOrAMeshThatShinesGivesTheLightOfItsFaces) {
  TemporaryFolder folder;
  const auto render = [&](const std::string& lamp) {
    std::ofstream(folder / "scene.json") << fmt::format(
        R"({{"camera": {{"eye": [0, 3, 4], "target": [0.4, 0, 0], "fieldOfView": 20}},
            "materials": {{"grey": {{"type": "lambertian", "Kd": [0.6, 0.6, 0.6]}},
                           "black": {{"type": "lambertian", "Kd": [0, 0, 0]}}}},
            "shapes": [{{"type": "rectangle", "material": "grey",
                         "vertices": [[-5, 0, 5], [5, 0, 5], [5, 0, -5], [-5, 0, -5]]}}, {}]}})",
        lamp);
    stats::RunningMoments images;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
      const Image image = pathmark::test::render(folder / "scene.json", 1, 64, seed);
      images.add(std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0) /
                 static_cast<double>(image.rgb.size()));
    }
    return images;
  };
  // A tile that stands on its edge: its faces' areas are 0.08, 0.4 and 0.2 each.
  const auto box = render(
      R"({"type": "box", "material": "black", "emission": [3, 3, 3],
          "low": [-0.5, 1, -0.1], "high": [0.5, 1.4, 0.1]})");
  std::string faces;
  for (const char* f : {"-0.5,1,-0.1],[-0.5,1,0.1],[-0.5,1.4,0.1],[-0.5,1.4,-0.1",
                        "0.5,1,-0.1],[0.5,1.4,-0.1],[0.5,1.4,0.1],[0.5,1,0.1",
                        "-0.5,1,-0.1],[0.5,1,-0.1],[0.5,1,0.1],[-0.5,1,0.1",
                        "-0.5,1.4,-0.1],[-0.5,1.4,0.1],[0.5,1.4,0.1],[0.5,1.4,-0.1",
                        "-0.5,1,-0.1],[-0.5,1.4,-0.1],[0.5,1.4,-0.1],[0.5,1,-0.1",
                        "-0.5,1,0.1],[0.5,1,0.1],[0.5,1.4,0.1],[-0.5,1.4,0.1"})
    faces += fmt::format(
        R"({}{{"type": "rectangle", "material": "black", "emission": [3, 3, 3],
              "vertices": [[{}]]}})",
        faces.empty() ? "" : ",", f);
  std::ofstream(folder / "lamp.obj")
      << "v -5 10 -1\nv 5 10 -1\nv -5 14 -1\nv 5 14 -1\nv -5 10 1\nv 5 10 1\nv -5 14 1\nv 5 14 1\n"
         "f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\nf 5 6 8 7\n";
  const auto mesh = render(
      R"({"type": "mesh", "material": "black", "emission": [3, 3, 3], "file": "lamp.obj",
          "transform": {"scale": 0.1}})");
  const auto separate = render(faces);
  stats::MeanTest settings;
  settings.alpha = kFalseFail;
  settings.tolerance = 1e-6 * separate.mean();
  EXPECT_GT(separate.mean(), 100.0 * separate.standardError());
  EXPECT_TRUE(stats::testMeans(box, separate, settings).pass)
      << box.mean() << " instead of " << separate.mean();
  EXPECT_TRUE(stats::testMeans(mesh, separate, settings).pass)
      << mesh.mean() << " instead of " << separate.mean();
}

struct Placement {
  double scale;
  std::array<double, 3> shift;
};

class AtPlaces : public testing::TestWithParam<Placement> {
 protected:
  std::string at(double x, double y, double z) const {
    const auto& [scale, shift] = GetParam();
    return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", scale * x + shift[0], scale * y + shift[1],
                       scale * z + shift[2]);
  }
  // A floor of reflectance 0.6, seen at its origin through a very long lens, and a light.
  std::filesystem::path write(const std::string& light) {
    const std::filesystem::path file = folder_ / "scene.json";
    std::ofstream(file) << fmt::format(
        R"({{"camera": {{"eye": {}, "target": {}, "fieldOfView": 0.05}},
            "materials": {{"grey": {{"type": "lambertian", "Kd": [0.6, 0.6, 0.6]}},
                           "black": {{"type": "lambertian", "Kd": [0, 0, 0]}}}},
            "shapes": [{{"type": "rectangle", "material": "grey",
                         "vertices": [{}, {}, {}, {}]}}, {}]}})",
        at(1, 0.4, 0.2), at(0, 0, 0), at(-5, 0, 5), at(5, 0, 5), at(5, 0, -5), at(-5, 0, -5),
        light);
    return file;
  }
  TemporaryFolder folder_;
};

// The form factor from a point to a parallel rectangle a x b at height h above it, centred.
double formFactor(double a, double b, double h) {
  const double x = a / (2 * h), y = b / (2 * h);
  const double p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
  return 4 / (2 * std::numbers::pi) * (x / p * std::atan(y / p) + y / q * std::atan(x / q));
}

TEST_P(AtPlaces, DirectLightOfARectangleIsItsFormFactor) {
  const auto file = write(fmt::format(
      R"({{"type": "rectangle", "material": "black", "emission": [3, 3, 3],
           "vertices": [{}, {}, {}, {}]}})",
      at(-0.75, 1, -0.5), at(0.75, 1, -0.5), at(0.75, 1, 0.5), at(-0.75, 1, 0.5)));
  expectMean(render(file, 1, 1024), 0.6 * 3 * formFactor(1.5, 1.0, 1.0));
}

// E = pi L (r/d)^2 cos(theta), the sphere wholly above the horizon.
TEST_P(AtPlaces, DirectLightOfASphereIsTheInverseSquare) {
  const auto& scale = GetParam().scale;
  const auto file = write(fmt::format(
      R"({{"type": "sphere", "material": "black", "emission": [3, 3, 3],
           "centre": {}, "radius": {:.17g}}})",
      at(-0.6, 0.8, 0.0), 0.3 * scale));
  expectMean(render(file, 1, 1024), 0.6 * 3 * 0.09 * 0.8);
}

INSTANTIATE_TEST_SUITE_P(Scales, AtPlaces,
                         testing::Values(Placement{1, {0, 0, 0}}, Placement{1e-6, {0, 0, 0}},
                                         Placement{1e6, {0, 0, 0}}, Placement{1, {1e5, -2e5, 3e5}},
                                         Placement{1e-3, {2, 1, -3}}));

}  // namespace
}  // namespace pathmark::test
