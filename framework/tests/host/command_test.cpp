// The program's commands, run as programs: what they print, write and return.
#include "film/image_file.h"
#include "host/build_config.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <fstream>

namespace pathmark::test {
namespace {

constexpr const char* kProgram = PATHMARK_PROGRAM;

class Command : public testing::Test {
 protected:
  ProcessResult pathmark(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), kProgram);
    return run(arguments, folder_.path());
  }
  ProcessResult render(std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", "furnace", "--with",
                                       coursework_.folder().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return pathmark(arguments);
  }
  bool wrote(const std::string& name) { return std::filesystem::exists(folder_ / name); }

  TemporaryFolder folder_;
  TestCoursework coursework_;
};

TEST_F(Command, EveryHelpCarriesExamples) {
  for (const char* command : {"render", "compare", "contact-sheet", "mesh", "reference", "demo",
                              "status", "build", "test", "clean"})
    expectSays(pathmark({command, "--help"}), 0, "Examples:");
  expectSays(pathmark({"--help"}), 0, "Examples:");
}

TEST_F(Command, RenderWritesThePictureItNames) {
  expectSays(render({"--size", "20x10", "--rays-per-pixel", "5", "--output", "a.pfm"}), 0,
             "a.pfm: 20x10, 5 rays per pixel");
  const Image image = readPfm(folder_ / "a.pfm");
  EXPECT_EQ(image.width, 20);
  EXPECT_EQ(image.height, 10);
}

TEST_F(Command, RenderNamesThePictureAfterSceneAndCoursework) {
  std::filesystem::create_directory(folder_ / "mine");
  for (const auto& file : std::filesystem::directory_iterator(coursework_.folder()))
    std::filesystem::copy(file, folder_.path() / "mine");
  expectSays(pathmark({"render", "furnace", "--with", "mine", "--size", "8x8"}), 0,
             "furnace_mine.png");
  EXPECT_TRUE(wrote("furnace_mine.png"));
}

TEST_F(Command, RenderIsRepeatableAndSeedsDiffer) {
  render({"--size", "20x10", "--rays-per-pixel", "5", "--threads", "1", "--output", "a.pfm"});
  render({"--size", "20x10", "--rays-per-pixel", "5", "--threads", "7", "--output", "b.pfm"});
  render({"--size", "20x10", "--rays-per-pixel", "5", "--seed", "9", "--output", "c.pfm"});
  const Image a = readPfm(folder_ / "a.pfm");
  EXPECT_EQ(a.rgb, readPfm(folder_ / "b.pfm").rgb);
  EXPECT_NE(a.rgb, readPfm(folder_ / "c.pfm").rgb);
}

TEST_F(Command, NothingIsDrawnOffATerminal) {
  const ProcessResult result = render({"--size", "64x64", "--rays-per-pixel", "500"});
  EXPECT_EQ(result.exitCode, 0) << result.output;
  EXPECT_EQ(result.output.find('\r'), std::string::npos) << result.output;
  EXPECT_EQ(result.output.find('\033'), std::string::npos) << result.output;
}

