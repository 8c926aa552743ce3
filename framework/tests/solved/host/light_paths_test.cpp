// Renders of light path expressions: against closed forms, against scenes whose materials have one
// lobe only, against each other, and with coursework that traces its paths in other ways.
#include "film/compare.h"
#include "host/session.h"
#include "solved/support/other_tracers.h"
#include "solved/support/solutions.h"
#include "support/test_coursework_files.h"
#include "support/test_images.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <regex>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

// Chance of one comparison of two images with noise to fail a right one.
constexpr double kFalseFail = 1e-6;
constexpr std::uint32_t kReplicates = 16;

struct Wish {
  std::string scene;
  std::string paths{};  // empty: all light
  std::uint64_t rays = 4;
  std::uint32_t replicates = 1;
  std::uint64_t seed = 0;
  std::uint32_t threads = 2;
  int maxBounces = -1;
  int side = 24;
};

RenderOutcome outcomeOf(const Wish& wish, const Coursework& coursework = solutions()) {
  SceneOverrides overrides;
  overrides.size = {wish.side, wish.side};
  if (wish.maxBounces >= 0) overrides.maxBounces = wish.maxBounces;
  RenderOptions options;
  options.raysPerPixel = wish.rays;
  options.replicates = wish.replicates;
  options.seed = wish.seed;
  options.threads = wish.threads;
  if (!wish.paths.empty()) options.paths = PathExpression(wish.paths);
  return renderScene(coursework, loadScene(findScene(wish.scene), overrides), options);
}

Image render(const Wish& wish, const Coursework& coursework = solutions()) {
  return outcomeOf(wish, coursework).rendered.image;
}

Image noisy(const std::string& scene, const std::string& paths, std::uint64_t seed,
            const Coursework& coursework = solutions()) {
  return render({.scene = scene,
                 .paths = paths,
                 .rays = 64 * kReplicates,
                 .replicates = kReplicates,
                 .seed = seed},
                coursework);
}

// Of independent images.
void add(Image& sum, const Image& image) {
  for (std::size_t i = 0; i < sum.rgb.size(); ++i) {
    sum.rgb[i] += image.rgb[i];
    sum.variance[i] += image.variance[i];
  }
}

void expectSame(const Image& a, const Image& b) {
  CompareSettings settings;
  settings.alpha = kFalseFail;
  const Comparison comparison = compareImages(a, b, {kReplicates, kReplicates}, settings);
  std::string means;
  for (const RegionResult& r : comparison.whole)
    means += fmt::format("{} +- {} and {} +- {}\n", r.a, r.errorA, r.b, r.errorB);
  EXPECT_TRUE(comparison.judged);
  EXPECT_TRUE(comparison.same) << means;
}

TEST(LightPaths, OfAFurnaceHalveWithEveryScatteringEvent) {
  std::string events;
  for (int k = 0; k <= 4; ++k, events += 'D') {
    const Image image =
        render({.scene = "empty_furnace", .paths = "L" + events + "E", .maxBounces = 4});
    for (const float value : image.rgb)
      EXPECT_NEAR(static_cast<double>(value), std::pow(0.5, k + 1), 1e-6) << events;
  }
}

TEST(LightPaths, OfOneLobeAreThoseOfASceneWithoutTheOther) {
  TemporaryFolder folder;
  const auto without = [&](const std::string& scene, const char* lobe) {
    const std::string text = readText(findScene(scene));
    const std::regex reflectance(fmt::format(R"re("{}": *\[[^\]]*\])re", lobe));
    const fs::path file = folder / fmt::format("{}_without_{}.json", scene, lobe);
    writeText(file, std::regex_replace(text, reflectance, fmt::format(R"("{}": [0, 0, 0])", lobe)));
    return file.string();
  };
  for (const char* scene : {"cornell_phong", "veach_plates"}) {
    EXPECT_EQ(render({.scene = scene, .paths = "LD*E"}).rgb,
              render({.scene = without(scene, "Ks")}).rgb)
        << scene;
    EXPECT_EQ(render({.scene = scene, .paths = "LS*E"}).rgb,
              render({.scene = without(scene, "Kd")}).rgb)
        << scene;
  }
}

