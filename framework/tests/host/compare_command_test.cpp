// pathmark compare, run as a program: what it prints, writes and returns.
#include "film/image_file.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"
#include "support/test_images.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace pathmark::test {
namespace {

using testing::Uniforms;

class CompareCommand : public ::testing::Test {
 protected:
  ProcessResult compare(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {PATHMARK_PROGRAM, "compare"});
    return run(arguments, folder_.path());
  }
  void write(const std::string& name, const Image& image, const ImageOrigin& origin = {}) {
    writeImage(folder_ / name, image, 1.0, origin);
  }
  // Normal noise of 1 % in 16 replicates; the pixels of one tile are multiplied by `inTile`.
  void writeNoisy(const std::string& name, std::uint64_t seed, float inTile = 1.0f) {
    Uniforms random(seed);
    Image image = gradientImage(32, 24);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      const std::size_t column = i / 3 % 32, row = i / 3 / 32;
      const double mean = 0.5 + image.rgb[i], error = 0.01 * mean;
      const bool biased = column >= 16 && column < 24 && row >= 8 && row < 16;
      image.rgb[i] = static_cast<float>(mean + error * random.nextNormal()) * (biased ? inTile : 1);
      double chiSquare = 0.0;
      for (int k = 0; k < 15; ++k) chiSquare += std::pow(random.nextNormal(), 2);
      image.variance.push_back(static_cast<float>(error * error * chiSquare / 15.0));
    }
    write(name, image,
          {.scene = "room",
           .sceneHash = "1",
           .coursework = "mine",
           .raysPerPixel = 256,
           .replicates = 16,
           .seed = seed,
           .sampler = "pcg"});
  }

  TemporaryFolder folder_;
};

TEST_F(CompareCommand, BlackHasNoRatio) {
  Image black = gradientImage(9, 7);
  for (float& value : black.rgb) value = 0.0f;
  write("black.pfm", black);
  write("light.pfm", gradientImage(9, 7));
  for (const auto& [other, code] : {std::pair{"black.pfm", 0}, std::pair{"light.pfm", 1}}) {
    const ProcessResult result = compare({other, "black.pfm"});
    expectSays(result, code, "0         -");
    EXPECT_EQ(result.output.find("nan"), std::string::npos) << result.output;
    EXPECT_EQ(result.output.find("inf"), std::string::npos) << result.output;
  }
}

TEST_F(CompareCommand, EqualImagesAreTheSame) {
  for (const char* name : {"a.exr", "a.pfm", "a.hdr", "a.png"}) {
    write(name, gradientImage(9, 7));
    expectSays(compare({name, name}), 0, "The same: every value is equal.");
  }
}

TEST_F(CompareCommand, FormatsCanBeMixed) {
  write("a.exr", gradientImage(9, 7));
  write("a.pfm", gradientImage(9, 7));
  write("a.png", gradientImage(9, 7));
  expectSays(compare({"a.exr", "a.pfm"}), 0, "every value is equal");
  const ProcessResult png = compare({"a.png", "a.exr"});
  expectSays(png, 1, "A has only 8 bits a value, after exposure and clipping");
  expectSays(compare({"a.png", "a.exr", "--within", "1%"}), 0, "The same within 1 %");
}

TEST_F(CompareCommand, WithoutVariancesItSaysWhatWouldBeAccepted) {
  Image image = gradientImage(9, 7);
  write("a.pfm", image);
  image.rgb[5] *= 1.0001f;
  write("b.pfm", image);
  const ProcessResult result = compare({"a.pfm", "b.pfm"});
  expectSays(result, 1, "They differ: 1 of 189 values are not equal.");
  expectSays(result, 1, "--within 1% accepts");
  expectSays(compare({"a.pfm", "b.pfm", "--within", "0.001"}), 0, "The same within 0.1 %");
}

TEST_F(CompareCommand, NoiseIsNoDifferenceAndABiasedTileIsNamed) {
  writeNoisy("a.exr", 1);
  writeNoisy("b.exr", 2);
  writeNoisy("c.exr", 3, 1.02f);
  expectSays(compare({"a.exr", "b.exr"}), 0, "The same within their noise");
  const ProcessResult biased = compare({"c.exr", "b.exr"});
  expectSays(biased, 1, "They differ: ");
  expectSays(biased, 1, "\n    16      8 ");
  expectSays(
      biased, 1,
      "A  c.exr: 32x24; room, mine, 256 rays per pixel in 16 replicates, seed 3, sampler pcg");
  expectSays(compare({"c.exr", "b.exr", "--within", "5%"}), 0, "within their noise and 5 %");
}

