// The class of the demo: each submission is what its name says.
#include "sample_class/sample_class.h"
#include "host/build_config.h"
#include "host/coursework_builder.h"
#include "host/worker_process.h"
#include "scene/load_scene.h"
#include "submission/submission.h"
#include "support/made_archive.h"
#include "support/test_coursework_files.h"
#include "variants/variant.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot{build::kProjectFolder};

class SampleClass : public testing::Test {
 protected:
  // Made once, which is enough for looking at it.
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    makeSampleClass(folder_->path() / "class");
    const std::array<fs::path, 1> words{folder_->path() / "class"};
    found_ = submission::findSubmissions(words);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static submission::Collected collected(std::string_view name) {
    for (const submission::Submission& one : found_.submissions)
      if (one.name == name) return submission::collect(one);
    ADD_FAILURE() << name << " is not in the class";
    return {};
  }

  // A folder with the files that are taken of it.
  static fs::path writtenOut(std::string_view name) {
    const fs::path folder = folder_->path() / "written" / name;
    if (!fs::exists(folder)) submission::writeOut(collected(name), folder);
    return folder;
  }

  static CourseworkBuild built(std::string_view name) { return buildCoursework(writtenOut(name)); }

  // What becomes of a pixel inside a sphere that shines and reflects.
  static WorkerFault faultOf(std::string_view name) {
    const CourseworkBuild build = built(name);
    EXPECT_TRUE(build.complete()) << build.failure();
    WorkerProcess::Options options;
    options.program = build.worker;
    options.courseworkFolder = build.folder;
    options.limits.secondsWithoutAnswer = 2.0;
    WorkerProcess worker(options);
    worker.loadScene(loadScene(kRoot / "scenes/furnace.json").flat);
    // Column, row, rays, seed: contract.h.
    constexpr std::array<std::uint32_t, 5> kPixel{0, 0, 4, 1, 2};
    try {
      worker.call(CourseworkFunction::kRenderPixel, {}, kPixel);
    } catch (const WorkerError& error) {
      return error.fault();
    }
    ADD_FAILURE() << name << " did nothing wrong";
    return WorkerFault::kNonsense;
  }

  static std::unique_ptr<TemporaryFolder> folder_;
  static submission::FoundSubmissions found_;
};

std::unique_ptr<TemporaryFolder> SampleClass::folder_;
submission::FoundSubmissions SampleClass::found_;

TEST_F(SampleClass, IsTenSubmissionsOfEveryPacking) {
  EXPECT_TRUE(found_.remarks.empty());
  std::set<std::string_view> made, wanted;
  int archives = 0;
  for (const submission::Submission& one : found_.submissions) {
    made.insert(one.name);
    archives += one.isArchive ? 1 : 0;
  }
  for (const SampleSubmission& sample : sampleClass()) wanted.insert(sample.name);
  EXPECT_EQ(made, wanted);
  EXPECT_EQ(made.size(), 10u);
  EXPECT_EQ(archives, 2);
}

TEST_F(SampleClass, EveryFileOfItIsTaken) {
  for (const SampleSubmission& sample : sampleClass()) {
    const submission::Collected files = collected(sample.name);
    EXPECT_TRUE(files.failure.empty()) << files.failure;
    EXPECT_TRUE(files.remarks.empty()) << files.remarks.front();
    EXPECT_EQ(files.files.size(), parts().size() + (sample.hasScene ? 1u : 0u)) << sample.name;
  }
}

// The solutions, but for the file that the patch names and the parts that are not written.
TEST_F(SampleClass, DiffersFromTheSolutionsWhereItSays) {
  for (const SampleSubmission& sample : sampleClass()) {
    const submission::Collected files = collected(sample.name);
    const int changed =
        sample.patch.empty() ? -1 : readVariant(kRoot / "grader" / sample.patch).part;
    for (const PartContract& part : parts()) {
      const std::string file(part.file);
      if (part.part >= sample.partsWritten) {
        EXPECT_EQ(files.files.at(file), readBytes(kRoot / "student" / file)) << sample.name;
      } else {
        EXPECT_EQ(files.files.at(file) == readBytes(kRoot / "solutions" / file),
                  part.part != changed)
            << sample.name << " " << file;
      }
    }
  }
}

TEST_F(SampleClass, CompilesButForOnePartOfOneSubmission) {
  for (const SampleSubmission& sample : sampleClass()) {
    const CourseworkBuild build = built(sample.name);
    for (const PartBuild& part : build.parts)
      EXPECT_EQ(part.compiled, !(sample.name == "does-not-compile" && part.part.part == 4))
          << sample.name << ": " << part.messages;
    EXPECT_EQ(build.complete(), sample.name != "does-not-compile") << build.failure();
  }
}

TEST_F(SampleClass, OneCrashes) { EXPECT_EQ(faultOf("crashes"), WorkerFault::kCrashed); }

TEST_F(SampleClass, OneNeverEnds) { EXPECT_EQ(faultOf("never-ends"), WorkerFault::kTimeLimit); }

TEST_F(SampleClass, OneForgesWhatTheGraderSays) {
  const CourseworkBuild build = built("cheats");
  std::string printed;
  WorkerProcess::Options options;
  options.program = build.worker;
  options.courseworkFolder = build.folder;
  options.onText = [&](std::string_view text) { printed += text; };
  WorkerProcess(options).stubs();
  EXPECT_NE(printed.find("All checks passed."), std::string::npos) << printed;
}

}  // namespace
}  // namespace pathmark::test