TEST(LightPaths, OfAllLightAreTheOrdinaryImageBitForBit) {
  for (const std::string& scene : shippedSceneNames()) {
    if (scene == "blob") continue;  // its mesh is made, not shipped
    const Image all = render({.scene = scene});
    EXPECT_EQ(render({.scene = scene, .paths = "L(S|D)*E"}).rgb, all.rgb) << scene;
    EXPECT_EQ(render({.scene = scene, .paths = "L(.?D|S+)*E|LE"}).rgb, all.rgb) << scene;
  }
}

struct Parts {
  const char* scene;
  std::vector<std::string> paths;
  std::string whole;  // empty: the ordinary image
};

class DisjointPaths : public testing::TestWithParam<Parts> {};

TEST_P(DisjointPaths, AddUpToTheWhole) {
  const auto& [scene, paths, whole] = GetParam();
  std::uint64_t seed = 11;
  Image sum = noisy(scene, paths.front(), seed);
  for (std::size_t k = 1; k < paths.size(); ++k) add(sum, noisy(scene, paths[k], ++seed));
  expectSame(sum, noisy(scene, whole, ++seed));
}

INSTANTIATE_TEST_SUITE_P(
    LightPaths, DisjointPaths,
    testing::Values(Parts{"cornell_phong", {"LE", "L.*DE", "L.*SE"}, ""},
                    Parts{"cornell_phong", {"LE", "LD.*E", "LS.*E"}, ""},
                    Parts{"cornell_phong", {"LD*E", "L.*S.*E"}, ""},
                    Parts{"cornell_phong", {"LDE", "LSSE", "LD+SE"}, "L(D|SS|D+S)E"},
                    Parts{"veach_plates", {"LE", "LDE", "LSE", "L..+E"}, ""},
                    Parts{"veach_plates", {"LS*E", "LD.*E", "LS+D.*E"}, ""},
                    Parts{"cornell_box", {"L(..)*E", "L.(..)*E"}, ""},
                    Parts{"many_lights", {"L.E|LE", "L..+E"}, ""}));

TEST(LightPaths, AreTheSameBitsForAnyNumberOfThreads) {
  const auto outcome = [](std::uint32_t threads) {
    return outcomeOf({.scene = "cornell_phong", .paths = "LD.*E", .rays = 80, .threads = threads});
  };
  const RenderOutcome one = outcome(1);
  for (const std::uint32_t threads : {2u, 3u, 7u}) {
    const RenderOutcome many = outcome(threads);
    EXPECT_EQ(many.rendered.image.rgb, one.rendered.image.rgb) << threads;
    EXPECT_EQ(many.rendered.raysTraced, one.rendered.raysTraced) << threads;
  }
}

TEST(LightPaths, ThatCannotBeTakeNoRay) {
  const RenderOutcome none = outcomeOf({.scene = "cornell_box", .paths = "L.*SE"});
  EXPECT_EQ(none.rendered.raysTraced, 0u);
  for (const float value : none.rendered.image.rgb) EXPECT_EQ(value, 0.0f);
  const auto rays = [](const std::string& paths) {
    return outcomeOf({.scene = "cornell_box", .paths = paths}).rendered.raysTraced;
  };
  EXPECT_LT(rays("LE"), rays("LDE"));
  EXPECT_LT(rays("LDE"), rays("LDDE"));
  EXPECT_LT(rays("LDDE"), rays(""));
}

class OtherTracer : public testing::Test {
 protected:
  void expectSolutionsImage(const Coursework& coursework) {
    for (const char* paths : {"LD.*E", "L.*SDE|LE", "LDDE"}) {
      SCOPED_TRACE(paths);
      expectSame(noisy("cornell_phong", paths, 21, coursework), noisy("cornell_phong", paths, 22));
    }
  }
  Coursework with(const char* tracePath) { return solutionsWith(tracePath, folder_.path()); }

  TemporaryFolder folder_;
};

TEST_F(OtherTracer, ThatAsksForDirectLightLastGivesTheSameImage) {
  expectSolutionsImage(with(kDirectLightLast));
}

TEST_F(OtherTracer, WhosePathsBranchGivesTheSameImage) { expectSolutionsImage(with(kBranching)); }

TEST_F(OtherTracer, ThatFindsLightsByChanceGivesTheSameImage) {
  expectSolutionsImage(with(kLightsByChance));
}

}  // namespace
}  // namespace pathmark::test
