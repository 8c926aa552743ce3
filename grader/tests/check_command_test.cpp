// pathmark check as a student uses it: the real program on real coursework.
#include "support/background_program.h"
#include "support/coursework_copy.h"
#include "support/run_command.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <regex>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = PATHMARK_ROOT;

ProcessResult check(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {PATHMARK_PROGRAM, "check"});
  return run(std::move(arguments), kRoot);
}

void expectHas(const ProcessResult& result, const std::string& words) {
  EXPECT_NE(result.output.find(words), std::string::npos) << result.output;
}

void expectLacks(const ProcessResult& result, const std::string& words) {
  EXPECT_EQ(result.output.find(words), std::string::npos) << result.output;
}

constexpr const char* kLambertian = "part3_lambertian.cpp";

TEST(CheckCommand, SaysFirstWhatIsRightAndWhatComesNext) {
  const ProcessResult result = check({"3", "--with", "solutions"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_TRUE(result.output.starts_with("solutions: 3 of 3 functions are right")) << result.output;
}

TEST(CheckCommand, TakesWhatIsNotWrittenAsNeitherRightNorWrong) {
  CourseworkCopy copy;
  copy.replace(kLambertian, "  return dot(wo, n)",
               "  PATHMARK_UNIMPLEMENTED(\"part3_lambertian.cpp\", \"lambertianBRDF::brdf\");\n"
               "  return dot(wo, n)");
  const ProcessResult result = check({"3", "--with", copy.with()});
  EXPECT_EQ(result.exitCode, 0);
  expectHas(result, "Next: write 3.1 lambertianBRDF::brdf in ");
  expectHas(result, "not written 3.1  lambertianBRDF::brdf");
  expectLacks(result, "WRONG");
}

TEST(CheckCommand, SaysOfAFailureWhereWhatWhyAndHowToRepeatIt) {
  CourseworkCopy copy;
  copy.replace(kLambertian, "Kd * kInvPi", "Kd");
  const ProcessResult result = check({"3", "--with", copy.with()});
  EXPECT_EQ(result.exitCode, 1);
  expectHas(result, "WRONG       3.1  lambertianBRDF::brdf");
  expectHas(result,
            "where      Kd = (0.9, 0.5, 0.2), wo = (0, 1, 0), wi = (0, 1, 0), n = (0, 1, 0)");
  expectHas(result, "expected   f (red) = 0.286479");
  expectHas(result, "got        f (red) = 0.9");
  expectHas(result, "likely     f = Kd, the 1/pi is forgotten");
  expectHas(result,
            "evidence   f (red) where wo . n = 0.9 and wi . n = 0.7 is 0.8 (right: 0.2546;");
  expectHas(result, "read       handouts/part3_lambertian.md, section 3.1");
  const std::string repeat = "./pathmark check 3.1/value --seed 1 --with " + copy.with();
  expectHas(result, repeat);
  const ProcessResult again = check({"3.1/value", "--seed", "1", "--with", copy.with()});
  EXPECT_EQ(again.exitCode, 1);
  expectHas(again, "got        f (red) = 0.9");
}

TEST(CheckCommand, QuotesACourseworkWithSpacesForTheShell) {
  CourseworkCopy copy;
  copy.replace(kLambertian, "Kd * kInvPi", "Kd");
  const TemporaryFolder folder;
  const std::string place = (folder / "it's mine").string();
  fs::copy(copy.path(), place);
  const std::string inQuotes = (folder / "it'\\''s mine").string();
  expectHas(check({"3.1/value", "--with", place}),
            std::string("./pathmark check 3.1/value --seed 1 --with '") + inQuotes + "'\n");
}

TEST(CheckCommand, SaysHowMuchNoiseIsLeft) {
  const ProcessResult result = check({"images/noise", "--with", "solutions"});
  EXPECT_TRUE(std::regex_search(
      result.output,
      std::regex("got +variance / that of the reference = [0-9]+\\.[0-9]+ \\+- [0-9]+\\.[0-9]+\n")))
      << result.output;
}

// What is wrong only with all parts together: no stand-in has the density 1/pi along the normal.
void spoilTogether(CourseworkCopy& copy) {
  copy.replace("part5_path.cpp", "throughput * directLighting(hit, wo, sampler);",
               "throughput * directLighting(hit, wo, sampler) *\n"
               "(std::abs(hit.brdf->pdf(hit.n, hit.n, hit.n) - kInvPi) < 1e-3f ? 0.5f : 1.0f);");
}

TEST(CheckCommand, SaysOfPicturesThatAreWrongThatTheyAreAndWhatToDo) {
  CourseworkCopy copy;
  spoilTogether(copy);
  const ProcessResult result = check({"--with", copy.with()});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_TRUE(std::regex_search(
      result.output,
      std::regex("30 of 30 functions are right, but [0-9]+ of 13 pictures are wrong \\(seed")))
      << result.output;
  expectHas(result, "Next: look into images/furnace, the first picture that is wrong");
  expectHas(result, "The pictures come last");
  expectHas(result, "agree with their own checks, but not together");
  expectLacks(result, "correct, but noisier");
}

TEST(CheckCommand, SaysNothingOfTheNoiseOfAWrongPicture) {
  CourseworkCopy copy;
  spoilTogether(copy);
  const ProcessResult noise = check({"images/noise", "--with", copy.with()});
  expectHas(noise, "variance / that of the reference");
  expectLacks(noise, "note");
}

// The floor is seen by the camera; its lamp is missing, or looks away from it, or is there.
std::string sceneWithLamp(const std::string& lamp) {
  return R"({"caption": "A floor.", "size": [40, 40], "maxBounces": 4, "raysPerPixel": 4,
 "camera": {"eye": [0, 2, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 40},
 "materials": {"grey": {"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
 "shapes": [{"type": "rectangle", "material": "grey",
   "vertices": [[-2, 0, 2], [2, 0, 2], [2, 0, -2], [-2, 0, -2]]})" +
         lamp + "]}";
}

TEST(CheckCommand, SaysThatASceneIsBlack) {
  const CourseworkCopy copy;
  fs::create_directory(copy.file("scenes"));
  const std::string begin =
      R"(, {"type": "rectangle", "material": "grey", "emission": [9, 9, 9], "vertices": )";
  const std::string black = "wrong      the picture is black: no light of the scene reaches";
  const auto checked = [&](const std::string& lamp) {
    std::ofstream(copy.file("scenes/mine.json")) << sceneWithLamp(lamp);
    return check({"7", "--with", copy.with()});
  };
  const ProcessResult none = checked("");
  EXPECT_EQ(none.exitCode, 1);
  expectHas(none, black);
  expectHas(checked(begin + "[[-1, 3, 1], [1, 3, 1], [1, 3, -1], [-1, 3, -1]]}"), black);
  const ProcessResult lit = checked(begin + "[[-1, 3, -1], [1, 3, -1], [1, 3, 1], [-1, 3, 1]]}");
  EXPECT_EQ(lit.exitCode, 0);
  expectHas(lit, "noise      most of it is in the");
}

TEST(CheckCommand, GivesTheSameAnswerForTheSameSeed) {
  const auto withoutTime = [](const ProcessResult& result) {
    return std::regex_replace(result.output, std::regex(", [0-9.]+ s\\)"), "");
  };
  CourseworkCopy copy;
  copy.replace(kLambertian, "std::sqrt(t), onDisc.y", "t, onDisc.y");
  const std::vector<std::string> command{"3", "--with", copy.with(), "--seed", "7"};
  std::vector<std::string> oneThread = command;
  oneThread.insert(oneThread.end(), {"--threads", "1"});
  const ProcessResult first = check(command);
  EXPECT_EQ(first.exitCode, 1);
  EXPECT_EQ(withoutTime(first), withoutTime(check(oneThread)));
}

TEST(CheckCommand, ShowsEachTimeWhatTheCompilerWarnsOfWhereAFunctionIsWrong) {
  CourseworkCopy copy;
  copy.replace(kLambertian, "Kd * kInvPi", "Kd * (1, 0.5f) * kInvPi");
  for (int run = 0; run < 2; ++run) {
    const ProcessResult result = check({"3.1", "--with", copy.with()});
    expectHas(result, "The compiler warns:\n");
    expectHas(result, "-Wunused-value");
  }
}

TEST(CheckCommand, SaysOfAFileThatIsMissingThatItIs) {
  CourseworkCopy copy;
  std::filesystem::remove(copy.file(kLambertian));
  const ProcessResult result = check({"--with", copy.with()});
  expectHas(result, "part3_lambertian.cpp, which is missing.\n");
  EXPECT_EQ(result.output.find("does not compile"), std::string::npos) << result.output;
}

TEST(CheckCommand, ChecksTheOtherPartsWhereOneDoesNotCompile) {
  CourseworkCopy copy;
  copy.replace(kLambertian, "Kd * kInvPi", "Kd * kInvTau");
  const ProcessResult result = check({"--with", copy.with()});
  EXPECT_EQ(result.exitCode, 1);
  expectHas(result, "27 of 30 functions are right");
  expectHas(result, "part3_lambertian.cpp, which does not compile.\n");
  expectHas(result, "kInvTau");
  expectHas(result, "ok          4.1  phongBRDF::brdf");
  expectHas(result, "blocked");
}

TEST(CheckCommand, SaysWhereACrashWasAndGoesOn) {
  CourseworkCopy copy;
  copy.replace(
      kLambertian, "return std::max(dot(wi, n), 0.0f) * kInvPi;",
      "auto* p = reinterpret_cast<volatile int*>(64); return static_cast<float>(*p) + dot(wi, "
      "n);");
  const ProcessResult result = check({"3", "--with", copy.with()});
  EXPECT_EQ(result.exitCode, 1);
  expectHas(result, "BROKEN      3.2  lambertianBRDF::pdf");
  expectHas(result, "in lambertianBRDF::pdf:");
  expectHas(result, "ok          3.1  lambertianBRDF::brdf");
}

TEST(CheckCommand, EndsALoopThatNeverEnds) {
  CourseworkCopy copy;
  copy.replace(kLambertian, "return std::max(dot(wi, n), 0.0f) * kInvPi;",
               "for (volatile int k = 0; k >= 0; k = 1) {} return dot(wi, n);");
  const ProcessResult result = check({"3.2", "--with", copy.with()});
  EXPECT_EQ(result.exitCode, 1);
  expectHas(result, "is there a loop that never ends?");
}

TEST(CheckCommand, FindsNumbersThatAreNotTheArguments) {
  CourseworkCopy copy;
  copy.replace(
      kLambertian, "std::sqrt(1.0f - t) * onUnitCircle(s)",
      "std::sqrt(1.0f - t) * onUnitCircle(static_cast<float>(std::rand() % 997) / 997.0f)");
  copy.replace(kLambertian, "#include <pathmark/coursework.h>",
               "#include <pathmark/coursework.h>\n#include <cstdlib>");
  const ProcessResult result = check({"3.3", "--with", copy.with()});
  EXPECT_EQ(result.exitCode, 1);
  expectHas(result, "the same direction again for the same s, t, u");
}

TEST(CheckCommand, RefusesWhatIsNoCheckWithASuggestion) {
  expectSays(check({"lambertianBRDF::reflexion"}), 2,
             "Did you mean \"lambertianBRDF::reflection\"?");
  expectSays(check({"reflection"}), 2, "lambertianBRDF::reflection, phongBRDF::reflection");
  expectSays(check({"12"}), 2, "it is a part (0 to 9)");
  expectSays(check({"--seed", "-1"}), 2, "--seed");
  expectSays(check({"--with", "nowhere"}), 2, "there is no folder");
  expectSays(check({"--hint", "4"}), 2, "--hint");
}

TEST(CheckCommand, NamesTheSolutionsInItsHelpWhereTheyAre) {
  const std::string help = std::regex_replace(check({"--help"}).output, std::regex("\\s+"), " ");
  EXPECT_NE(help.find("student (default), solutions, or a folder of part*.cpp"), std::string::npos)
      << help;
}

TEST(CheckCommand, NamesAllFunctionsThatAWordMayMean) {
  const std::string lambertian =
      "lambertianBRDF::brdf, lambertianBRDF::pdf, lambertianBRDF::reflection";
  for (const char* ofClass : {"lambertianBRDF", "lambertianbrdf", "lambertianBDRF", "lambert"})
    expectSays(check({ofClass}), 2, lambertian);
  expectSays(check({"lambertianBRDF"}), 2, "can mean any of ");
  expectSays(check({"phong"}), 2, "Did you mean one of phongBRDF::brdf, phongBRDF::pdf, phongBRDF");
  expectSays(check({"reflexion"}), 2,
             "Did you mean one of lambertianBRDF::reflection, phongBRDF::reflection?");
  expectSays(check({"pfd"}), 2, "Sphere::pdf, lambertianBRDF::pdf, phongBRDF::pdf");
  expectSays(check({"lambertianBRDF::sample"}), 2, lambertian);
  expectSays(check({"phongBRDF::pfd"}), 2, "Did you mean \"phongBRDF::pdf\"?");
  expectSays(check({"directLightning"}), 2, "Did you mean \"LitScene::directLighting\"?");
}

TEST(CheckCommand, GivesHintsForWhatComesNext) {
  CourseworkCopy copy;
  copy.replace(kLambertian, "Kd * kInvPi", "Kd");
  const ProcessResult one = check({"3", "--with", copy.with(), "--hint"});
  expectHas(one, "Hints for 3.1 lambertianBRDF::brdf:");
  expectHas(one, "(--hint 2 says more.)");
  const ProcessResult three = check({"3", "--with", copy.with(), "--hint", "3"});
  expectHas(three, "  3  ");
  expectLacks(three, "says more");
}

TEST(CheckCommand, WritesAllResultsAsJson) {
  CourseworkCopy copy;
  copy.replace(kLambertian, "Kd * kInvPi", "Kd");
  const fs::path file = copy.file("results.json");
  check({"3", "--with", copy.with(), "--json", file.string()});
  const nlohmann::json json = nlohmann::json::parse(readAll(file));
  const nlohmann::json& function = json["parts"][0]["functions"][0];
  EXPECT_EQ(function["name"], "lambertianBRDF::brdf");
  EXPECT_EQ(function["status"], "fail");
  EXPECT_EQ(function["checks"][0]["cause"], "f = Kd, the 1/pi is forgotten");
  EXPECT_EQ(function["diagnosis"]["mistake"], "part3_pi_forgotten");
}

TEST(CheckCommand, WatchChecksAgainWhatIsSaved) {
  CourseworkCopy copy;
  const TemporaryFolder logs;
  const fs::path log = logs / "log.txt";
  const auto says = [&](const std::string& words, int times) {
    const std::string text = textOf(log);
    int found = 0;
    for (std::size_t at = 0; (at = text.find(words, at)) != std::string::npos; ++at) ++found;
    return found >= times;
  };
  const auto right = [&](int times) {
    return waitFor([&] { return says("3 of 3 functions are right", times); });
  };
  BackgroundProgram program({PATHMARK_PROGRAM, "check", "3", "--with", copy.with(), "--watch"},
                            kRoot, log);
  ASSERT_TRUE(right(1)) << textOf(log);
  copy.replace(kLambertian, "Kd * kInvPi", "Kd");
  ASSERT_TRUE(waitFor([&] { return says("likely     f = Kd, the 1/pi is forgotten", 1); }));
  copy.replace(kLambertian, "? Kd :", "? Kd * kInvPi :");
  ASSERT_TRUE(right(2)) << textOf(log);
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 0);
}

}  // namespace
}  // namespace pathmark::test
