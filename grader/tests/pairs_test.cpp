// Mistakes that hide each other in the picture are found part by part.
#include "pairs/pair_study.h"
#include "support/test_coursework_files.h"
#include "variants/pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace pathmark::test {
namespace {

bool spansParts(const Pair& pair) {
  return std::any_of(pair.mistakes.begin(), pair.mistakes.end(),
                     [&](const Variant& m) { return m.part != pair.mistakes.front().part; });
}

TEST(Pairs, AreOfDifferentFunctionsOfOnePartAndOfSeveral) {
  const std::vector<Pair> all = allPairs();
  std::set<std::string> names;
  for (const Pair& pair : all) {
    SCOPED_TRACE(pair.name);
    EXPECT_TRUE(names.insert(pair.name).second) << "a name of its own";
    EXPECT_GE(pair.mistakes.size(), 2u);
    std::set<std::string> functions;
    for (const Variant& mistake : pair.mistakes) {
      EXPECT_TRUE(mistake.wrong) << mistake.name;
      EXPECT_TRUE(functions.insert(mistake.function).second) << mistake.function;
    }
  }
  const auto across = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), spansParts));
  EXPECT_GE(all.size(), 10u);
  EXPECT_GE(across, 3u);
  EXPECT_GE(all.size() - across, 3u);
}

// That no other part is said to be wrong is looked at for one pair: for all others those parts
// would be the same solutions again.
//
// Each picture of a pair is said to differ by chance with probability 1e-4 at most, and the seed is
// fixed: over all pairs, at most 0.3 % of seeds would fail here. A check fails a correct function
// with less than 1e-6.
TEST(Pairs, HideInThePictureAndAreCaughtPartByPart) {
  const TemporaryFolder scratch;
  pairs::PairOptions options{.seed = 1, .threads = 0, .scratch = scratch.path()};
  pairs::PairStudy ofAllParts(options);
  options.onlyPartsOfMistakes = true;
  pairs::PairStudy study(options);
  bool first = true;
  for (const Pair& pair : allPairs()) {
    SCOPED_TRACE(pair.name);
    const bool all = spansParts(pair) && std::exchange(first, false);
    const pairs::PairFinding finding = (all ? ofAllParts : study).of(pair);
    EXPECT_TRUE(finding.same) << "the picture of the pair differs from the solutions'";
    EXPECT_LT(finding.bias.high, pairs::kSeen);
    for (std::size_t k = 0; k < pair.mistakes.size(); ++k)
      EXPECT_GT(finding.alone[k].low, pairs::kSeen)
          << pair.mistakes[k].name << " does not show by itself either";
    for (const Variant& mistake : pair.mistakes)
      EXPECT_NE(std::find(finding.failed.begin(), finding.failed.end(), mistake.function),
                finding.failed.end())
          << mistake.function << " passes";
    for (const int part : finding.partsAtFault)
      EXPECT_TRUE(std::any_of(pair.mistakes.begin(), pair.mistakes.end(),
                              [&](const Variant& m) { return m.part == part; }))
          << "part " << part << " is right, and fails";
  }
}

}  // namespace
}  // namespace pathmark::test
