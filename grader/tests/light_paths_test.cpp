// Whatever is right but different is right under a light path expression too.
#include "film/compare.h"
#include "host/coursework_builder.h"
#include "host/session.h"
#include "support/test_coursework_files.h"
#include "variants/variant.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::test {
namespace {

// Chance of one variant to fail though it is right.
constexpr double kFalseFail = 1e-6;
constexpr std::uint32_t kReplicates = 16;

// Both the choice of lobes by chance and that of lights take part.
constexpr const char* kScene = "veach_plates";
constexpr const char* kPaths = "LE|LD.*E|LS.SE";

Image render(const Coursework& coursework, std::uint64_t seed) {
  SceneOverrides overrides;
  overrides.size = {30, 20};
  overrides.maxBounces = 4;
  RenderOptions options;
  options.raysPerPixel = 32 * kReplicates;
  options.replicates = kReplicates;
  options.seed = seed;
  options.paths = PathExpression(kPaths);
  return renderScene(coursework, loadScene(findScene(kScene), overrides), options).rendered.image;
}

const Image& solved() {
  static const Image image = render(prepareCoursework("solutions"), 41);
  return image;
}

class RightButDifferent : public testing::TestWithParam<Variant> {};

TEST_P(RightButDifferent, GivesTheSameImageOfLightPaths) {
  const TemporaryFolder folder;
  applyVariant(GetParam(), folder.path());
  const CourseworkBuild build = buildCoursework(folder.path());
  ASSERT_FALSE(build.worker.empty()) << build.failure();
  const Image image = render({GetParam().name, build.folder, build.worker}, 42);
  CompareSettings settings;
  settings.alpha = kFalseFail;
  const Comparison comparison =
      compareImages(image, solved(), {kReplicates, kReplicates}, settings);
  std::string means;
  for (const RegionResult& r : comparison.whole)
    means += fmt::format("{} +- {} and {} +- {}\n", r.a, r.errorA, r.b, r.errorB);
  EXPECT_TRUE(comparison.judged);
  EXPECT_TRUE(comparison.same) << GetParam().what << "\n" << means;
}

std::vector<Variant> correctOnes() {
  std::vector<Variant> variants = allVariants();
  std::erase_if(variants, [](const Variant& v) { return v.wrong || v.part < 2; });
  return variants;
}

INSTANTIATE_TEST_SUITE_P(Variants, RightButDifferent, testing::ValuesIn(correctOnes()),
                         [](const auto& tried) { return tried.param.name; });

}  // namespace
}  // namespace pathmark::test
