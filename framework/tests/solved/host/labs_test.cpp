// The labs of the solutions: every estimator has the same mean as the coursework itself.
//
// A whole picture of a lab that is right is called different with a probability below 1e-6; the
// seeds are fixed, so that the result is always the same.
#include "film/compare.h"
#include "host/coursework_builder.h"
#include "host/lab.h"
#include "host/session.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

constexpr double kAlpha = 1e-6;
constexpr std::uint32_t kReplicates = 32;

LoadedScene small(const std::string& name, int maxBounces) {
  return loadScene(shippedSceneFile(name), {.size = {{16, 16}}, .maxBounces = maxBounces});
}

Image picture(const std::string& with, const LoadedScene& scene, std::uint64_t raysPerPixel,
              std::uint64_t seed) {
  RenderOptions options;
  options.raysPerPixel = raysPerPixel;
  options.replicates = kReplicates;
  options.seed = seed;
  options.secondsWithoutAnswer = 120.0;
  return renderScene(prepareCoursework(with), scene, options).rendered.image;
}

std::string labFolder(const std::string& lab) {
  return (courseworkFolder("solutions") / "labs" / lab).string();
}

Comparison compared(const Image& a, const Image& b) {
  CompareSettings settings;
  settings.alpha = kAlpha;
  return compareImages(a, b, {kReplicates, kReplicates}, settings);
}

class Labs : public testing::TestWithParam<std::string> {};

TEST_P(Labs, AllHaveTheMeanOfTheCoursework) {
  const LoadedScene scene = small(GetParam(), 4);
  const Image truth = picture("solutions", scene, 2048, 1);
  const std::vector<std::string> labs = labNames(courseworkFolder("solutions"));
  ASSERT_EQ(labs.size(), 10u);
  for (const std::string& lab : labs)
    EXPECT_TRUE(compared(picture(labFolder(lab), scene, 512, 2), truth).same) << lab;
}

// That the same comparison finds light that is missing: of the last two of four scattering events.
TEST_P(Labs, TwoEventsFewerAreADifference) {
  const Image truth = picture("solutions", small(GetParam(), 4), 2048, 1);
  EXPECT_FALSE(compared(picture(labFolder("cosine"), small(GetParam(), 2), 512, 2), truth).same);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Labs,
                         testing::Values("cornell_box", "cornell_phong", "many_lights"));

TEST(LabFolders, HaveWhatTheyDoNotChangeFromTheirCoursework) {
  const CourseworkBuild build = buildCoursework(labFolder("uniform"));
  ASSERT_TRUE(build.complete()) << build.failure();
  EXPECT_EQ(build.parts[5].source.parent_path().filename(), "uniform");
  EXPECT_EQ(build.parts[2].source.parent_path().filename(), "solutions");
  EXPECT_FALSE(isLab(courseworkFolder("solutions")));
}

TEST(LabFolders, OfAStudentHaveStubs) {
  for (const std::string& lab : labNames(courseworkFolder("student"))) {
    const CourseworkBuild build =
        buildCoursework(courseworkFolder("student") / "labs" / lab, Incomplete::kCompileOnly);
    for (const PartBuild& part : build.parts) {
      EXPECT_TRUE(part.compiled) << lab << part.messages;
      EXPECT_EQ(part.messages, "") << lab;
    }
  }
}

}  // namespace
}  // namespace pathmark::test
