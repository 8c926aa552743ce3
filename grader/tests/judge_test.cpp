// From a submission's files to its record.
#include "grading/judge.h"
#include "checks/runner.h"
#include "grading/record_results.h"
#include "host/build_config.h"
#include "host/session.h"
#include "record/record_json.h"
#include "support/test_coursework_files.h"
#include "variants/variant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace pathmark::grading {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kSeed = 5;

const OnProgress kGoOn = [](double) { return true; };

JudgeOptions onlyPart(int part) {
  JudgeOptions options;
  options.seed = kSeed;
  options.parts = {part};
  options.whole = false;
  return options;
}

// What differs from run to run without meaning anything.
std::string withoutTimes(record::SubmissionRecord record) {
  record.seconds = 0.0;
  const auto clearPictures = [](std::vector<record::PictureRecord>& pictures) {
    for (record::PictureRecord& picture : pictures)
      picture.cpuSeconds = picture.cpuSecondsOfSolutions = 0.0;
  };
  clearPictures(record.pictures);
  for (record::PartRecord& part : record.parts) clearPictures(part.pictures);
  const auto forget = [](std::vector<record::CheckRecord>& checks) {
    for (record::CheckRecord& check : checks) check.seconds = 0.0;
  };
  for (record::PartRecord& part : record.parts)
    for (record::FunctionRecord& function : part.functions) forget(function.checks);
  forget(record.images);
  return toJson(record);
}

class JudgeTest : public testing::Test {
 protected:
  // The solutions, with one file in other words.
  fs::path submission(const std::string& file = {}, const std::string& code = {}) {
    const fs::path place = folder_ / "coursework";
    fs::remove_all(place);
    fs::create_directories(place);
    for (const PartContract& part : parts())
      fs::copy_file(courseworkFolder("solutions") / part.file, place / part.file);
    if (!file.empty()) std::ofstream(place / file) << code;
    return place;
  }

  fs::path variant(const std::string& name) {
    const fs::path place = folder_ / "coursework";
    fs::remove_all(place);
    for (const Variant& v : allVariants())
      if (v.name == name) applyVariant(v, place);
    return place;
  }

  test::TemporaryFolder folder_;
};

}  // namespace

TEST_F(JudgeTest, WhatIsRightIsOkAndAsEfficientAsTheSolutions) {
  Judge judge(onlyPart(3), nullptr);
  const Judged judged = judge.judge(submission(), 2, kGoOn);
  ASSERT_EQ(judged.record.parts.size(), 1u);
  const record::PartRecord& part = judged.record.parts[0];
  EXPECT_EQ(part.verdict, record::Verdict::kOk);
  ASSERT_EQ(part.functions.size(), 3u);
  ASSERT_EQ(part.pictures.size(), 1u);
  const record::PictureRecord& picture = part.pictures[0];
  EXPECT_EQ(picture.failure, "");
  // Differing at a rate of 1 % each if only noise were at work; the seed is fixed.
  EXPECT_EQ(picture.bias.low, 0.0);
  EXPECT_LT(picture.bias.high, 0.035);
  EXPECT_LT(picture.efficiency->low, 1.0);
  EXPECT_GT(picture.efficiency->high, 1.0);
  for (const std::string& file : {picture.yours, picture.reference, picture.difference})
    EXPECT_EQ(judged.files.at(file).substr(1, 3), "PNG");
  EXPECT_FALSE(judged.record.outOfTime);
  ASSERT_EQ(judged.record.samples.size(), 1u);
  EXPECT_EQ(judged.record.samples[0].histograms[0].yours,
            judged.record.samples[0].histograms[0].expected);
}

TEST_F(JudgeTest, AMistakeHasItsConsequence) {
  Judge judge(onlyPart(3), nullptr);
  const Judged judged = judge.judge(variant("part3_cosine_in_brdf"), 2, kGoOn);
  const record::PartRecord& part = judged.record.parts.at(0);
  EXPECT_EQ(part.verdict, record::Verdict::kWrong);
  EXPECT_GT(part.pictures.at(0).bias.low, 0.05);
}

