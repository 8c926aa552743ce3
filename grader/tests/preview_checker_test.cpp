// The checker of the preview window: it says what `pathmark check` says, and only again what has
// changed.
#include "preview/checker.h"
#include "support/coursework_copy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

namespace pathmark::preview {
namespace {

using F = CourseworkFunction;
using test::CourseworkCopy;
using Report = std::shared_ptr<const CheckReport>;

const std::filesystem::path kRoot = PATHMARK_ROOT;

constexpr const char* kLambertian = "part3_lambertian.cpp";

CourseworkBuild compile(const std::filesystem::path& folder) {
  return buildCoursework(folder, Incomplete::kCompileOnly);
}

// All reports of a check that nobody stops.
std::vector<Report> checkAll(Checker& checker, const std::filesystem::path& folder,
                             std::uint64_t number) {
  std::vector<Report> reports;
  checker.check(compile(folder), number, std::stop_token(),
                [&](Report report) { reports.push_back(std::move(report)); });
  return reports;
}

std::set<std::string> sectionsChecked(const std::vector<Report>& reports) {
  std::set<std::string> sections;
  for (const Report& report : reports)
    if (!report->current.empty()) sections.insert(report->current.substr(0, 2));
  return sections;
}

int count(const CheckReport& report, Outcome outcome) {
  return static_cast<int>(
      std::count_if(report.functions.begin(), report.functions.end(),
                    [&](const FunctionVerdict& f) { return f.outcome == outcome; }));
}

std::string fieldOf(const CheckLine& line, const std::string& name) {
  for (const CheckLine::Field& field : line.fields)
    if (field.name == name) return field.value;
  return {};
}

const CheckLine& lineOf(const CheckReport& report, F function, const std::string& id) {
  for (const CheckLine& line : report.find(function)->checks)
    if (line.id == id) return line;
  throw std::out_of_range(id);
}

TEST(PreviewChecker, SaysOfTheSolutionsThatAllIsRightAndChecksOnlyWhatHasChangedAgain) {
  CourseworkCopy copy;
  const auto checker = makeChecker({});
  const std::vector<Report> first = checkAll(*checker, copy.path(), 1);
  const CheckReport& right = *first.back();
  EXPECT_TRUE(right.finished);
  EXPECT_EQ(count(right, Outcome::kPass), 30) << right.next;
  EXPECT_NE(right.headline.find("30 of 30 functions are right (seed 1, "), std::string::npos)
      << right.headline;
  EXPECT_TRUE(right.next.empty()) << right.next;
  EXPECT_FALSE(right.nextFunction);
  // Parts are reported when they are done, not all at the end.
  EXPECT_TRUE(std::any_of(first.begin(), first.end(), [](const Report& r) {
    return !r->finished && count(*r, Outcome::kPass) > 0 && count(*r, Outcome::kUnknown) > 0;
  }));

  copy.replace(kLambertian, "Kd * kInvPi", "Kd");
  const std::vector<Report> second = checkAll(*checker, copy.path(), 2);
  EXPECT_EQ(sectionsChecked(second), (std::set<std::string>{"3."}));
  EXPECT_EQ(count(*second.front(), Outcome::kPass), 27);
  EXPECT_EQ(second.front()->find(F::kLambertianPdf)->outcome, Outcome::kUnknown);
  EXPECT_EQ(second.back()->find(F::kLambertianBrdf)->outcome, Outcome::kFail);
  EXPECT_EQ(second.back()->find(F::kTracePath)->build, 2u);

  const std::vector<Report> third = checkAll(*checker, copy.path(), 3);
  ASSERT_EQ(third.size(), 1u) << "nothing had changed";
  EXPECT_TRUE(third.front()->finished);
  EXPECT_EQ(third.front()->find(F::kLambertianBrdf)->outcome, Outcome::kFail);
}

class PreviewCheckerOfOnePart : public testing::Test {
 protected:
  // The other parts do not compile, so that they cost no time.
  PreviewCheckerOfOnePart() {
    for (const PartContract& part : parts())
      if (part.part != 3) std::ofstream(copy.file(std::string(part.file))) << "this is not C++\n";
  }

