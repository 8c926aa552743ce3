// Renders that are interrupted, killed and gone on with, as a user would.
//
// The coursework of these tests takes a millisecond for each pass of a pixel until a file named
// "fast" is there: a render is in work for as long as a test needs, and then done at once.
#include "film/image_file.h"
#include "support/background_program.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <set>

#include <unistd.h>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

class LongRender : public testing::Test {
 protected:
  LongRender() {
    coursework_.setFile("part5_path.cpp", "");
    writePath("std::chrono::milliseconds(1)");
    setFast(true);
    reference_ = picture("reference.pfm", {});
    setFast(false);
  }

  // `pause`: of a pass's first ray, while the render is slow.
  void writePath(const std::string& pause) {
    coursework_.write(
        "part5_path.cpp",
        "#include <pathmark/coursework.h>\n#include <unistd.h>\n#include <chrono>\n#include "
        "<cmath>\n"
        "#include <fstream>\n#include <thread>\nnamespace pathmark {\n"
        "Colour LitScene::tracePath(const Ray&, Sampler& sampler) const {\n"
        "  thread_local int ray = 0;\n"
        "  if (ray++ % 64 == 0 && access(\"" +
            (gate_ / "fast").string() +
            "\", F_OK) != 0) {\n"
            "    std::ofstream(\"" +
            (gate_ / "working").string() +
            "\");\n"
            "    std::this_thread::sleep_for(" +
            pause +
            ");\n  }\n"
            "  const vec2 u = sampler.next2D();\n"
            "  return u.x < 1e-4f ? Colour(NAN) : Colour(u.x, u.y, u.x * u.y);\n}\n}\n");
  }
  void setFast(bool fast) const {
    if (fast)
      std::ofstream(gate_ / "fast");
    else
      fs::remove(gate_ / "fast");
  }

  std::vector<std::string> command(const std::string& output,
                                   const std::vector<std::string>& more) const {
    std::vector<std::string> words{PATHMARK_PROGRAM,
                                   "render",
                                   "furnace",
                                   "--with",
                                   coursework_.folder().string(),
                                   "--size",
                                   "40x48",
                                   "--rays-per-pixel",
                                   "640",
                                   "--output",
                                   output};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  ProcessResult render(const std::string& output, const std::vector<std::string>& more = {}) const {
    return run(command(output, more), folder_.path());
  }
  std::vector<float> picture(const std::string& output,
                             const std::vector<std::string>& more) const {
    const ProcessResult result = render(output, more);
    EXPECT_EQ(result.exitCode, 1) << result.output;  // the NaN
    EXPECT_NE(result.output.find(kInvalid), std::string::npos) << result.output;
    return readPfm(folder_ / output).rgb;
  }
  BackgroundProgram start(std::vector<std::string> more,
                          const std::string& output = "a.pfm") const {
    more.insert(more.end(), {"--checkpoint-every", "0.01", "--threads", "2"});
    return BackgroundProgram(command(output, more), folder_.path(), gate_ / "log");
  }
  std::string log() const { return textOf(gate_ / "log"); }

  // Such as "64 of 640 rays per pixel", of the checkpoint that an interrupt has left.
  std::string raysHeld() const {
    const std::string text = log(), start = "To go on from a.pfm.checkpoint, which has ",
                      unit = " rays per pixel";
    const std::size_t at = text.find(start);
    if (at == text.npos) return {};
    const std::size_t first = at + start.size();
    return text.substr(first, text.find(unit, first) + unit.size() - first);
  }

  // Waits until so many checkpoints have been written. Each is a new file.
  bool awaitCheckpoints(int count, const std::string& name = "a.pfm.checkpoint") const {
    fs::file_time_type last{};
    for (int k = 0; k < count; ++k) {
      const bool seen = waitFor([&] {
        std::error_code error;
        const auto time = fs::last_write_time(folder_ / name, error);
        if (error || time == last) return false;
        last = time;
        return true;
      });
      if (!seen) return false;
    }
    return true;
  }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      names.insert(entry.path().filename().string());
    return names;
  }
  static void expectSays(const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
  }

  // Of the uninterrupted render: there is one in about every 160th pass.
  static constexpr const char* kInvalid = " NaN values, first in pixel column ";

  TemporaryFolder folder_, gate_;
  TestCoursework coursework_;
  std::vector<float> reference_;
};