TEST_F(CompareCommand, WhatLimitsTheComparisonIsSaid) {
  writeNoisy("a.exr", 1);
  write("b.pfm", readImage(folder_ / "a.exr").image);
  write("c.exr", gradientImage(32, 24, 100.0f), {.scene = "hall", .sceneHash = "2"});
  expectSays(compare({"a.exr", "b.pfm"}), 0, "Only A has variances: B counts as exact.");
  const ProcessResult result = compare({"c.exr", "a.exr"});
  expectSays(result, 0,
             "A does not say from how many replicates its variances are: 2 are assumed.");
  expectSays(result, 0, "They are of different scenes: hall and room.");
}

TEST_F(CompareCommand, OneSceneInTwoWaysIsNotCalledTwoScenes) {
  write("a.exr", gradientImage(9, 7), {.scene = "room", .sceneHash = "1"});
  write("b.exr", gradientImage(9, 7), {.scene = "room", .sceneHash = "2"});
  const ProcessResult result = compare({"a.exr", "b.exr"});
  expectSays(result, 0, "Both are of room, but of another version");
  expectSays(result, 0, "or only one of them by --solid-angle.");
  EXPECT_EQ(result.output.find("different scenes"), std::string::npos) << result.output;
}

TEST_F(CompareCommand, OfANoisyPictureWithoutVariancesNoVerdictIsGiven) {
  writeNoisy("reference.exr", 1);
  Image image = readImage(folder_ / "reference.exr").image;
  image.variance.clear();
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] *= i % 2 == 0 ? 1.3f : 0.7f;
  for (std::size_t i = 0; i < 24; ++i) image.rgb[i] *= 2.0f;
  write("mine.exr", image);
  const ProcessResult result = compare({"mine.exr", "reference.exr"});
  expectSays(result, 3, "mine.exr does not say how noisy it is");
  expectSays(result, 3, "with --replicates 16");
  expectSays(result, 3, "relMSE");
  EXPECT_EQ(result.output.find("They differ"), std::string::npos) << result.output;
  EXPECT_EQ(result.output.find("  differs"), std::string::npos) << result.output;
  const ProcessResult json = compare({"mine.exr", "reference.exr", "--json"});
  EXPECT_EQ(json.exitCode, 3);
  EXPECT_TRUE(nlohmann::json::parse(json.output)["same"].is_null());
  expectSays(compare({"mine.exr", "reference.exr", "--within", "1%"}), 1, "They differ");
}

TEST_F(CompareCommand, PixelsWithoutAValueAreToldOf) {
  Image image = gradientImage(9, 7);
  write("a.exr", image);
  image.rgb[0] = std::numeric_limits<float>::quiet_NaN();
  image.rgb[30] = std::numeric_limits<float>::infinity();
  write("b.exr", image);
  const ProcessResult result = compare({"a.exr", "b.exr", "--within", "50%"});
  expectSays(result, 1, "They differ: there are pixels without a value.");
  expectSays(result, 1, "B has 1 pixel with NaN and 1 infinite pixel: left out of all numbers.");
  image = gradientImage(9, 7);
  image.invalid.assign(63, 0);
  image.invalid[9] = 1;
  write("c.exr", image);
  expectSays(compare({"c.exr", "a.exr"}), 1, "other pixels are marked as invalid");
  expectSays(compare({"c.exr", "c.exr"}), 0, "A has 1 pixel marked as invalid");
}

TEST_F(CompareCommand, DifferencesArePicturesOrNumbers) {
  writeNoisy("a.exr", 1);
  writeNoisy("b.exr", 2);
  expectSays(compare({"a.exr", "b.exr", "--difference", "d.png", "--z-map", "z.png"}), 0,
             "d.png: red where A is larger");
  EXPECT_EQ(readImage(folder_ / "d.png").image.width, 32);
  EXPECT_EQ(readImage(folder_ / "z.png").image.height, 24);
  expectSays(compare({"a.exr", "b.exr", "--difference", "d.png", "--scale", "0.25"}), 0,
             "full colour from 0.25, of");
  for (const char* name : {"d.exr", "d.pfm"}) {
    expectSays(compare({"a.exr", "b.exr", "--difference", name}), 0, "a - b in every pixel");
    const Image a = readImage(folder_ / "a.exr").image, b = readImage(folder_ / "b.exr").image;
    const Image d = readImage(folder_ / name).image;
    for (std::size_t i = 0; i < d.rgb.size(); ++i) EXPECT_EQ(d.rgb[i], a.rgb[i] - b.rgb[i]);
  }
}

