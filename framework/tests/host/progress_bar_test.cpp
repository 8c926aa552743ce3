#include "host/progress_bar.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace pathmark {
namespace {

using namespace std::chrono_literals;

// Standard error is a file meanwhile.
std::string shownInALog(ProgressBar::Clock::duration betweenLines) {
  testing::internal::CaptureStderr();
  {
    ProgressBar bar("grade", betweenLines);
    bar.show(0.25, "alice, part 3");
    bar.show(0.5, "");
    bar.show(1.1, "bob");
  }
  return testing::internal::GetCapturedStderr();
}

TEST(ProgressBar, InALogHasLinesOfItsOwn) {
  EXPECT_EQ(shownInALog(0s), "grade: 25%, alice, part 3\ngrade: 50%\ngrade: 100%, bob\n");
}

TEST(ProgressBar, InALogIsSilentUntilAMinuteHasPassed) { EXPECT_EQ(shownInALog(1min), ""); }

TEST(ProgressBar, OfAnotherCommandIsReadFromItsLog) {
  const auto read = lastProgressIn("a table: 7%x\n" + shownInALog(0s) + "warning: 3 of 4\n");
  ASSERT_TRUE(read);
  EXPECT_DOUBLE_EQ(read->fraction, 1.0);
  EXPECT_EQ(read->what, "bob");
}

TEST(ProgressBar, IsNotReadFromOtherLines) {
  EXPECT_FALSE(lastProgressIn(""));
  EXPECT_FALSE(lastProgressIn("s1: off by 0.2 %\nmean: -3%\nnoise: 400%\n50%: x\nno: %\n"));
}

}  // namespace
}  // namespace pathmark
