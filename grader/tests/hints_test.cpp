// grader/checks/hints.json: what a student is told, in three steps, whose function fails.
#include "host/build_config.h"
#include "worker/contract.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace pathmark::test {
namespace {

constexpr std::size_t kLongestHint = 300;

nlohmann::json hints() {
  std::ifstream in(std::filesystem::path(build::kProjectFolder) / "grader/checks/hints.json");
  return nlohmann::json::parse(in);
}

TEST(Hints, AreThreeForEveryFunctionAndForNothingElse) {
  const nlohmann::json all = hints();
  EXPECT_EQ(all.size(), contract().size());
  for (const FunctionContract& function : contract()) {
    const std::string name(function.name);
    ASSERT_TRUE(all.contains(name)) << name;
    EXPECT_EQ(all[name].size(), 3u) << name;
  }
}

TEST(Hints, AreShortPlainTextWithoutLinesOfCode) {
  const nlohmann::json all = hints();
  for (const auto& [function, steps] : all.items())
    for (const std::string hint : steps) {
      EXPECT_FALSE(hint.empty()) << function;
      EXPECT_LE(hint.size(), kLongestHint) << function << ": " << hint;
      EXPECT_TRUE(
          std::all_of(hint.begin(), hint.end(), [](char c) { return c >= ' ' && c <= '~'; }))
          << function << ": " << hint;
      EXPECT_EQ(hint.find_first_of(";{}"), std::string::npos) << function << ": " << hint;
    }
}

TEST(Hints, BeginWithAQuestion) {
  const nlohmann::json all = hints();
  for (const auto& [function, steps] : all.items())
    EXPECT_NE(steps[0].get<std::string>().find('?'), std::string::npos) << function;
}

}  // namespace
}  // namespace pathmark::test
