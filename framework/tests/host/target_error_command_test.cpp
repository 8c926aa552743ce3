// render --target-error, as a user would.
#include "film/image_file.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

class TargetError : public testing::Test {
 protected:
  TargetError() {
    coursework_.setTracePath("return Colour(sampler.next1D() < 0.5f ? 0.5f : 1.5f);");
  }

  ProcessResult render(std::vector<std::string> more) {
    std::vector<std::string> words{
        PATHMARK_PROGRAM, "render", "cornell_box", "--with", coursework_.folder().string(),
        "--size",         "48x32"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words, folder_.path());
  }

  TestCoursework coursework_;
  TemporaryFolder folder_;
};

TEST_F(TargetError, WritesThePictureItsErrorAndTheMapOfRays) {
  const ProcessResult result = render({"--target-error", "5%", "--sampler", "pcg", "--output",
                                       "picture.exr", "--ray-map", "rays.pfm"});
  expectSays(result, 0, "in the worst");
  const ImageFile file = readImage(folder_ / "picture.exr");
  EXPECT_EQ(file.origin.targetError, 0.05);
  EXPECT_GT(file.origin.worstTileError, 0.03);
  EXPECT_LT(file.origin.worstTileError, 0.07);
  EXPECT_EQ(file.origin.replicates, 4u);
  EXPECT_EQ(file.image.variance.size(), file.image.rgb.size());
  const Image map = readImage(folder_ / "rays.pfm").image;
  double sum = 0.0;
  for (std::size_t i = 0; i < map.rgb.size(); i += 3) sum += static_cast<double>(map.rgb[i]);
  EXPECT_NEAR(sum * 3.0 / static_cast<double>(map.rgb.size()), file.origin.raysPerPixel, 1e-3);
  expectSays(render({"--target-error", "0.05", "--output", "picture.png", "--ray-map", "rays.png"}),
             0, "which is white");
}

TEST_F(TargetError, WhatDoesNotGoTogetherIsASentence) {
  expectSays(render({"--target-error", "0%"}), 2, "such as 1% or 0.01");
  expectSays(render({"--target-error", "fine"}), 2, "such as 1% or 0.01");
  expectSays(render({"--target-error", "1%", "--replicates", "16", "--rays-per-pixel", "64"}), 2,
             "do not go together");
  expectSays(render({"--target-error", "1%", "--resume"}), 2, "keeps no checkpoint");
  expectSays(render({"--target-error", "1%", "--keep-checkpoint"}), 2, "keeps no checkpoint");
  expectSays(render({"--target-error", "1%", "--rays-per-pixel", "32"}), 2, "fewer than the 64");
  expectSays(render({"--ray-map", "rays.png"}), 2, "for pictures with a --target-error");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace pathmark::test