  CourseworkCopy copy;
  std::unique_ptr<Checker> checker = makeChecker({});
};

TEST_F(PreviewCheckerOfOnePart, TellsOfAMistakeWhatTheCommandTells) {
  copy.replace(kLambertian, "Kd * kInvPi", "Kd");
  const Report report = checkAll(*checker, copy.path(), 1).back();
  const CheckLine& line = lineOf(*report, F::kLambertianBrdf, "3.1/value");
  EXPECT_EQ(line.outcome, Outcome::kFail);
  EXPECT_EQ(fieldOf(line, "where"),
            "Kd = (0.9, 0.5, 0.2), wo = (0, 1, 0), wi = (0, 1, 0), n = (0, 1, 0)");
  EXPECT_EQ(fieldOf(line, "got"), "f (red) = 0.9");
  EXPECT_NE(line.found.find("\ngot f (red) = 0.9\n"), std::string::npos) << line.found;
  EXPECT_EQ(fieldOf(line, "likely"), "f = Kd, the 1/pi is forgotten");
  EXPECT_NE(fieldOf(line, "evidence").find("with this mistake: 0.8"), std::string::npos);
  EXPECT_EQ(fieldOf(line, "read"), "handouts/part3_lambertian.md, section 3.1");
  EXPECT_EQ(line.command, "./pathmark check 3.1/value --seed 1 --with " + copy.with());
  EXPECT_EQ(report->find(F::kLambertianPdf)->outcome, Outcome::kPass);
}

TEST_F(PreviewCheckerOfOnePart, SaysWhichPartsDoNotCompileAndToMendThemFirst) {
  const Report report = checkAll(*checker, copy.path(), 1).back();
  EXPECT_TRUE(report->finished);
  EXPECT_TRUE(report->failures[3].empty());
  EXPECT_TRUE(report->failures[5].starts_with("does not compile")) << report->failures[5];
  EXPECT_EQ(report->find(F::kTracePath)->outcome, Outcome::kUnknown);
  EXPECT_EQ(report->find(F::kLambertianPdf)->outcome, Outcome::kPass);
  EXPECT_NE(report->next.find("part0_warmup.cpp, which does not compile."), std::string::npos);
  EXPECT_FALSE(report->nextFunction);
}

TEST_F(PreviewCheckerOfOnePart, SaysWhatStandsInTheWay) {
  copy.replace(
      kLambertian, "  const vec2 onDisc",
      "  PATHMARK_UNIMPLEMENTED(\"part3_lambertian.cpp\", \"lambertianBRDF::reflection\");\n"
      "  const vec2 onDisc");
  const Report report = checkAll(*checker, copy.path(), 1).back();
  EXPECT_EQ(report->find(F::kLambertianReflection)->outcome, Outcome::kNotWritten);
  const FunctionVerdict& blocked = *report->find(F::kLambertianPdf);
  EXPECT_EQ(blocked.outcome, Outcome::kBlocked);
  EXPECT_EQ(blocked.blocker, "right so far; the rest by 3.3 lambertianBRDF::reflection");
}

// A loop that never ends would be waited for until the worker's limit, and then take its blame.
TEST_F(PreviewCheckerOfOnePart, StopsWhileTheCourseworkGivesNoAnswer) {
  copy.replace(kLambertian, "return std::max(dot(wi, n), 0.0f) * kInvPi;",
               "for (volatile int k = 0; k >= 0; k = 1) {} return dot(wi, n);");
  std::stop_source stop;
  std::vector<Report> reports;
  checker->check(compile(copy.path()), 1, stop.get_token(), [&](Report report) {
    if (report->current.starts_with("3.2")) stop.request_stop();
    reports.push_back(std::move(report));
  });
  ASSERT_TRUE(stop.stop_requested());
  EXPECT_FALSE(reports.back()->finished);
  EXPECT_EQ(reports.back()->find(F::kLambertianPdf)->outcome, Outcome::kUnknown);

  // What was not done is checked next time, though it has not changed.
  copy.replace(kLambertian, "for (volatile int k = 0; k >= 0; k = 1) {} return dot(wi, n);",
               "return std::max(dot(wi, n), 0.0f) * kInvPi;");
  EXPECT_EQ(checkAll(*checker, copy.path(), 2).back()->find(F::kLambertianPdf)->outcome,
            Outcome::kPass);
}

TEST_F(PreviewCheckerOfOnePart, ChecksFirstWhatWasSavedLast) {
  std::filesystem::copy_file(kRoot / "solutions/part6_roulette.cpp",
                             copy.file("part6_roulette.cpp"),
                             std::filesystem::copy_options::overwrite_existing);
  std::vector<std::string> begun;
  const auto checkUntilOneHasBegun = [&](std::uint64_t number) {
    std::stop_source stop;
    checker->check(compile(copy.path()), number, stop.get_token(), [&](const Report& report) {
      if (report->current.empty() || stop.stop_requested()) return;
      begun.push_back(report->current.substr(0, 2));
      stop.request_stop();
    });
  };
  checkUntilOneHasBegun(1);
  std::ofstream(copy.file("part6_roulette.cpp"), std::ios::app) << "int saved;\n";
  checkUntilOneHasBegun(2);
  EXPECT_EQ(begun, (std::vector<std::string>{"3.", "6."}));
}

TEST(PreviewChecker, SaysOfTheStubsThatTheyAreNotWrittenAndWhereToBegin) {
  const auto checker = makeChecker({});
  const Report report = checkAll(*checker, kRoot / "student", 1).back();
  EXPECT_EQ(count(*report, Outcome::kNotWritten), 30);
  EXPECT_EQ(report->nextFunction, F::kRayTriangleIntersection);
  EXPECT_TRUE(report->next.starts_with("write 0.1 ray_triangle_intersection in ")) << report->next;
  EXPECT_FALSE(checker->hints(F::kRayTriangleIntersection).empty());
}

TEST(PreviewChecker, SaysOfAPartThatDoesNotLinkWhyItCannotBeChecked) {
  CourseworkBuild build = compile(kRoot / "student");
  for (PartBuild& part : build.parts) part.object = "/nowhere/part.o";
  const auto checker = makeChecker({});
  Report last;
  checker->check(build, 1, std::stop_token(), [&](Report report) { last = std::move(report); });
  ASSERT_NE(last, nullptr);
  EXPECT_TRUE(last->finished);
  EXPECT_TRUE(last->failures[3].starts_with("does not link")) << last->failures[3];
}

}  // namespace
}  // namespace pathmark::preview