TEST_F(Command, WrongCommandLinesAreSentencesAndExitCodeTwo) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{}, "required"},
      {{"paint"}, "required"},
      {{"render"}, "SCENE"},
      {{"render", "corner_box"}, "There is no scene corner_box"},
      {{"render", "nothing.json"}, "nothing.json"},
      {{"render", "furnace", "--size", "0x5"},
       "--size 0x5: found a side of 0, but each is from 1 to 16384 pixels."},
      {{"render", "furnace", "--size", "12"}, "640x480"},
      {{"render", "furnace", "--size", "9999999x9999999"}, "--size 9999999x9999999: found a side"},
      {{"export", "furnace", "--format", "mitsuba", "--size", "5x-1"},
       "--size 5x-1: found a side of -1"},
      {{"render", "furnace", "--rays-per-pixel", "0"}, "--rays-per-pixel"},
      {{"render", "furnace", "--rays-per-pixel", "-3"}, "--rays-per-pixel"},
      {{"render", "furnace", "--rays-per-pixel", "1000000000000"}, "--rays-per-pixel"},
      {{"render", "furnace", "--rays-per-pixel", "many"}, "--rays-per-pixel"},
      {{"render", "furnace", "--threads", "0"}, "--threads"},
      {{"render", "furnace", "--max-bounces", "-1"}, "--max-bounces"},
      {{"render", "furnace", "--seed", "x"}, "--seed"},
      {{"render", "furnace", "--sampler", "foo"},
       "--sampler foo: it is one of sobol, stratified, pcg."},
      {{"contact-sheet", "furnace", "--sampler", "PCG"}, "--sampler PCG: it is one of"},
      {{"reference", "furnace", "--sampler", ""}, "--sampler : it is one of"},
      {{"render", "furnace", "--output", "a.jpg"}, ".png or .pfm"},
      {{"render", "furnace", "--frobnicate"}, "--frobnicate was not expected"},
      {{"render", "furnace", "--ray-per-pixel", "4"}, "Did you mean \"--rays-per-pixel\"?"},
      {{"render", "furnace", "--rays-per-pixel", "4.5"}, "a whole number from 1"},
      {{"render", "furnace", "--seed", "-1"}, "a whole number from 0"},
      {{"render", "furnace", "--seed", "99999999999999999999999"}, "a whole number from 0"},
      {{"render", "furnace", "--size", "16384x16384"}, "which is the most"},
      {{"render", "furnace", "--output", "no/such/folder.png"}, "there is no folder no/such"},
      {{"render", "Cornell-Box"}, "Did you mean \"cornell_box\"?"},
      {{"render", "furnace", "--with", "/no/such/folder"}, "there is no folder"},
      {{"build", "--with", "/no/such/folder"}, "there is no folder"},
      {{"reference", "my_scene"}, "no scene in scenes/"},
      {{"reference", "cornell_box", "--rays-per-pixel", "100"}, "96 and 112 can"},
      {{"reference", "cornell_box", "--replicates", "1"}, "a whole number from 2"},
      {{"reference", "--frob"}, "--frob was not expected"},
      {{"status", "--with", "/no/such/folder"}, "there is no folder"},
  };
  for (const auto& [arguments, words] : cases) {
    std::string line;
    for (const std::string& a : arguments) line += a + " ";
    SCOPED_TRACE(line);
    expectSays(pathmark(arguments), 2, words);
  }
}

TEST_F(Command, AFileThatCannotBeWrittenIsExitCodeThree) {
  // /proc is a folder in which nobody can make files.
  expectSays(render({"--size", "8x8", "--output", "/proc/a.png"}), 3, "cannot be written");
}

// What a system may allow less of than a render takes.
TEST_F(Command, LimitsOfTheSystemAreSentences) {
  const auto renderWithin = [&](const std::string& limit, const std::string& size) {
    return run({"sh", "-c",
                "ulimit " + limit + "\n" + kProgram + " render furnace --with '" +
                    coursework_.folder().string() + "' --rays-per-pixel 1 --size " + size},
               folder_.path());
  };
  expectSays(render({"--size", "8x8", "--output", "a.pfm"}), 0, "a.pfm");  // it is compiled now
  expectSays(renderWithin("-n 40", "8x8"), 1, "The worker could not start");
  expectSays(renderWithin("-f 4", "8x8"), 3, "sharing memory with the worker (the limit on files");
  // Sanitizers take far more address space.
  if (!build::kSanitized)
    expectSays(renderWithin("-v 3000000", "16384x4096"), 3, "This takes more memory than there is");
}

TEST_F(Command, NamesThatNoFileCanHaveAreSentences) {
  const std::string longName(300, 'x');
  expectSays(pathmark({"render", longName}), 2, longName + ": File name too long.");
  std::filesystem::create_symlink("loop.json", folder_ / "loop.json");
  expectSays(pathmark({"render", "loop.json"}), 2, "loop.json: Too many levels of symbolic links.");
}

TEST_F(Command, WarmUpTellsOfSpheresAndListsItsOwnStubsOnly) {
  const ProcessResult result = render({"--size", "8x8", "--warm-up"});
  expectSays(result, 0, "2 spheres are left out, and with them all light");
}

TEST_F(Command, AssertionsHoldInCoursework) {
  coursework_.write("part5_path.cpp",
                    "#include <pathmark/coursework.h>\n#include <cassert>\nnamespace pathmark {\n"
                    "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
                    "  assert(maxBounces() < 0); return Colour(0.0f);\n}\n}\n");
  expectSays(render({"--size", "8x8"}), 1, "SIGABRT");
}

TEST_F(Command, AFunctionOfAnotherNameIsASentenceAndStatusStillHasItsTable) {
  coursework_.setFile("part6_roulette.cpp",
                      "Roulette russianRoulette(const Colour&, int, float) { return {}; }");
  expectSays(render({}), 1, "defines no LitScene::RussianRoulette with the parameters");
  const ProcessResult status = pathmark({"status", "--with", coursework_.folder().string()});
  expectSays(status, 1, "7 of 7 written");
  expectSays(status, 1, "defines no LitScene::RussianRoulette");
}