TEST_F(LongRender, InterruptedAtAnyMomentItGoesOnToTheSameBits) {
  std::string resume = "--seed=0", held;
  for (const int signal : {SIGINT, SIGTERM, SIGINT}) {
    BackgroundProgram program = start({resume});
    ASSERT_TRUE(awaitCheckpoints(resume == "--resume" ? 2 : 1)) << log();
    program.signal(signal);
    const int code = program.wait();
    EXPECT_TRUE(code == 130 || code == 1) << log();  // 1: with a NaN so far
    expectSays(log(), "Interrupted: the picture has ");
    if (resume == "--resume") expectSays(log(), "Going on from a.pfm.checkpoint, with " + held);
    held = raysHeld();
    ASSERT_NE(held, "") << log();
    EXPECT_EQ(files(), (std::set<std::string>{"a.pfm", "a.pfm.checkpoint", "reference.pfm"}));
    EXPECT_NE(readPfm(folder_ / "a.pfm").rgb, reference_);
    resume = "--resume";
  }
  setFast(true);
  EXPECT_EQ(picture("a.pfm", {"--resume", "--threads", "7"}), reference_);
  EXPECT_EQ(files(), (std::set<std::string>{"a.pfm", "reference.pfm"}));
}

TEST_F(LongRender, ResumedCountsOfInvalidValuesAddUp) {
  setFast(true);
  const std::string whole = render("whole.pfm").output;
  setFast(false);
  {
    BackgroundProgram program = start({});
    ASSERT_TRUE(awaitCheckpoints(2)) << log();
    program.signal(SIGINT);
    program.wait();
  }
  setFast(true);
  const std::string resumed = render("a.pfm", {"--resume"}).output;
  const auto sentence = [](const std::string& text) {
    const auto from = text.find("renderPixel returned ");
    return from == std::string::npos ? "" : text.substr(from, text.find('\n', from) - from);
  };
  EXPECT_EQ(sentence(resumed), sentence(whole));
  EXPECT_NE(sentence(resumed), "");
}

TEST_F(LongRender, KilledItGoesOnFromItsLastCheckpoint) {
  {
    BackgroundProgram program = start({});
    ASSERT_TRUE(awaitCheckpoints(2)) << log();
    program.signal(SIGKILL);
    EXPECT_EQ(program.wait(), 128 + SIGKILL);
  }
  EXPECT_EQ(files(), (std::set<std::string>{"a.pfm.checkpoint", "reference.pfm"}));
  setFast(true);
  EXPECT_EQ(picture("a.pfm", {"--resume"}), reference_);
}

TEST_F(LongRender, ReplicatesGoOnToTheSameBits) {
  setFast(true);
  const std::vector<float> whole = picture("whole.pfm", {"--replicates", "10"});
  setFast(false);
  {
    BackgroundProgram program = start({"--replicates", "10"});
    // The checkpoint grows when a replicate is complete.
    ASSERT_TRUE(waitFor([&] {
      std::error_code error;
      const auto size = fs::file_size(folder_ / "a.pfm.checkpoint", error);
      return !error && size > std::uintmax_t{40} * 48 * 100;
    })) << log();
    program.signal(SIGINT);
    program.wait();
  }
  setFast(true);
  EXPECT_EQ(picture("a.pfm", {"--resume", "--replicates", "10"}), whole);
}

TEST_F(LongRender, ASecondInterruptEndsItAtOnceAndLeavesNothingHalfWritten) {
  writePath("std::chrono::hours(1)");
  BackgroundProgram program = start({"--stop-after", "3600"});
  fs::remove(gate_ / "working");
  ASSERT_TRUE(waitFor([&] { return fs::exists(gate_ / "working"); }));
  // A pass that takes an hour is waited for, but not by somebody who asks again.
  ASSERT_TRUE(waitFor([&] {
    program.signal(SIGINT);
    usleep(150000);
    return program.ended();
  }));
  EXPECT_EQ(program.wait(), 128 + SIGINT);
  EXPECT_EQ(files(), (std::set<std::string>{"reference.pfm"}));
}