// Intervals of 99 %, and a fixed seed.
TEST(MistakePictures, AreLikeThoseOfASubmissionWithTheMistake) {
  const CourseworkBuild solutions = buildCoursework(courseworkFolder("solutions"));
  const marking::MarkingScene scene = marking::scenesOfPart(3, kSeed).at(0);
  MistakePictures one(solutions, kSeed), other(solutions, kSeed + 1);
  const std::optional<Image>& cosine = one.of("part3_cosine_in_brdf", scene, 2);
  ASSERT_TRUE(cosine);
  EXPECT_EQ(&cosine, &one.of("part3_cosine_in_brdf", scene, 2)) << "made once";
  EXPECT_EQ(marking::tileBias(*other.of("part3_cosine_in_brdf", scene, 2), *cosine).low, 0.0);
  EXPECT_GT(marking::tileBias(*other.of("part3_density_uniform", scene, 2), *cosine).low, 0.05);
  EXPECT_FALSE(one.of("part3_no_such_mistake", scene, 2));
}

TEST_F(JudgeTest, ThreadsChangeNothing) {
  Judge judge(onlyPart(6), nullptr);
  const fs::path place = submission();
  const Judged one = judge.judge(place, 1, kGoOn);
  Judge again(onlyPart(6), nullptr);
  const Judged three = again.judge(place, 3, kGoOn);
  EXPECT_EQ(withoutTimes(one.record), withoutTimes(three.record));
  EXPECT_EQ(one.files, three.files);
}

TEST_F(JudgeTest, AFileThatDoesNotCompileCostsOnlyItsPart) {
  JudgeOptions options = onlyPart(3);
  options.parts = {3, 6};
  Judge judge(options, nullptr);
  const Judged judged =
      judge.judge(submission("part3_lambertian.cpp",
                             "int x = nonsense;\n#include <pathmark/coursework.h>\n"
                             "pathmark::Ray ray(1, 2, 3, 4);\n"),
                  2, kGoOn);
  const record::PartRecord& part = judged.record.parts.at(0);
  EXPECT_EQ(part.verdict, record::Verdict::kDoesNotCompile);
  EXPECT_NE(part.message.find("part3_lambertian.cpp:1:9"), std::string::npos) << part.message;
  EXPECT_NE(part.message.find("framework/include/pathmark/"), std::string::npos) << part.message;
  for (const std::string& path : {folder_.path().string(), std::string(build::kProjectFolder)})
    EXPECT_EQ(part.message.find(path + "/"), std::string::npos) << part.message;
  EXPECT_EQ(judged.record.parts.at(1).verdict, record::Verdict::kOk);
}

// As where a constant of the file is made by a loop that never ends.
TEST(RecordParts, WhatIsStoppedWhileItStartsHasCompiled) {
  using record::Verdict;
  CourseworkBuild build;
  for (const PartContract& part : parts()) {
    build.parts.push_back({});
    build.parts.back().part = part;
    build.parts.back().compiled = true;
  }
  const auto verdictOf = [&](std::optional<WorkerFault> fault, const std::string& failure) {
    checks::CourseworkResults results;
    results.parts.push_back({build.parts.at(placeOfPart(6)).part, failure, fault, {}});
    const record::PartRecord part = recordParts(results, build, {6}).at(0);
    EXPECT_EQ(part.message, failure);
    return part.verdict;
  };
  const std::string failure = "cannot be started: it was stopped.";
  EXPECT_EQ(verdictOf(WorkerFault::kTimeLimit, failure), Verdict::kTimeLimit);
  EXPECT_EQ(verdictOf(WorkerFault::kForbiddenCall, failure), Verdict::kForbiddenCall);
  EXPECT_EQ(verdictOf(WorkerFault::kMemoryLimit, failure), Verdict::kMemoryLimit);
  EXPECT_EQ(verdictOf(WorkerFault::kCrashed, failure), Verdict::kCrashed);
  EXPECT_EQ(verdictOf(std::nullopt, "does not link: it is twice there."), Verdict::kDoesNotCompile);
}

TEST_F(JudgeTest, AMissingFileIsNotWritten) {
  Judge judge(onlyPart(6), nullptr);
  const fs::path place = submission();
  fs::remove(place / "part6_roulette.cpp");
  const Judged judged = judge.judge(place, 2, kGoOn);
  EXPECT_EQ(judged.record.parts.at(0).verdict, record::Verdict::kNotWritten);
}

TEST_F(JudgeTest, ACrashIsToldWithItsFunctionAndLine) {
  Judge judge(onlyPart(6), nullptr);
  const Judged judged = judge.judge(
      submission("part6_roulette.cpp",
                 "#include <pathmark/coursework.h>\n"
                 "namespace pathmark {\n"
                 "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                 "  volatile int* nowhere = nullptr;\n"
                 "  return {*nowhere == 0, 1.0f};\n"
                 "}\n"
                 "}\n"),
      2, kGoOn);
  const record::PartRecord& part = judged.record.parts.at(0);
  EXPECT_EQ(part.verdict, record::Verdict::kCrashed);
  const auto broken = std::find_if(
      part.functions.at(0).checks.begin(), part.functions.at(0).checks.end(),
      [](const record::CheckRecord& c) { return c.verdict == record::Verdict::kCrashed; });
  ASSERT_NE(broken, part.functions.at(0).checks.end());
  EXPECT_EQ(broken->got.find("part6_roulette.cpp:5, in LitScene::RussianRoulette"), 0u)
      << broken->got;
  EXPECT_NE(part.pictures.at(0).failure, "");
}

