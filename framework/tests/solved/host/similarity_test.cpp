// Shipped scenes in other units and at other places give the same image.
#include "bench/stress/moved_scene.h"
#include "host/blob_file.h"
#include "host/session.h"
#include "solved/support/solutions.h"
#include "support/test_coursework_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

namespace pathmark::test {
namespace {

using bench::movedScene;
using bench::Similarity;

constexpr int kSide = 64, kBlock = 8;

// The same random numbers are used at every place, so that images differ by rounding alone: by the
// few paths that it sends another way.
constexpr double kTolerance = 1e-3;

// A single such path can be more than a thousandth of its block. It is in one seed's image only,
// whereas a difference of the scene's geometry is in all.
constexpr std::size_t kSeeds = 9;

Image render(const LoadedScene& scene, std::uint64_t seed) {
  RenderOptions options;
  options.raysPerPixel = 32;
  options.seed = seed;
  return renderScene(solutions(), scene, options).rendered.image;
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
  // Of each seed's image of the shipped scene elsewhere; the blob with fewer triangles, which are
  // made faster.
  std::vector<std::vector<double>> sumsAt(const Similarity& similarity) const {
    TemporaryFolder folder;
    std::ofstream(folder / "scene.json") << movedScene(shippedSceneFile(GetParam()), similarity);
    if (needsShippedBlobFile(shippedSceneFile(GetParam()))) {
      std::filesystem::create_directory(folder / "meshes");
      writeBlobFile(folder / "meshes/blob.obj", 40);
    }
    SceneOverrides overrides;
    overrides.size = {kSide, kSide};
    const LoadedScene scene = loadScene(folder / "scene.json", overrides);
    std::vector<std::vector<double>> result;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) result.push_back(sums(render(scene, seed)));
    return result;
  }
};

double meanOf(const std::vector<std::vector<double>>& sumsOfSeeds, std::size_t i) {
  double sum = 0.0;
  for (const std::vector<double>& sums : sumsOfSeeds) sum += sums[i];
  return sum / static_cast<double>(sumsOfSeeds.size());
}

double medianDifference(const std::vector<std::vector<double>>& a,
                        const std::vector<std::vector<double>>& b, std::size_t i) {
  std::array<double, kSeeds> differences{};
  for (std::size_t seed = 0; seed < kSeeds; ++seed) differences[seed] = a[seed][i] - b[seed][i];
  std::nth_element(differences.begin(), differences.begin() + kSeeds / 2, differences.end());
  return differences[kSeeds / 2];
}

TEST_P(Similar, ImagesAtEveryScaleAndPlace) {
  const auto original = sumsAt({1.0, 0.0});
  const std::size_t blocks = original[0].size() - 1;
  const double whole = meanOf(original, blocks);
  // A block that is almost black is judged by a thousandth of the mean block.
  const double dark = 1e-3 * whole / static_cast<double>(blocks);
  for (const Similarity& similarity : {Similarity{1e-6, 1e4}, Similarity{1e6, -1e4},
                                       Similarity{1e-30, 0.0}, Similarity{1e30, -1e9}}) {
    SCOPED_TRACE(fmt::format("scale {}, shift {}", similarity.scale, similarity.shift));
    const auto moved = sumsAt(similarity);
    EXPECT_NEAR(meanOf(moved, blocks), whole, kTolerance * whole);
    for (std::size_t i = 0; i < blocks; ++i)
      EXPECT_NEAR(medianDifference(moved, original, i), 0.0,
                  kTolerance * std::max(meanOf(original, i), dark))
          << "block " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Similar, testing::ValuesIn(shippedSceneNames()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace pathmark::test