TEST_F(Command, ACrashIsASentenceAndExitCodeOneAndWritesNothing) {
  coursework_.setTracePath(
      "(void)ray; (void)sampler;\n*(volatile int*)16 = 1;\n"
      "return Colour(0.0f);");
  expectSays(render({"--output", "a.png"}), 1, "part5_path.cpp:5, in LitScene::tracePath");
  EXPECT_FALSE(wrote("a.png"));
}

TEST_F(Command, AnEndlessLoopIsStopped) {
  coursework_.setTracePath(
      "(void)sampler;\nvolatile float x = ray.direction.x;\n"
      "while (x < 2.0f) {}\nreturn Colour(0.0f);");
  expectSays(render({"--stop-after", "1"}), 1, "no answer for 1 s");
}

TEST_F(Command, InvalidValuesAreToldAndTheRestOfThePictureIsKept) {
  coursework_.setTracePath(
      "(void)sampler;\n"
      "return Colour(std::sqrt(ray.direction.x));");
  expectSays(render({"--size", "16x16", "--output", "a.pfm"}), 1, "NaN");
  EXPECT_TRUE(wrote("a.pfm"));
  for (const float value : readPfm(folder_ / "a.pfm").rgb) EXPECT_TRUE(value >= 0.0f);
}

TEST_F(Command, CourseworkThatDoesNotCompileIsExitCodeOne) {
  coursework_.setTracePath("return colour;");
  expectSays(render({}), 1, "part5_path.cpp:4:8: error");
}

TEST_F(Command, WhatCourseworkPrintsIsShown) {
  coursework_.write("part5_path.cpp",
                    "#include <pathmark/coursework.h>\n#include <iostream>\nnamespace pathmark {\n"
                    "Colour LitScene::tracePath(const Ray&, Sampler&) const {\n"
                    "  std::cout << \"hello from a path\"; return Colour(0.0f);\n}\n}\n");
  expectSays(render({"--size", "2x2", "--rays-per-pixel", "1"}), 0, "hello from a path");
}

TEST_F(Command, StatusListsWhatIsMissingAndWhatComesNext) {
  coursework_.setFile("part6_roulette.cpp",
                      "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                      "  PATHMARK_UNIMPLEMENTED(\"part6_roulette.cpp\", "
                      "\"LitScene::RussianRoulette\");\n  return {true, 1.0f};\n}");
  const ProcessResult result = pathmark({"status", "--with", coursework_.folder().string()});
  expectSays(result, 0, "0 of 1 written");
  expectSays(result, 0, "7 of 7 written");
  expectSays(result, 0, "Next: write LitScene::RussianRoulette");
}

TEST_F(Command, StatusPutsMendingBeforeWriting) {
  coursework_.setFile("part0_warmup.cpp", "");
  coursework_.setFile("part1_stratified.cpp",
                      "Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float,\n"
                      "                                      float) const {\n"
                      "  PATHMARK_UNIMPLEMENTED(\"part1_stratified.cpp\", "
                      "\"SimpleCamera::StratifiedRandomRay\");\n  return {};\n}");
  coursework_.setTracePath("return colour;");
  const ProcessResult result = pathmark({"status", "--with", coursework_.folder().string()});
  expectSays(result, 1, "1 of 2 written");
  expectSays(result, 1, "Next: mend ");
  EXPECT_EQ(result.output.find("Next: write"), std::string::npos);
}

TEST_F(Command, StatusSaysThatTheMarkerOfAWrittenFunctionIsToBeTakenAway) {
  coursework_.setFile("part6_roulette.cpp",
                      "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                      "  PATHMARK_UNIMPLEMENTED(\"part6_roulette.cpp\", "
                      "\"LitScene::RussianRoulette\");\n  return {true, 1.0f};\n}");
  const ProcessResult result = pathmark({"status", "--with", coursework_.folder().string()});
  expectSays(result, 0, "Next: write LitScene::RussianRoulette");
  expectSays(result, 0, "Its line PATHMARK_UNIMPLEMENTED(...) is still there: take it away");
}

TEST_F(Command, StatusOfABrokenFileStillTellsOfTheOthers) {
  coursework_.setTracePath("return colour;");
  const ProcessResult result = pathmark({"status", "--with", coursework_.folder().string()});
  expectSays(result, 1, "does not compile");
  expectSays(result, 1, "7 of 7 written");
}

TEST_F(Command, StatusSaysOfAFileThatIsMissingThatItIs) {
  std::filesystem::remove(coursework_.folder() / "part4_phong.cpp");
  const ProcessResult result = pathmark({"status", "--with", coursework_.folder().string()});
  expectSays(result, 1, "Next: put the file back: ");
  expectSays(result, 1, "part4_phong.cpp is missing; a coursework folder");
  EXPECT_EQ(result.output.find("compile"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace pathmark::test
