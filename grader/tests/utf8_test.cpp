// Text in UTF-8: the one place where it is decoded, and what is said of a byte that is none.
#include "scene/utf8.h"
#include "scene/syntax_sentence.h"

#include <gtest/gtest.h>

#include <string>

namespace pathmark {
namespace {

TEST(Utf8, HasCharactersOfOneToFourBytes) {
  for (const auto& [text, code] : {std::pair{"a", U'a'},
                                   {"\u00e9", U'\u00e9'},
                                   {"\u5c71", U'\u5c71'},
                                   {"\U0001d538", U'\U0001d538'}}) {
    EXPECT_EQ(firstCharacter(text).code, code);
    EXPECT_EQ(firstCharacter(text).bytes, std::string(text).size());
  }
}

// No character: a byte alone, an overlong slash, a surrogate, one beyond U+10FFFF, one cut off.
const char* const kNoCharacters[] = {"\xfc", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                                     "\xe2\x82"};

TEST(Utf8, HasNoOtherCharacters) {
  for (const char* bytes : kNoCharacters) EXPECT_EQ(firstCharacter(bytes).bytes, 0u);
}

std::string sentenceAbout(const std::string& character) {
  const std::string text = "{\"a\": " + character + "}";
  return syntaxSentence(text, text.find(character) + 1, "invalid literal; last read: ");
}

TEST(SyntaxSentence, NamesACharacterOfAnotherScript) {
  EXPECT_NE(sentenceAbout("\u5c71").find("(U+5C71)"), std::string::npos) << sentenceAbout("\u5c71");
}

TEST(SyntaxSentence, CallsNothingACharacterThatUtf8DoesNotHave) {
  for (const char* bytes : kNoCharacters) {
    const std::string sentence = sentenceAbout(bytes);
    EXPECT_NE(sentence.find("found a byte that is no UTF-8 text"), std::string::npos) << sentence;
  }
}

TEST(Utf8, IsBlankWhereNothingIsSeen) {
  for (const char* text : {"", " \t\r\n", "\u00A0", "\u3000 \u200B\uFEFF", "\x7F"})
    EXPECT_TRUE(isBlank(text)) << text;
  for (const char* text : {"a", " . ", "\u00A0\u00E9", "\u7A7A", "\u2014"})
    EXPECT_FALSE(isBlank(text)) << text;
}

}  // namespace
}  // namespace pathmark