TEST_F(LongRender, WhatDiffersIsSaidAndNothingIsChanged) {
  {
    BackgroundProgram program = start({});
    ASSERT_TRUE(awaitCheckpoints(1)) << log();
    program.signal(SIGINT);
    program.wait();
  }
  setFast(true);
  const std::string before = textOf(folder_ / "a.pfm.checkpoint"),
                    image = textOf(folder_ / "a.pfm");
  const std::vector<std::array<std::string, 3>> cases{
      {"--seed", "4", "its seed is 0, not 4"},
      {"--sampler", "pcg", "its sampler is sobol, not pcg"},
      {"--size", "48x40", "its size is 40x48, not 48x40"},
      {"--max-bounces", "3", "bounces, not 3"},
      {"--warm-up", "", "it was made by tracePath, not with --warm-up"},
      {"--rays-per-pixel", "8", "its passes have 64 rays per pixel, not 8"},
      {"--replicates", "5", "its replicates are 1 of 640 rays per pixel, not 5 of 128"},
  };
  for (const auto& [option, value, words] : cases) {
    SCOPED_TRACE(words);
    std::vector<std::string> arguments = command("a.pfm", {"--resume"});
    // An option may be given once only.
    const auto given = std::find(arguments.begin(), arguments.end(), option);
    if (given != arguments.end()) arguments.erase(given, given + 2);
    arguments.push_back(option);
    if (!value.empty()) arguments.push_back(value);
    const ProcessResult result = run(arguments, folder_.path());
    EXPECT_EQ(result.exitCode, 2) << result.output;
    expectSays(result.output, words);
    expectSays(result.output, "without --resume the render starts afresh");
  }
  coursework_.setFile("part6_roulette.cpp",
                      "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                      "  return {true, 2.0f};\n}");
  const ProcessResult other = render("a.pfm", {"--resume"});
  EXPECT_EQ(other.exitCode, 2) << other.output;
  expectSays(other.output, "with other coursework");
  EXPECT_EQ(textOf(folder_ / "a.pfm.checkpoint"), before);
  EXPECT_EQ(textOf(folder_ / "a.pfm"), image);
}

TEST_F(LongRender, AnOlderCheckpointIsNeverLost) {
  {
    BackgroundProgram program = start({});
    ASSERT_TRUE(awaitCheckpoints(2)) << log();
    program.signal(SIGINT);
    program.wait();
  }
  const std::string older = textOf(folder_ / "a.pfm.checkpoint");
  {
    // With another seed it is another picture's.
    BackgroundProgram program = start({"--seed", "4"});
    ASSERT_TRUE(waitFor([&] { return fs::exists(folder_ / "a.pfm.checkpoint.old"); })) << log();
    program.signal(SIGINT);
    program.wait();
    expectSays(log(), "is not of this render: its seed is 0, not 4");
    expectSays(log(), "is now a.pfm.checkpoint.old");
  }
  EXPECT_EQ(textOf(folder_ / "a.pfm.checkpoint.old"), older);
  setFast(true);
  fs::rename(folder_ / "a.pfm.checkpoint.old", folder_ / "a.pfm.checkpoint");
  EXPECT_EQ(picture("a.pfm", {"--resume"}), reference_);
}

TEST_F(LongRender, APictureThatWasForgottenToResumeTakesTheOlderCheckpointAway) {
  {
    BackgroundProgram program = start({});
    ASSERT_TRUE(awaitCheckpoints(1)) << log();
    program.signal(SIGINT);
    program.wait();
  }
  setFast(true);
  const ProcessResult result = render("a.pfm");
  expectSays(result.output, "--resume would go on from there");
  EXPECT_EQ(readPfm(folder_ / "a.pfm").rgb, reference_);
  EXPECT_EQ(files(), (std::set<std::string>{"a.pfm", "reference.pfm"}));
}

TEST_F(LongRender, AFinishedPictureCanBeRefined) {
  setFast(true);
  std::vector<std::string> first = command("a.pfm", {"--keep-checkpoint"});
  *std::find(first.begin(), first.end(), "640") = "192";
  expectSays(run(first, folder_.path()).output, "To refine the picture: --resume");
  EXPECT_EQ(picture("a.pfm", {"--resume"}), reference_);
  EXPECT_EQ(files(), (std::set<std::string>{"a.pfm", "reference.pfm"}));
}

TEST_F(LongRender, WithoutACheckpointItStartsFromTheBeginningAndSaysSo) {
  setFast(true);
  expectSays(render("a.pfm", {"--resume"}).output,
             "There is no a.pfm.checkpoint: the render starts from the beginning.");
  EXPECT_EQ(readPfm(folder_ / "a.pfm").rgb, reference_);
}

TEST_F(LongRender, ADamagedCheckpointIsRefusedAndKept) {
  setFast(true);
  for (const char* content : {"", "PMcheck\n", "This is a text that somebody has written."}) {
    std::ofstream(folder_ / "a.pfm.checkpoint", std::ios::binary) << content;
    const ProcessResult result = render("a.pfm", {"--resume"});
    EXPECT_EQ(result.exitCode, 2) << result.output;
    expectSays(result.output, "--resume cannot go on from a.pfm.checkpoint: it is ");
    EXPECT_EQ(textOf(folder_ / "a.pfm.checkpoint"), content);
  }
}