// Beside them in the worker stand solutions that it could print.
TEST_F(JudgeTest, KeepsNothingThatIsPrintedWhilePicturesAreMade) {
  const fs::path place = submission();
  std::ofstream(place / "part6_roulette.cpp", std::ios::app)
      << "#include <cstdio>\n"
         "static const int said = (std::puts(\"started \" __FILE__), std::fflush(stdout));\n";
  const auto lines = [](const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
  };
  checks::Selection selection;
  selection.parts = {6};
  selection.images = selection.scenes = false;
  checks::RunOptions options;
  options.seed = kSeed;
  std::string inChecks;
  options.onText = [&](std::string_view text) { inChecks += text; };
  checks::runChecks(buildCoursework(place, Incomplete::kCompileOnly), selection, options, {});
  ASSERT_GT(lines(inChecks), 0);

  Judge judge(onlyPart(6), nullptr);
  const Judged judged = judge.judge(place, 2, kGoOn);
  EXPECT_FALSE(judged.record.parts.at(0).pictures.empty());
  EXPECT_EQ(lines(judged.record.printed), lines(inChecks)) << judged.record.printed;
  EXPECT_EQ(judged.record.printed.find("started part6_roulette.cpp\n"), 0u)
      << judged.record.printed;
  EXPECT_EQ(judged.record.printed.find(place.string()), std::string::npos) << judged.record.printed;
}

TEST_F(JudgeTest, KeepsNothingThatIsThrownWhilePicturesAreMade) {
  Judge judge(onlyPart(6), nullptr);
  const Judged judged = judge.judge(
      submission("part6_roulette.cpp",
                 "#include <pathmark/coursework.h>\n"
                 "#include <stdexcept>\n"
                 "namespace pathmark {\n"
                 "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                 "  throw std::runtime_error(\"words\");\n"
                 "}\n"
                 "}\n"),
      2, kGoOn);
  const std::string failure = judged.record.parts.at(0).pictures.at(0).failure;
  EXPECT_NE(failure.find("an exception that nobody caught."), std::string::npos) << failure;
  EXPECT_EQ(failure.find("words"), std::string::npos) << failure;
}

TEST_F(JudgeTest, TheNameOfASceneReplacesNoOtherPicture) {
  const fs::path place = folder_ / "coursework";
  fs::create_directories(place / "scenes");
  fs::copy_file(courseworkFolder("solutions") / "part6_roulette.cpp", place / "part6_roulette.cpp");
  JudgeOptions options = onlyPart(6);
  options.whole = true;
  Judge judge(options, nullptr);
  const Judged without = judge.judge(place, 2, kGoOn);
  const std::string reference = without.record.parts.at(0).pictures.at(0).reference;
  fs::copy_file(shippedSceneFile("cornell_box"),
                place / "scenes" / fs::path(reference).filename().replace_extension(".json"));
  const Judged with = judge.judge(place, 2, kGoOn);
  ASSERT_EQ(with.record.scenes.size(), 1u);
  EXPECT_TRUE(with.files.contains(with.record.scenes[0].picture)) << with.record.scenes[0].message;
  EXPECT_NE(with.record.scenes[0].picture, reference);
  EXPECT_TRUE(with.files.at(reference) == without.files.at(reference));
}

TEST_F(JudgeTest, StopsWhereItIsToldTo) {
  Judge judge(onlyPart(5), nullptr);
  int asked = 0;
  EXPECT_THROW(judge.judge(submission(), 2, [&](double) { return ++asked < 5; }), Interrupted);
}

TEST_F(JudgeTest, WhatIsNotDoneInTimeIsSaid) {
  JudgeOptions options = onlyPart(5);
  options.secondsAtMost = 0.05;
  Judge judge(options, nullptr);
  const Judged judged = judge.judge(submission(), 1, kGoOn);
  EXPECT_EQ(judged.record.parts.at(0).verdict, record::Verdict::kTimeLimit);
  EXPECT_TRUE(judged.record.outOfTime);
}

}  // namespace pathmark::grading
