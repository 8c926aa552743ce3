// The reference images that are shipped: of the scenes as they are, and right.
#include "host/reference.h"
#include "film/compare.h"
#include "film/own_error.h"
#include "host/blob_file.h"
#include "host/session.h"
#include "scene/blob_mesh.h"
#include "solved/support/solutions.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <fstream>

namespace pathmark::test {
namespace {

// Chance of one scene's comparison to fail although its picture is right.
constexpr double kFalseFail = 1e-6;

// tracePath finds light that a smooth plate mirrors so seldom that between few replicates there is
// no sign of what it lacks.
Estimator estimatorThatTells(const std::string& scene) {
  return scene == "veach_plates" ? Estimator::kMis : Estimator::kPath;
}

class Reference : public testing::TestWithParam<std::string> {
 protected:
  // The mesh of the blob is made in a folder of this test's own.
  LoadedScene load() const {
    const std::filesystem::path shipped = shippedSceneFile(GetParam());
    if (!needsShippedBlobFile(shipped)) return loadScene(shipped);
    std::filesystem::copy_file(shipped, folder_ / "blob.json");
    std::filesystem::create_directory(folder_ / "meshes");
    writeBlobFile(folder_ / "meshes/blob.obj", kBlobSubdivisions);
    return loadScene(folder_ / "blob.json");
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(Reference, IsOfTheSceneAsItIsAndSaysHowGoodItIs) {
  const std::optional<ImageFile> reference = readReference(load());
  ASSERT_TRUE(reference) << "./pathmark reference makes it";
  ASSERT_EQ(reference->image.variance.size(), reference->image.rgb.size());
  EXPECT_GE(reference->origin.replicates, 8u);
  EXPECT_EQ(reference->origin.coursework, "solutions");
  EXPECT_LT(ownError(reference->image).ofMean, 5e-3);
  EXPECT_LT(std::filesystem::file_size(referenceFile(GetParam())), 1u << 20);
}

TEST_P(Reference, AgreesWithANewRender) {
  const LoadedScene scene = load();
  const std::optional<ImageFile> reference = readReference(scene);
  ASSERT_TRUE(reference);
  RenderOptions options;
  options.raysPerPixel = 32;
  options.replicates = 8;
  options.seed = 20;  // any but the reference's
  options.estimator = estimatorThatTells(GetParam());
  ImageFile made;
  made.image = renderScene(solutions(), scene, options).rendered.image;
  made.origin.replicates = options.replicates;
  CompareSettings settings;
  settings.alpha = kFalseFail;
  const Comparison comparison = compareImages(made, *reference, settings);
  for (const RegionResult& channel : comparison.whole) {
    EXPECT_FALSE(channel.differs) << "channel " << channel.channel << ": " << channel.a << " +- "
                                  << channel.errorA << " instead of " << channel.b << " +- "
                                  << channel.errorB;
    EXPECT_LT(channel.errorA, 0.05 * channel.a) << "too noisy to tell anything";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Reference, testing::ValuesIn(shippedSceneNames()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace pathmark::test