TEST_F(LongRender, APictureThatCannotBeWrittenLeavesItsWorkInACheckpoint) {
  {
    BackgroundProgram program = start({});
    ASSERT_TRUE(awaitCheckpoints(1)) << log();
    fs::create_directory(folder_ / "a.pfm");
    setFast(true);
    EXPECT_EQ(program.wait(), 3) << log();
    expectSays(log(), "The work is in a.pfm.checkpoint");
    expectSays(log(), "a.pfm cannot be written: Is a directory.");
  }
  fs::remove(folder_ / "a.pfm");
  EXPECT_EQ(picture("a.pfm", {"--resume"}), reference_);
}

TEST_F(LongRender, AFolderThatIsGoneLeavesTheWorkWhereTemporaryFilesAre) {
  fs::create_directory(folder_ / "sub");
  fs::create_directory(folder_ / "temporary");
  std::vector<std::string> words = command("sub/a.pfm", {"--checkpoint-every", "0.01"});
  words.insert(words.begin(), {"env", "TMPDIR=" + (folder_ / "temporary").string()});
  {
    BackgroundProgram program(words, folder_.path(), gate_ / "log");
    ASSERT_TRUE(awaitCheckpoints(1, "sub/a.pfm.checkpoint")) << log();
    // A checkpoint that is being written may bring a file into the folder meanwhile.
    ASSERT_TRUE(waitFor([&] {
      std::error_code error;
      fs::remove_all(folder_ / "sub", error);
      return !error;
    }));
    ASSERT_TRUE(waitFor([&] {
      return log().find("The render goes on without a checkpoint.") != std::string::npos;
    })) << log();
    setFast(true);
    EXPECT_EQ(program.wait(), 3) << log();
    expectSays(log(), "The work is in " + (folder_ / "temporary/a.pfm.checkpoint").string());
  }
  fs::rename(folder_ / "temporary/a.pfm.checkpoint", folder_ / "b.pfm.checkpoint");
  EXPECT_EQ(picture("b.pfm", {"--resume"}), reference_);
}

TEST_F(LongRender, ACheckpointThatCannotBeWrittenIsAWarning) {
  BackgroundProgram program = start({});
  ASSERT_TRUE(awaitCheckpoints(1)) << log();
  // The next checkpoint may come in between.
  ASSERT_TRUE(waitFor([&] {
    std::error_code error;
    fs::remove_all(folder_ / "a.pfm.checkpoint", error);
    fs::create_directories(folder_ / "a.pfm.checkpoint/something", error);
    return !error;
  }));
  ASSERT_TRUE(waitFor([&] {
    return log().find("Is a directory. The render goes on without a checkpoint.") !=
           std::string::npos;
  })) << log();
  setFast(true);
  program.wait();
  EXPECT_EQ(readPfm(folder_ / "a.pfm").rgb, reference_);
}

TEST_F(LongRender, OutputsThatCannotBeWrittenAreRefusedBeforeTheWork) {
  coursework_.setTracePath("this does not compile");
  const auto says = [&](const std::string& output, int code, const std::string& words) {
    const ProcessResult result = render(output);
    EXPECT_EQ(result.exitCode, code) << result.output;
    expectSays(result.output, words);
    EXPECT_EQ(result.output.find("does not compile"), std::string::npos) << result.output;
  };
  fs::create_directory(folder_ / "folder.pfm");
  fs::create_directory(folder_ / "locked");
  fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  says("/proc/a.pfm", 3, "/proc/a.pfm cannot be written: ");
  says("no/a.pfm", 2, "there is no folder no");
  says("folder.pfm", 2, "this is a folder");
  const std::string longest(243, 'x');
  says(longest + ".pfm", 2, longest + ".pfm.checkpoint: the picture's checkpoint cannot be there");
  says(std::string(300, 'x') + ".pfm", 2, "this cannot be used (File name too long).");
  fs::create_symlink("loop.pfm", folder_ / "loop.pfm");
  says("loop.pfm", 2, "--output loop.pfm: this cannot be used (Too many levels");
  fs::remove(folder_ / "loop.pfm");
  if (geteuid() != 0) says("locked/a.pfm", 3, "locked/a.pfm cannot be written: Permission denied");
  EXPECT_EQ(files(), (std::set<std::string>{"folder.pfm", "locked", "reference.pfm"}));
}

TEST_F(LongRender, ReplicatesAreEqualAndSaySo) {
  setFast(true);
  const ProcessResult unequal = render("a.pfm", {"--replicates", "3"});
  EXPECT_EQ(unequal.exitCode, 2);
  expectSays(unequal.output, "639 and 642 can");
  expectSays(render("a.pfm", {"--replicates", "1"}).output, "from 2 to 1024");
  expectSays(render("a.pfm", {"--replicates", "2"}).output,
             "a.pfm will not have the variance between the replicates");
}

}  // namespace
}  // namespace pathmark::test
