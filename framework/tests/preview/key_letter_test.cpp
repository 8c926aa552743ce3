// Keys of letters on keyboards of several layouts.
#include "preview/key_letter.h"

#include <gtest/gtest.h>

namespace pathmark::preview::test {
namespace {

TEST(KeyLetter, IsTheOneOnTheKeyboard) {
  EXPECT_EQ(keyLetter('Q', "q"), 'Q');
  EXPECT_EQ(keyLetter('A', "q"), 'Q') << "French";
  EXPECT_EQ(keyLetter('Q', "a"), 'A') << "French";
  EXPECT_EQ(keyLetter('M', ","), '\0') << "French";
}

TEST(KeyLetter, OfALayoutWithoutLatinLettersIsTheAmericanOne) {
  EXPECT_EQ(keyLetter('Q', "\u0439"), 'Q') << "Russian";
  EXPECT_EQ(keyLetter('Q', nullptr), 'Q');
}

TEST(KeyLetter, OtherKeysHaveNone) {
  EXPECT_EQ(keyLetter('1', "1"), '\0');
  EXPECT_EQ(keyLetter(' ', nullptr), '\0');
  EXPECT_EQ(keyLetter(290, nullptr), '\0');
}

}  // namespace
}  // namespace pathmark::preview::test
