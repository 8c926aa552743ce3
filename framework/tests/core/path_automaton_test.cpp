// The automaton of an expression lets exactly its paths through, has no state too many, and knows
// how long its paths are.
#include "light_paths/language.h"
#include "support/random_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>

namespace pathmark::test {
namespace {

constexpr std::size_t kLongest = 7;  // scattering events of the paths that are tried

// All strings of S and D.
const std::vector<std::string>& allEvents() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> strings{""};
    for (std::size_t i = 0; strings[i].size() < kLongest; ++i)
      for (const char* event : {"D", "S"}) strings.push_back(strings[i] + event);
    return strings;
  }();
  return all;
}

Lobe lobeOf(char event) { return event == 'D' ? Lobe::kDiffuse : Lobe::kSpecular; }

// Read from the eye.
PathAutomaton::State after(const PathAutomaton& automaton, std::string_view events) {
  PathAutomaton::State state = automaton.start;
  for (auto event = events.rbegin(); event != events.rend(); ++event)
    state = automaton.next(state, lobeOf(*event));
  return state;
}

bool letsThrough(const PathAutomaton& automaton, const std::string& events) {
  return automaton.lightMayCome(after(automaton, events));
}

// By the library's regular expressions, which know the same signs.
std::regex asRegex(std::string text) {
  for (std::size_t at = 0; (at = text.find('.', at)) != std::string::npos; at += 4)
    text.replace(at, 1, "[SD]");
  return std::regex(text);
}

void expectItsPaths(const std::string& text, const PathAutomaton& automaton) {
  const std::regex regex = asRegex(text);
  for (const std::string& events : allEvents())
    ASSERT_EQ(letsThrough(automaton, events), std::regex_match(fmt::format("L{}E", events), regex))
        << text << ": L" << events << "E";
}

// A random expression of the grammar, not always one that a path can match.
std::string randomExpression(RandomNumbers& random, int depth) {
  const auto chance = [&](float p) { return random.uniform(0.0f, 1.0f) < p; };
  const auto part = [&](auto&& self, int left) -> std::string {
    std::string text;
    if (left == 0 || chance(0.4f))
      text = std::string(1, "SD."[random.below(3)]);
    else if (chance(0.5f))
      text = self(self, left - 1) + self(self, left - 1);
    else
      text = fmt::format("({}|{})", self(self, left - 1), self(self, left - 1));
    if (chance(0.4f)) text = fmt::format("({}){}", text, "*+?"[random.below(3)]);
    return text;
  };
  std::string text = fmt::format("L{}E", part(part, depth));
  if (chance(0.3f)) text += fmt::format("|L{}E", part(part, depth));
  return text;
}

TEST(PathAutomaton, LetsThePathsOfItsExpressionThrough) {
  for (const char* text :
       {"LE", "LDE", "LSE", "L.*E", "L(S|D)*E", "LS+DE", "LD*E", "LDE|LSSE", "L.E", "LD?S?E",
        "L(SD)*E", "L(S*D)+E", "LDSDDSE", "(L|LD|LSD)E", "L.*S.E", "LS...*E", "LE+", "L(D*)*S*E"}) {
    SCOPED_TRACE(text);
    expectItsPaths(text, automatonFor(PathExpression(text)));
  }
}

TEST(PathAutomaton, BindsRepetitionMoreThanSequenceAndThatMoreThanChoice) {
  const auto same = [](const char* a, const char* b) {
    return automatonFor(PathExpression(a)) == automatonFor(PathExpression(b));
  };
  EXPECT_TRUE(same("LSD*E", "LS(D*)E"));
  EXPECT_FALSE(same("LSD*E", "L(SD)*E"));
  EXPECT_TRUE(same("L(SD|DS)E", "L((SD)|(DS))E"));
  EXPECT_FALSE(same("L(SD|DS)E", "LS(D|D)SE"));
  EXPECT_TRUE(same("LSE|LDE", "L(S|D)E"));
  EXPECT_TRUE(same("L.+E", "L.(.*)E"));
  EXPECT_TRUE(same("L(S|D)*E", "L.*E"));
}

TEST(PathAutomaton, LetsThePathsOfRandomExpressionsThrough) {
  RandomNumbers random(31);
  for (int k = 0; k < 150; ++k) {
    const std::string text = randomExpression(random, 3);
    expectItsPaths(text, automatonFor(PathExpression(text)));
    if (HasFatalFailure()) return;
  }
}

