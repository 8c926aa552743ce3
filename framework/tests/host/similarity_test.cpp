// Shipped scenes in other units and at other places give the same image.
#include "host/blob_file.h"
#include "host/session.h"
#include "support/moved_scene.h"
#include "support/solutions.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace pathmark::test {
namespace {

constexpr int kSide = 64, kBlock = 8;

// The same random numbers are used at every place, so that images differ by rounding alone: by the
// few paths that it sends another way.
constexpr double kTolerance = 1e-3;

Image render(const std::filesystem::path& scene) {
  SceneOverrides overrides;
  overrides.size = {kSide, kSide};
  RenderOptions options;
  options.raysPerPixel = 256;
  return renderScene(solutions(), loadScene(scene, overrides), options).rendered.image;
}

// Sums of 8x8 pixels, all channels together, and of the whole image at the end.
std::vector<double> sums(const Image& image) {
  constexpr int kBlocks = kSide / kBlock;
  std::vector<double> result(kBlocks * kBlocks + 1);
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      for (const float value : image.pixel(i, j)) {
        const int block = j / kBlock * kBlocks + i / kBlock;
        result[static_cast<std::size_t>(block)] += static_cast<double>(value);
        result.back() += static_cast<double>(value);
      }
    }
  }
  return result;
}

class Similar : public testing::TestWithParam<std::string> {
 protected:
  // The shipped scene elsewhere; the blob with fewer triangles, which are made faster.
  Image renderAt(const Similarity& similarity) const {
    TemporaryFolder folder;
    std::ofstream(folder / "scene.json") << movedScene(shippedSceneFile(GetParam()), similarity);
    if (needsShippedBlobFile(shippedSceneFile(GetParam()))) {
      std::filesystem::create_directory(folder / "meshes");
      writeBlobFile(folder / "meshes/blob.obj", 40);
    }
    return render(folder / "scene.json");
  }
};

TEST_P(Similar, ImagesAtEveryScaleAndPlace) {
  const std::vector<double> original = sums(renderAt({1.0, 0.0}));
  // A block that is almost black is judged by a thousandth of the mean block.
  const double dark = 1e-3 * original.back() / static_cast<double>(original.size() - 1);
  for (const Similarity& similarity : {Similarity{1e-6, 1e4}, Similarity{1e6, -1e4},
                                       Similarity{1e-30, 0.0}, Similarity{1e30, -1e9}}) {
    const std::vector<double> moved = sums(renderAt(similarity));
    const auto expectNear = [&](std::size_t i) {
      EXPECT_NEAR(moved[i], original[i], kTolerance * std::max(original[i], dark))
          << "block " << i << ", scale " << similarity.scale << ", shift " << similarity.shift;
    };
    expectNear(original.size() - 1);
    // At a billion sizes from the origin a double keeps seven digits of the scene. Where a picture
    // is meant to show noise, a single path that goes another way can then be seen in its block.
    if (std::abs(similarity.shift) > 1e8 && GetParam().starts_with("diy_")) continue;
    for (std::size_t i = 0; i + 1 < original.size(); ++i) expectNear(i);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Similar, testing::ValuesIn(shippedSceneNames()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace pathmark::test
