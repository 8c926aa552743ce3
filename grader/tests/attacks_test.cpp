// Real attacks, on every tier of the sandbox: none reaches anything, each is told as what it is,
// and the grader goes on.
//
// An attack is a file of attacks/ with two lines for a head:
//
//   // Attack: what it wants
//   // Verdict: what must come of it, or several that may
//
// It stands in for part 6. One that does not define the part's function defines attack(), which a
// right one calls.
#include "checks/runner.h"
#include "grading/record_results.h"
#include "record/record.h"
#include "support/coursework_copy.h"
#include "support/sandbox_tiers.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

const fs::path kAttacks = fs::path(PATHMARK_ROOT) / "grader/tests/attacks";
constexpr const char* kFile = "part6_roulette.cpp";
constexpr int kPart = 6;

constexpr const char* kRightFunction = R"(
namespace pathmark {
Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  attack();
  const float largest = glm::max(throughput.x, glm::max(throughput.y, throughput.z));
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = glm::clamp(largest, 0.05f, 0.95f);
  return u < q ? Roulette{true, 1.0f / q} : Roulette{false, 0.0f};
}
}  // namespace pathmark
)";

std::vector<std::string> attackNames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kAttacks))
    names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

std::vector<std::string> expectedVerdicts(const std::string& attack) {
  const std::string head = "// Verdict: ";
  const std::size_t at = attack.find(head) + head.size();
  std::istringstream list(attack.substr(at, attack.find('\n', at) - at));
  std::vector<std::string> verdicts;
  for (std::string verdict; std::getline(list, verdict, ',');)
    verdicts.push_back(verdict.substr(verdict.find_first_not_of(' ')));
  return verdicts;
}

std::string newSecret() {
  std::random_device device;
  std::string secret = "secret";
  for (int k = 0; k < 4; ++k) secret += std::to_string(device());
  return secret;
}

// Things of the instructor's, outside of the sandbox.
class Outside {
 public:
  Outside() {
    std::ofstream(secretFile()) << secret_ << "\n";
    fs::permissions(folder_.path(), fs::perms::all);
    fs::permissions(secretFile(), fs::perms::all);
    setenv("PATHMARK_SECRET", secret_.c_str(), 1);
  }

  fs::path folder() const { return folder_.path(); }
  fs::path secretFile() const { return folder_ / "secret.txt"; }
  const std::string& secret() const { return secret_; }

  void expectUntouched() const {
    EXPECT_EQ(readAll(secretFile()), secret_ + "\n");
    for (const auto& entry : fs::directory_iterator(folder()))
      EXPECT_EQ(entry.path().filename(), "secret.txt") << "this file is new";
    EXPECT_FALSE(fs::exists("/tmp/pathmark_filler"));
  }

 private:
  TemporaryFolder folder_;
  std::string secret_ = newSecret();
};

std::string textOf(const record::PartRecord& part) {
  std::string text = part.message;
  for (const record::FunctionRecord& f : part.functions)
    for (const record::CheckRecord& c : f.checks)
      text += c.id + ": " + std::string(nameOf(c.verdict)) + ": " + c.where + " " + c.got + "\n";
  return text;
}

class Attack : public testing::TestWithParam<std::tuple<sandbox::Tier, std::string>> {};

TEST_P(Attack, ReachesNothingAndIsToldAsWhatItIs) {
  const auto& [tier, name] = GetParam();
  const std::shared_ptr<Confinement> confinement = sandboxOf(tier);
  const Outside outside;
  std::string code = readAll(kAttacks / (name + ".cpp"));
  const std::vector<std::string> expected = expectedVerdicts(code);
  replaceAll(code, "@SOLUTIONS@", (fs::path(PATHMARK_ROOT) / "solutions").string());
  replaceAll(code, "@SECRET_FILE@", outside.secretFile().string());
  replaceAll(code, "@OUTSIDE@", outside.folder().string());
  replaceAll(code, "@SECRET@", outside.secret());
  if (code.find("RussianRoulette") == std::string::npos) code += kRightFunction;
  CourseworkCopy coursework;
  std::ofstream(coursework.file(kFile)) << code;

  const CourseworkBuild build =
      buildCoursework(coursework.path(), Incomplete::kCompileOnly, confinement);
  std::string printed;
  checks::RunOptions options;
  options.threads = 1;
  options.secondsWithoutAnswer = 2.0;
  options.onText = [&](std::string_view text) {
    if (printed.size() < 65536) printed += text;
  };
  checks::Selection selection;
  selection.parts = {kPart};
  selection.images = selection.scenes = false;
  const checks::CourseworkResults results = checks::runChecks(build, selection, options);
  const record::PartRecord part = grading::recordParts(results, build, selection.parts).at(0);

  const std::string verdict(nameOf(part.verdict)), text = textOf(part);
  EXPECT_NE(std::find(expected.begin(), expected.end(), verdict), expected.end())
      << verdict << "\n"
      << text.substr(0, 4000);
  EXPECT_EQ(text.find(outside.secret()), std::string::npos) << text;
  EXPECT_EQ(printed.find(outside.secret()), std::string::npos) << printed;
  outside.expectUntouched();
}

std::string nameOfTest(const testing::TestParamInfo<Attack::ParamType>& info) {
  return std::string(sandbox::nameOf(std::get<0>(info.param))) + "_" + std::get<1>(info.param);
}

INSTANTIATE_TEST_SUITE_P(Every, Attack,
                         testing::Combine(testing::ValuesIn(expectedTiers()),
                                          testing::ValuesIn(attackNames())),
                         nameOfTest);

TEST(AttackCorpus, HasAtLeastFortyAttacks) { EXPECT_GE(attackNames().size(), 40u); }

}  // namespace
}  // namespace pathmark::test
