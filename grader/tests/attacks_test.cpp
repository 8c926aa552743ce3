// The attacks in attacks/, each a part 6 of its own, on every tier that this machine has: each
// fails, is reported as what it is, changes nothing outside, and leaves the host alive.
//
// A file begins with what it tries and what must become of it:
//
//   // Attack: reads the list of users with a stream
//   // Expected: forbidden call openat
//   // Says: /etc/passwd
//
// One that does not define part 6 itself defines attack(), which a part 6 that is right calls.
//
// @CANARY@ stands for a folder that everybody may read and write, with a file "canary"; @ROOT@ for
// the project's folder; @HOST@ for the number of this process.
#include "checks/runner.h"
#include "host/build_config.h"
#include "host/coursework_builder.h"
#include "support/sandbox_tiers.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <tuple>

#include <sys/wait.h>
#include <unistd.h>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;
using sandbox::Tier;

const fs::path kAttacks = fs::path(PATHMARK_ROOT) / "grader/tests/attacks";
constexpr const char* kFile = "part6_roulette.cpp";
constexpr const char* kSecret = "int canary = \"never to be seen\";\n";
constexpr const char* kSecretWords = "never to be seen";
constexpr std::size_t kMostMessages = std::size_t{300} << 10;

constexpr const char* kRightFunction = R"(
namespace pathmark {

Roulette LitScene::RussianRoulette(const Colour& throughput, int, float u) const {
  static const int done = attack();
  (void)done;
  const float largest = std::max({throughput.r, throughput.g, throughput.b});
  if (!(largest > 0.0f)) return {false, 0.0f};
  const float q = std::clamp(largest, 0.1f, 0.9f);
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

std::string contentOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t k = 0; (k = text.find(from, k)) != std::string::npos; k += to.size())
    text.replace(k, from.size(), to);
}

// What stands behind this word in the head of the file; empty if it is not there.
std::string headLine(const std::string& text, const std::string& word) {
  const std::string begin = "// " + word + ": ";
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return {};
  return text.substr(at + begin.size(), text.find('\n', at) - at - begin.size());
}

// Little, so that what takes memory without end is at its limit soon. Honest parts need 190 MiB of
// address space on two processors, most of it reserved and never touched, and a few more for each
// further one.
constexpr std::size_t kMemoryOfWorker = std::size_t{512} << 20;

// Time decides only where the attack is to be stopped by it: any other comes to its own end,
// however slow the machine.
double patienceFor(const std::string& expected) {
  return expected.find("time limit") == std::string::npos ? 20.0 : 3.0;
}

// For tools with little time and memory: honest parts need far less.
std::shared_ptr<Confinement> hastySandbox(Tier tier) {
  static std::mutex mutex;
  static std::map<Tier, std::shared_ptr<Confinement>> opened;
  const std::lock_guard lock(mutex);
  std::shared_ptr<Confinement>& here = opened[tier];
  if (!here)
    here = sandbox::openSandbox(tier, {.toolSeconds = 40.0,
                                       .toolBytes = std::size_t{1} << 30,
                                       .fileBytes = std::size_t{64} << 20});
  return here;
}

struct Outcome {
  std::string verdict;
  std::string sentence;  // of the report
};

std::string verdictOf(WorkerFault fault) {
  switch (fault) {
    case WorkerFault::kTimeLimit:
      return "time limit";
    case WorkerFault::kOutputLimit:
      return "output limit";
    case WorkerFault::kMemoryLimit:
      return "memory limit";
    case WorkerFault::kForbiddenCall:
      return "forbidden call";
    default:
      return "crashed";
  }
}

Outcome outcomeOf(const PartBuild& built, const checks::PartResult& part) {
  if (!built.compiled) return {"does not compile", part.failure};
  if (part.fault) return {verdictOf(*part.fault), part.failure};
  if (!part.failure.empty()) return {"does not link", part.failure};
  Outcome outcome{"ok", {}};
  for (const checks::FunctionResult& f : part.functions) {
    if (f.status == checks::Status::kNotWritten) return {"not written", {}};
    for (const checks::CheckResult& c : f.checks) {
      if (c.finding.fault) return {verdictOf(*c.finding.fault), c.finding.got};
      if (c.finding.status == checks::Status::kFail) outcome = {"wrong", c.finding.got};
    }
  }
  return outcome;
}

