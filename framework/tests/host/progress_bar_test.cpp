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

}  // namespace
}  // namespace pathmark
