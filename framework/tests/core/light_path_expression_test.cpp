// The grammar of light path expressions, and what is said of mistakes.
#include "light_paths/error_text.h"
#include "light_paths/expression.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>

namespace pathmark::test {
namespace {

struct Mistake {
  const char* text;
  std::size_t position;
  const char* words;
};

std::optional<ExpressionError> errorOf(std::string_view text) {
  try {
    PathExpression{text};
    return std::nullopt;
  } catch (const ExpressionError& e) {
    return e;
  }
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreRefusedWhereTheyAre) {
  const auto& [text, position, words] = GetParam();
  const auto error = errorOf(text);
  ASSERT_TRUE(error) << text;
  EXPECT_EQ(error->position(), position) << text << ": " << error->what();
  EXPECT_NE(std::string(error->what()).find(words), std::string::npos) << error->what();
}

INSTANTIATE_TEST_SUITE_P(LightPathExpression, Mistakes,
                         testing::Values(Mistake{"", 0, "an expression is needed"},
                                         Mistake{"   ", 0, "an expression is needed"},
                                         Mistake{"L(S|D*E", 1, "this group is never closed"},
                                         Mistake{"L((S|D)*E", 1, "this group is never closed"},
                                         Mistake{"LS)E", 2, "this ) closes no group"},
                                         Mistake{"L()E", 2, "something is missing here"},
                                         Mistake{"L(S|)E", 4, "something is missing here"},
                                         Mistake{"L(|S)E", 2, "something is missing here"},
                                         Mistake{"LE|", 3, "something is missing here"},
                                         Mistake{"|LE", 0, "something is missing here"},
                                         Mistake{"*LE", 0, "nothing before this *"},
                                         Mistake{"L(+S)E", 2, "nothing before this +"},
                                         Mistake{"L(S|?D)E", 4, "nothing before this ?"},
                                         Mistake{"LdE", 1, "letters are capitals: D and not d"},
                                         Mistake{"l", 0, "letters are capitals: L and not l"},
                                         Mistake{"LGE", 1, "G is no part of an expression"},
                                         Mistake{"LD{2}E", 2, "{ is no part of an expression"},
                                         Mistake{"L\xc3\xa4"
                                                 "E",
                                                 1, "this character is no part"},
                                         Mistake{"EDL", 0, "written from the light to the eye"},
                                         Mistake{"DE", 0, "its L is missing"},
                                         Mistake{"LD", 2, "its E is missing"},
                                         Mistake{"D", 0, "its L is missing"},
                                         Mistake{"LDLE", 2, "no path can have this L"},
                                         Mistake{"LE(D|L)E", 1, "no path can have this E"},
                                         Mistake{"(L|E)DE", 3, "no path can have this E"},
                                         Mistake{"L(D|E|DD)E", 4, "no path can have this E"},
                                         Mistake{"LE|LD", 3, "no path can have this L"},
                                         Mistake{"DLE", 1, "no path can have this L"},
                                         Mistake{"LED*", 2, "no path can have this D"},
                                         Mistake{"LD|SE", 0, "no path can have this L"}));

TEST(LightPathExpression, EveryLetterOfALegalOneIsOfSomePath) {
  for (const char* text :
       {"LE", "L.*E", "L(S|D)*E", "LDE|LSE", "(L|LD)E", "L?DE|LE", "LD*?+E", "((L))((D)|(S))+(E)",
        "L D * E", "LE+", "L+E", "(LE)+", "(LE)*", "L(D*)*E", "L(D?S?)*E"})
    EXPECT_FALSE(errorOf(text)) << text << ": " << errorOf(text)->what();
}

TEST(LightPathExpression, SpacesMeanNothing) {
  EXPECT_EQ(PathExpression(" L ( S | D ) *\tE ").text(), "L(S|D)*E");
}

TEST(LightPathExpression, LengthAndNumberOfLettersHaveALimit) {
  const auto path = [](std::size_t letters) {
    return fmt::format("L{}E", std::string(letters, 'D'));
  };
  EXPECT_FALSE(errorOf(path(PathExpression::kMostLetters - 2)));
  const auto many = errorOf(path(PathExpression::kMostLetters - 1));
  ASSERT_TRUE(many);
  EXPECT_EQ(many->position(), PathExpression::kMostLetters);
  EXPECT_STREQ(many->what(), "an expression has at most 64 letters");
  EXPECT_FALSE(errorOf(fmt::format("LD{}E", std::string(PathExpression::kLongestText - 3, '*'))));
  EXPECT_TRUE(errorOf(fmt::format("LD{}E", std::string(PathExpression::kLongestText - 2, '*'))));
  EXPECT_TRUE(errorOf(std::string(1000000, '(')));
}

TEST(LightPathExpression, AnErrorIsASentenceWithACaretUnderTheCharacter) {
  const std::string text = "L\xc3\xa4*(E";
  const ExpressionError error(4, "this group is never closed");
  EXPECT_EQ(sentenceOf(text, error),
            "At character 4 of the expression: this group is never closed.");
  EXPECT_EQ(textWithCaret(text, error),
            fmt::format("this group is never closed.\n  {}\n     ^", text));
  EXPECT_EQ(sentenceOf("LD", ExpressionError(2, "its E is missing")),
            "At the end of the expression: its E is missing.");
  EXPECT_EQ(textWithCaret("a\033b", ExpressionError(0, "x")), "x.\n  a?b\n  ^");
}

}  // namespace
}  // namespace pathmark::test
