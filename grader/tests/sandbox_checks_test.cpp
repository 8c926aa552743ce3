// A sandbox changes nothing of what is found in honest coursework.
#include "checks/runner.h"
#include "host/coursework_builder.h"
#include "support/sandbox_tiers.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

using sandbox::Tier;

checks::CourseworkResults resultsOf(std::shared_ptr<Confinement> confinement) {
  const CourseworkBuild build = buildCoursework(courseworkFolder("solutions"),
                                                Incomplete::kCompileOnly, std::move(confinement));
  checks::Selection selection;
  selection.images = selection.scenes = false;
  selection.parts = {1, 3, 4, 6};
  return checks::runChecks(build, selection, {});
}

// Everything but the times.
std::string inWords(const checks::CourseworkResults& results) {
  std::string text = std::to_string(results.statistics) + "\n";
  for (const checks::PartResult& part : results.parts) {
    text += part.failure + "\n";
    for (const checks::FunctionResult& f : part.functions)
      for (const checks::CheckResult& c : f.checks)
        text += idOf(*c.check) + " " + std::to_string(static_cast<int>(c.finding.status)) + " " +
                c.finding.got + " " + c.finding.expected + " " + c.finding.where + " " +
                std::to_string(c.finding.shown) + " " + std::to_string(c.finding.calls) + "\n";
  }
  return text;
}

class SandboxedChecks : public testing::TestWithParam<Tier> {};
INSTANTIATE_TEST_SUITE_P(Tiers, SandboxedChecks, testing::ValuesIn(expectedTiers()),
                         [](const auto& tier) { return std::string(nameOf(tier.param)); });

TEST_P(SandboxedChecks, FindTheSameAsOutside) {
  static const std::string outside = inWords(resultsOf(nullptr));
  EXPECT_EQ(inWords(resultsOf(sandboxOf(GetParam()))), outside);
}

}  // namespace
}  // namespace pathmark::test