// States are told apart by some path that only one of them lets through.
TEST(PathAutomaton, IsMinimalAndOfItsPathsAlone) {
  RandomNumbers random(32);
  for (int k = 0; k < 100; ++k) {
    const std::string text = randomExpression(random, 2);
    PathAutomaton automaton = automatonFor(PathExpression(text));
    std::set<std::string> signatures;
    for (std::size_t state = 0; state < automaton.states; ++state) {
      automaton.start = static_cast<PathAutomaton::State>(state);
      std::string signature;
      for (const std::string& events : allEvents())
        signature += letsThrough(automaton, events) ? '1' : '0';
      EXPECT_TRUE(signatures.insert(signature).second) << text;
      EXPECT_EQ(signature.find('1') == std::string::npos, state == PathAutomaton::kDead) << text;
    }
    // Another text for the same paths.
    EXPECT_TRUE(automatonFor(PathExpression(text)) ==
                automatonFor(PathExpression(fmt::format("({})|{}", text, text))));
  }
}

TEST(PathAutomaton, KnowsTheLengthsOfItsPaths) {
  RandomNumbers random(33);
  int bounded = 0, unbounded = 0;
  for (int k = 0; k < 200; ++k) {
    const std::string text = randomExpression(random, 2);
    const PathAutomaton automaton = automatonFor(PathExpression(text));
    const auto scattering = scatteringOf(automaton);
    ASSERT_TRUE(scattering) << text;
    std::size_t fewest = kLongest + 1, most = 0;
    for (const std::string& events : allEvents())
      if (letsThrough(automaton, events)) {
        fewest = std::min(fewest, events.size());
        most = std::max(most, events.size());
      }
    EXPECT_EQ(scattering->fewest, fewest) << text;
    const bool repeats = text.find_first_of("*+") != std::string::npos;
    if (repeats) {
      EXPECT_FALSE(scattering->most) << text;
      ++unbounded;
    } else {
      ASSERT_TRUE(scattering->most) << text;
      EXPECT_EQ(*scattering->most, most) << text;
      ++bounded;
    }
  }
  EXPECT_GT(bounded, 20);
  EXPECT_GT(unbounded, 20);
}

TEST(PathAutomaton, OfASceneHasOnlyPathsOfItsLobes) {
  const PathExpression caustics("LS+DE"), either("L(S|D)E");
  EXPECT_FALSE(scatteringOf(automatonFor(caustics, {.diffuse = true, .specular = false})));
  EXPECT_TRUE(automatonFor(either, {.diffuse = true, .specular = false}) ==
              automatonFor(PathExpression("LDE"), {.diffuse = true, .specular = false}));
  EXPECT_FALSE(automatonFor(either) == automatonFor(PathExpression("LDE")));
}

TEST(PathAutomaton, OfTooManyStatesIsRefused) {
  const auto refused = [](const std::string& text) {
    try {
      automatonFor(PathExpression(text));
      return false;
    } catch (const ExpressionError& e) {
      EXPECT_NE(std::string(e.what()).find("too intricate"), std::string::npos);
      return true;
    }
  };
  // From the eye on, each event may be the sixth before the light, or the sixtieth.
  EXPECT_FALSE(refused(fmt::format("L{}S.*E", std::string(5, '.'))));
  EXPECT_TRUE(refused(fmt::format("L{}S.*E", std::string(8, '.'))));
  EXPECT_TRUE(refused(fmt::format("L{}S.*E", std::string(58, '.'))));
  // A long path is not intricate.
  EXPECT_FALSE(refused(fmt::format("L{}E", std::string(62, 'D'))));
}

TEST(PathAutomaton, WithStatesThatItDoesNotHaveIsNotPossible) {
  const PathAutomaton right = automatonFor(PathExpression("LS+DE"));
  EXPECT_TRUE(isPossible(right));
  EXPECT_TRUE(isPossible(PathAutomaton{}));
  PathAutomaton wrong = right;
  wrong.start = static_cast<PathAutomaton::State>(right.states);
  EXPECT_FALSE(isPossible(wrong));
  wrong = right;
  wrong.nodes[1].next[1] = static_cast<PathAutomaton::State>(right.states);
  EXPECT_FALSE(isPossible(wrong));
  wrong = right;
  wrong.states = PathAutomaton::kMostStates + 1;
  EXPECT_FALSE(isPossible(wrong));
}

}  // namespace
}  // namespace pathmark::test
