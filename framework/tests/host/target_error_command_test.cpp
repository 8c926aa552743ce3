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

TEST_F(TargetError, RaysThatAreAllowedAndNotMadeAreTold) {
  const auto withAtMost = [&](const char* rays) {
    return render({"--target-error", "1%", "--sampler", "pcg", "--rays-per-pixel", rays});
  };
  const ProcessResult odd = withAtMost("127");
  expectSays(odd, 0, "Of the 127 rays per pixel that are allowed at most 64 are made");
  expectSays(odd, 0,
             "0 of 6 within 1 %.\nBy what the first rays told, 6 of the 6 tiles would have needed "
             "more than 64 rays per pixel, which is the most.");
  const ProcessResult even = withAtMost("128");
  expectSays(even, 0, "128.0 rays per pixel in the mean");
  EXPECT_EQ(even.output.find("are allowed"), std::string::npos) << even.output;
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
  expectSays(render({"--target-error", "20%", "--checkpoint-every", "1"}), 2,
             "keeps no checkpoint");
  expectSays(render({"--target-error", ""}), 2,
             "--target-error: found nothing, allowed is a share");
  expectSays(render({"--output", ""}), 2, "--output: found nothing, allowed is the name of a file");
  expectSays(render({"--size", ""}), 2, "--size: found nothing");
  expectSays(render({"--target-error", "20%", "--ray-map", ""}), 2, "--ray-map: found nothing");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(TargetError, HelpNamesWhatIsRefused) {
  const ProcessResult help = render({"--help"});
  expectSays(help, 0, "not with --replicates, --resume, --keep-checkpoint or --checkpoint-every");
  expectSays(help, 0, "With --target-error, also write how many rays");
}

TEST_F(TargetError, TheMapOfRaysIsNotWrittenOverThePicture) {
  const std::string absolute = (folder_ / "picture.png").string();
  for (const std::string& map :
       {std::string("picture.png"), std::string("./picture.png"), absolute})
    expectSays(render({"--target-error", "20%", "--output", "picture.png", "--ray-map", map}), 2,
               "--ray-map " + map + ": this is the picture's own file.");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(TargetError, ExplainTellsOfTheFilmsAndTheirPasses) {
  const ProcessResult result =
      render({"--target-error", "4%", "--rays-per-pixel", "1000", "--explain"});
  expectSays(result, 0, "from 64 to 960 per pixel, as many as each tile needs for an error of 4 %");
  expectSays(result, 0, "sobol, for each of 4 films, in 1 to 15 passes of 16 (seed 0)");
  expectSays(result, 0, "4, the films (their differences tell");
  EXPECT_EQ(result.output.find("without --replicates"), std::string::npos) << result.output;
  expectSays(render({"--target-error", "4%", "--rays-per-pixel", "32", "--explain"}), 2,
             "fewer than the 64");
}

}  // namespace
}  // namespace pathmark::test