// Where tiers differ, the expected verdicts are "this or that".
bool isOneOf(const std::string& verdict, std::string expected) {
  for (std::size_t at; (at = expected.find(" or ")) != std::string::npos; expected.erase(0, at + 4))
    if (expected.substr(0, at) == verdict) return true;
  return expected == verdict;
}

class Attack : public testing::TestWithParam<std::tuple<std::string, Tier>> {
 protected:
  Attack() {
    fs::permissions(canary_.path(), fs::perms::all);
    std::ofstream(canary_ / "canary") << kSecret;
    fs::permissions(canary_ / "canary", fs::perms::all);
    setenv("PATHMARK_SECRET", kSecretWords, 1);
  }
  ~Attack() override { unsetenv("PATHMARK_SECRET"); }

  std::string attackText() const {
    std::string text = contentOf(kAttacks / (std::get<0>(GetParam()) + ".cpp"));
    replaceAll(text, "@CANARY@", canary_.path().string());
    replaceAll(text, "@ROOT@", PATHMARK_ROOT);
    replaceAll(text, "@HOST@", std::to_string(getpid()));
    if (text.find(" attack() {") != std::string::npos &&
        text.find("RussianRoulette") == std::string::npos)
      text += kRightFunction;
    return text;
  }

  TemporaryFolder canary_, coursework_;
};

INSTANTIATE_TEST_SUITE_P(All, Attack,
                         testing::Combine(testing::ValuesIn(attackNames()),
                                          testing::ValuesIn(expectedTiers())),
                         [](const auto& p) {
                           return std::get<0>(p.param) + "_" +
                                  std::string(nameOf(std::get<1>(p.param)));
                         });

TEST_P(Attack, FailsAndIsReportedAsWhatItIs) {
  const std::string text = attackText();
  const std::string expected = headLine(text, "Expected");
  ASSERT_FALSE(expected.empty()) << "the file does not say what must become of it";
  std::ofstream(coursework_ / kFile) << text;

  const CourseworkBuild build = buildCoursework(coursework_.path(), Incomplete::kCompileOnly,
                                                hastySandbox(std::get<1>(GetParam())));
  std::mutex mutex;
  std::string printed;
  checks::Selection selection;
  selection.parts = {6};
  selection.images = selection.scenes = false;
  checks::RunOptions options;
  options.threads = 1;
  options.secondsWithoutAnswer = patienceFor(expected);
  options.memoryBytes = kMemoryOfWorker;
  options.onText = [&](std::string_view words) {
    const std::lock_guard lock(mutex);
    printed += words;
  };
  const checks::CourseworkResults results = checks::runChecks(build, selection, options);
  ASSERT_EQ(results.parts.size(), 1u);
  const PartBuild& built = build.parts.at(6);
  const Outcome outcome = outcomeOf(built, results.parts.front());

  // With sanitizers, which need calls that the worker else gives up and find some errors before the
  // processor does, other words tell of the same.
  if (!build::kSanitized) {
    const std::string call = expected.starts_with("forbidden call ") ? expected.substr(15) : "";
    EXPECT_TRUE(isOneOf(outcome.verdict, call.empty() ? expected : "forbidden call"))
        << outcome.verdict << ": " << outcome.sentence;
    EXPECT_NE(outcome.sentence.find(call), std::string::npos) << outcome.sentence;
    EXPECT_NE(outcome.sentence.find(headLine(text, "Says")), std::string::npos) << outcome.sentence;
  }

  for (const std::string& said : {outcome.sentence, built.messages, printed}) {
    EXPECT_EQ(said.find(kSecretWords), std::string::npos) << said;
    EXPECT_EQ(said.find("root:"), std::string::npos) << said;
  }
  EXPECT_LE(built.messages.size(), kMostMessages);
  EXPECT_EQ(contentOf(canary_ / "canary"), kSecret);
  EXPECT_EQ(std::distance(fs::directory_iterator(canary_.path()), fs::directory_iterator{}), 1);
  EXPECT_FALSE(fs::exists("/tmp/pathmark-attack"));
  EXPECT_FALSE(fs::exists("/dev/shm/pathmark-attack"));
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process is left";
}

TEST(Attacks, AreManyAndEachSaysWhatItTries) {
  const std::vector<std::string> names = attackNames();
  EXPECT_GE(names.size(), 40u);
  for (const std::string& name : names)
    EXPECT_FALSE(headLine(contentOf(kAttacks / (name + ".cpp")), "Attack").empty()) << name;
}

}  // namespace
}  // namespace pathmark::test