TEST_F(CompareCommand, JsonHasTheSameNumbers) {
  writeNoisy("a.exr", 1);
  writeNoisy("c.exr", 3, 1.02f);
  const ProcessResult result = compare({"c.exr", "a.exr", "--json", "--tile", "4"});
  EXPECT_EQ(result.exitCode, 1);
  const nlohmann::json json = nlohmann::json::parse(result.output);
  EXPECT_FALSE(json["same"].get<bool>());
  EXPECT_EQ(json["a"]["replicates"], 16);
  EXPECT_EQ(json["a"]["seed"], "3");
  EXPECT_EQ(json["a"]["sampler"], "pcg");
  EXPECT_EQ(json["whole"].size(), 3u);
  EXPECT_NEAR(json["whole"][0]["ratio"].get<double>(), 1.0, 0.01);
  EXPECT_TRUE(json["furthestTiles"][0]["differs"].get<bool>());
  EXPECT_GT(json["furthestTiles"][0]["z"].get<double>(), 4.0);
  EXPECT_GT(json["mse"].get<double>(), 0.0);
  write("a.pfm", gradientImage(3, 3));
  const ProcessResult plain = compare({"a.pfm", "a.pfm", "--json"});
  EXPECT_TRUE(nlohmann::json::parse(plain.output)["whole"][0]["z"].is_null());
}

TEST_F(CompareCommand, TroubleIsASentenceAndExitCodeTwo) {
  writeNoisy("a.exr", 1);
  write("b.pfm", gradientImage(32, 24));
  write("small.pfm", gradientImage(3, 3));
  writeText(folder_ / "text.exr", "hello");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{}, "A is required"},
      {{"a.exr"}, "B is required"},
      {{"a.exr", "nothing.exr"}, "nothing.exr: there is no such file."},
      {{"a.exr", "."}, "ends in .exr, .hdr, .png or .pfm"},
      {{"a.exr", "text.exr"}, "text.exr: this is no EXR image"},
      {{"b.pfm", "small.pfm"}, "32x24 and 3x3"},
      {{"a.exr", "b.pfm", "--difference", "d.hdr"}, "the name ends in .png or .exr or .pfm."},
      {{"a.exr", "b.pfm", "--difference", "no/d.png"}, "there is no folder no."},
      {{"a.exr", "b.pfm", "--difference", "a.exr"}, "one of the images that are compared"},
      {{"a.exr", "b.pfm", "--difference", "./a.exr"}, "one of the images that are compared"},
      {{"a.exr", "b.pfm", "--difference", "d.png", "--z-map", "./d.png"},
       "--z-map ./d.png: this is also the file of --difference"},
      {{"a.exr", "b.pfm", "--z-map", "z.exr"}, "the name ends in .png."},
      {{"b.pfm", "b.pfm", "--z-map", "z.png"}, "neither image has variances"},
      {{"a.exr", "b.pfm", "--difference", "/proc/d.png"}, "cannot be written"},
      {{"a.exr", "b.pfm", "--scale", "2"}, "--difference"},
      {{"a.exr", "b.pfm", "--within", "much"}, "a fraction such as 1%"},
      {{"a.exr", "b.pfm", "--within", "-1%"}, "a fraction such as 1%"},
      {{"a.exr", "b.pfm", "--within", "1%%"}, "a fraction such as 1%"},
      {{"a.exr", "b.pfm", "--within", "nan"}, "a fraction such as 1%"},
      {{"a.exr", "b.pfm", "--tile", "0"}, "a whole number from 1"},
      {{"a.exr", "b.pfm", "--alpha", "0"},
       "--alpha: found 0, allowed is a number from 1e-12 to 0.5"},
      {{"a.exr", "b.pfm", "--difference", "d.png", "--scale", "0"},
       "--scale: found 0, allowed is a number from 1e-30 to 1e+30"},
      {{"a.exr", "b.pfm", "c.pfm"}, "c.pfm was not expected"},
      {{"a.exr", "b.pfm", "--diff", "d.png"}, "--diff"},
  };
  for (const auto& [arguments, words] : cases) {
    std::string line;
    for (const std::string& a : arguments) line += a + " ";
    SCOPED_TRACE(line);
    const ProcessResult result = compare(arguments);
    expectSays(result, 2, words);
  }
}

}  // namespace
}  // namespace pathmark::test
