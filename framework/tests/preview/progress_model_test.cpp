// What the progress panel shows.
#include "preview/progress/progress_model.h"

#include <gtest/gtest.h>

namespace pathmark::preview {
namespace {

using F = CourseworkFunction;

CourseworkBuild compiledBuild() {
  CourseworkBuild build;
  build.folder = "student";
  for (const PartContract& part : parts()) {
    PartBuild compiled;
    compiled.part = part;
    compiled.compiled = true;
    build.parts.push_back(std::move(compiled));
  }
  return build;
}

CourseworkState stateOf(CourseworkBuild build, std::uint64_t number,
                        std::initializer_list<F> unwritten = {}) {
  CourseworkState state;
  state.build = std::make_shared<const CourseworkBuild>(std::move(build));
  state.number = number;
  for (const F f : unwritten) state.stubs.unwritten.push_back(contractOf(f));
  return state;
}

CheckReport allWith(Outcome outcome, std::uint64_t build) {
  CheckReport report;
  report.build = build;
  report.failures.resize(parts().size());
  for (const FunctionContract& f : contract())
    report.functions.push_back({f.function, outcome, {}, {}, build});
  return report;
}

FunctionVerdict& verdictIn(CheckReport& report, F function) {
  return report.functions[static_cast<std::size_t>(function)];
}

const FunctionRow& rowOf(const Progress& progress, F function) {
  for (const PartRow& part : progress.parts)
    for (const FunctionRow& row : part.functions)
      if (row.function.function == function) return row;
  throw std::out_of_range("no such function");
}

TEST(ProgressModel, StubsAreKnownBeforeAnyCheck) {
  const Progress progress = progressOf(stateOf(compiledBuild(), 1, {F::kLambertianPdf}), nullptr);
  EXPECT_EQ(progress.functions(), 23);
  EXPECT_EQ(rowOf(progress, F::kLambertianPdf).outcome, Outcome::kNotWritten);
  EXPECT_EQ(rowOf(progress, F::kPhongPdf).outcome, Outcome::kUnknown);
  EXPECT_EQ(progress.next,
            "write 3.2 lambertianBRDF::pdf in student/part3_lambertian.cpp; the chapter is "
            "handouts/part3_lambertian.md.");
  EXPECT_EQ(progress.nextFunction, F::kLambertianPdf);
  EXPECT_TRUE(progress.checking);
}

TEST(ProgressModel, NothingIsSaidBeforeTheFirstBuild) {
  const Progress progress = progressOf(CourseworkState(), nullptr);
  EXPECT_EQ(progress.count(Outcome::kUnknown), 23);
  EXPECT_TRUE(progress.next.empty());
  EXPECT_FALSE(progress.checking);
}

TEST(ProgressModel, OutcomesOfAnOlderBuildAreMarked) {
  CheckReport report = allWith(Outcome::kPass, 1);
  report.finished = true;
  report.headline = "all is right";
  const Progress progress = progressOf(stateOf(compiledBuild(), 2), &report);
  EXPECT_EQ(rowOf(progress, F::kTracePath).outcome, Outcome::kPass);
  EXPECT_TRUE(rowOf(progress, F::kTracePath).older);
  EXPECT_TRUE(progress.checking);
  EXPECT_TRUE(progress.status.empty()) << progress.status;
}

TEST(ProgressModel, WhatTheNewestCheckHasNotComeToKeepsItsOlderOutcome) {
  const CheckReport older = allWith(Outcome::kPass, 1);
  CheckReport newer = allWith(Outcome::kUnknown, 2);
  verdictIn(newer, F::kTracePath) = {F::kTracePath, Outcome::kFail, {}, {}, 2};
  newer.failures[4] = "does not link";
  const CheckReport known = withOlder(newer, &older);
  const Progress progress = progressOf(stateOf(compiledBuild(), 2), &known);
  EXPECT_EQ(rowOf(progress, F::kTracePath).outcome, Outcome::kFail);
  EXPECT_FALSE(rowOf(progress, F::kTracePath).older);
  EXPECT_EQ(rowOf(progress, F::kLambertianPdf).outcome, Outcome::kPass);
  EXPECT_TRUE(rowOf(progress, F::kLambertianPdf).older);
  EXPECT_EQ(rowOf(progress, F::kPhongPdf).outcome, Outcome::kUnknown) << "it cannot be checked";
}

TEST(ProgressModel, WhatIsWrittenNowIsNotCalledUnwrittenByAnOlderCheck) {
  const CheckReport report = allWith(Outcome::kNotWritten, 1);
  const Progress progress = progressOf(stateOf(compiledBuild(), 2, {F::kRussianRoulette}), &report);
  EXPECT_EQ(rowOf(progress, F::kTracePath).outcome, Outcome::kUnknown);
  EXPECT_EQ(rowOf(progress, F::kRussianRoulette).outcome, Outcome::kNotWritten);
  EXPECT_FALSE(rowOf(progress, F::kRussianRoulette).older);
}

TEST(ProgressModel, WhatIsAStubAgainIsNotCalledRightByAnOlderCheck) {
  const CheckReport report = allWith(Outcome::kPass, 1);
  const Progress progress = progressOf(stateOf(compiledBuild(), 2, {F::kTracePath}), &report);
  EXPECT_EQ(rowOf(progress, F::kTracePath).outcome, Outcome::kNotWritten);
}

TEST(ProgressModel, APartWhoseFileIsMissingSaysThatItIs) {
  CourseworkBuild build = compiledBuild();
  build.parts[3].compiled = false;
  build.parts[3].missing = true;
  build.parts[3].messages = " it is missing.";
  const Progress progress = progressOf(stateOf(std::move(build), 2), nullptr);
  EXPECT_EQ(progress.parts[3].failure, "is missing");
  EXPECT_EQ(progress.next, "mend student/part3_lambertian.cpp, which is missing.");
}

TEST(ProgressModel, APartThatDoesNotCompileSaysWhereAndHasNoOutcomes) {
  CourseworkBuild build = compiledBuild();
  build.parts[3].compiled = false;
  build.parts[3].messages =
      "\nstudent/part3_lambertian.cpp: In member function 'brdf':\n"
      "student/part3_lambertian.cpp:12:20: error: 'kInvTau' was not declared\n   12 | return\n";
  const CheckReport report = allWith(Outcome::kPass, 1);
  const Progress progress = progressOf(stateOf(std::move(build), 2), &report);
  EXPECT_EQ(progress.parts[3].failure,
            "does not compile: student/part3_lambertian.cpp:12:20: error: 'kInvTau' was not "
            "declared");
  EXPECT_EQ(progress.parts[3].count(Outcome::kUnknown), 3);
  EXPECT_EQ(progress.parts[4].count(Outcome::kPass), 3);
  EXPECT_EQ(progress.next, "mend student/part3_lambertian.cpp, which does not compile.");
  EXPECT_FALSE(progress.nextFunction);
}

TEST(ProgressModel, WhatIsWrongComesBeforeWhatIsNotWritten) {
  CheckReport report = allWith(Outcome::kUnknown, 1);
  verdictIn(report, F::kSampleSphere).outcome = Outcome::kNotWritten;
  verdictIn(report, F::kTracePath).outcome = Outcome::kBroken;
  const Progress progress = progressOf(stateOf(compiledBuild(), 1, {F::kSampleSphere}), &report);
  EXPECT_EQ(progress.nextFunction, F::kTracePath);
  EXPECT_TRUE(progress.next.starts_with("mend 5.1 ")) << progress.next;
}

TEST(ProgressModel, SaysWhatIsBeingChecked) {
  CheckReport report = allWith(Outcome::kUnknown, 1);
  report.fraction = 0.25;
  report.current = "3.3/samples";
  const Progress progress = progressOf(stateOf(compiledBuild(), 1), &report);
  EXPECT_EQ(progress.status, "Checking 3.3 lambertianBRDF::reflection: samples");
  EXPECT_EQ(progress.fraction, 0.25);
}

TEST(ProgressModel, TheCheckersWordsAreTakenWhenItIsDone) {
  CheckReport report = allWith(Outcome::kPass, 1);
  report.finished = true;
  report.headline = "student: 23 of 23 functions are right.";
  const Progress progress = progressOf(stateOf(compiledBuild(), 1), &report);
  EXPECT_EQ(progress.status, report.headline);
  EXPECT_TRUE(progress.next.empty());
  EXPECT_FALSE(progress.checking);
}

TEST(ProgressModel, FindsTheLineOfTheError) {
  EXPECT_EQ(firstError("\n  a.cpp: In function\n  a.cpp:1:2: error: no\n more\n"),
            "a.cpp:1:2: error: no");
  EXPECT_EQ(firstError(" it is missing; it must be there."), "it is missing; it must be there.");
  EXPECT_EQ(firstError("error: \u2018x\u2019 was not declared"), "error: 'x' was not declared");
  EXPECT_EQ(firstError(""), "");
}

}  // namespace
}  // namespace pathmark::preview
