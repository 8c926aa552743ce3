// What is left of the compiler's words.
#include "host/compiler_words.h"

#include <gtest/gtest.h>

namespace pathmark {
namespace {

constexpr const char* kError =
    "a.cpp: In function ‘f’:\n"
    "a.cpp:7:13: error: no match for ‘operator/’ (operand types are ‘glm::vec<3, float>’ and "
    "‘double’)\n"
    "    7 |   return Kd / 3.14;\n";
constexpr const char* kCandidates =
    "In file included from /usr/include/glm/vec2.hpp:5,\n"
    "                 from /usr/include/glm/glm.hpp:116:\n"
    "/usr/include/glm/vec2.inl:597:55: note: candidate: ‘operator/(vec<2, T, Q>, T)’\n"
    "  597 | operator/\n"
    "/usr/include/glm/vec2.inl:597:55: note:   template argument deduction failed:\n"
    "a.cpp:7:15: note:   template argument ‘3’ does not match ‘2’\n"
    "    7 |   return Kd / 3.14;\n"
    "/usr/include/glm/vec2.inl:605:55: note: candidate: ‘operator/(T, vec<2, T, Q>)’\n";
constexpr const char* kHint =
    "  Colours and vectors are of float: a number such as 3.14 is a double, and 3.14f is none.\n";

TEST(CompilerWords, LeaveOutTheFunctionsOfLibrariesThatDoNotFit) {
  const std::string other = "a.cpp:9:1: error: expected ‘;’ before ‘}’ token\n";
  EXPECT_EQ(shortCompilerWords(kError + std::string(kCandidates) + other),
            kError + std::string("  (2 functions of libraries that do not fit either)\n") + kHint +
                other);
}

TEST(CompilerWords, SayWhereHelpersBelongInsteadOfAHeader) {
  const std::string lost =
      "part5_path.cpp:2:10: fatal error: helpers.h: No such file or directory\n"
      "    2 | #include \"helpers.h\"\n"
      "compilation terminated.\n";
  EXPECT_EQ(shortCompilerWords(lost),
            lost +
                "  A header of your own is not handed in: helpers stand in an unnamed namespace "
                "of each file that uses them.\n");
}

TEST(CompilerWords, KeepTheNotesOfOnesOwnFile) {
  const std::string own =
      "a.cpp:7:1: error: no matching function for call to ‘f(int)’\n"
      "a.cpp:3:6: note: candidate: ‘void f(const char*)’\n"
      "    3 | void f(const char*);\n";
  EXPECT_EQ(shortCompilerWords(own), own);
}

TEST(CompilerWords, KeepWhereAnErrorOfAHeaderWasIncluded) {
  const std::string header =
      "In file included from a.cpp:2:\n"
      "b.h:1:1: error: ‘x’ does not name a type\n";
  EXPECT_EQ(shortCompilerWords(header), header);
  EXPECT_EQ(shortCompilerWords(""), "");
}

}  // namespace
}  // namespace pathmark
