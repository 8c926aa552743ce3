// The feed of check results, with a checker that does what the test says.
#include "preview/check_feed.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <vector>

namespace pathmark::preview {
namespace {

using F = CourseworkFunction;
using Numbers = std::vector<std::uint64_t>;

std::shared_ptr<const CourseworkState> coursework(std::uint64_t number) {
  CourseworkState state;
  state.build = std::make_shared<const CourseworkBuild>();
  state.number = number;
  return std::make_shared<const CourseworkState>(std::move(state));
}

std::shared_ptr<const CheckReport> reportOf(std::uint64_t build, F function, Outcome outcome) {
  CheckReport report;
  report.build = build;
  for (const FunctionContract& f : contract())
    report.functions.push_back({f.function, Outcome::kUnknown, {}, {}, 0});
  report.functions[static_cast<std::size_t>(function)] = {function, outcome, {}, {}, build};
  return std::make_shared<const CheckReport>(std::move(report));
}

// What the checker and the test tell one another.
class Desk {
 public:
  void begun(std::uint64_t number) {
    change([&] { begun_.push_back(number); });
  }
  void woken() {
    change([&] { ++wakes_; });
  }
  Numbers waitUntilBegun(std::uint64_t number) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !begun_.empty() && begun_.back() == number; });
    return begun_;
  }
  void waitForWakes(int count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return wakes_ >= count; });
  }
  int wakes() {
    const std::lock_guard lock(mutex_);
    return wakes_;
  }

 private:
  template <class Change>
  void change(const Change& make) {
    {
      const std::lock_guard lock(mutex_);
      make();
    }
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  Numbers begun_;
  int wakes_ = 0;
};

using OnReport = std::function<void(std::shared_ptr<const CheckReport>)>;
using Work = std::function<void(std::uint64_t number, std::stop_token stop, const OnReport&)>;

class FakeChecker : public Checker {
 public:
  FakeChecker(Desk& desk, Work work) : desk_(desk), work_(std::move(work)) {}

  void check(const CourseworkBuild&, std::uint64_t number, std::stop_token stop,
             const OnReport& onReport) override {
    desk_.begun(number);
    work_(number, std::move(stop), onReport);
  }
  std::vector<std::string> hints(F) override { return {"a nudge"}; }

 private:
  Desk& desk_;
  Work work_;
};

std::unique_ptr<CheckFeed> makeFeed(Desk& desk, Work work) {
  return std::make_unique<CheckFeed>(std::make_unique<FakeChecker>(desk, std::move(work)),
                                     [&desk] { desk.woken(); });
}

void waitForStop(std::stop_token stop) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  never.wait(lock, std::move(stop), [] { return false; });
}

TEST(CheckFeed, TellsWhatTheCheckerSaysAndWakesTheWindow) {
  Desk desk;
  const auto feed = makeFeed(desk, [](std::uint64_t number, std::stop_token, const OnReport& on) {
    on(reportOf(number, F::kPhongPdf, Outcome::kFail));
  });
  EXPECT_EQ(feed->report(), nullptr);
  feed->submit(coursework(1));
  desk.waitForWakes(1);
  ASSERT_NE(feed->report(), nullptr);
  EXPECT_EQ(feed->report()->build, 1u);
  EXPECT_EQ(feed->report()->find(F::kPhongPdf)->outcome, Outcome::kFail);
}

TEST(CheckFeed, ANewerCourseworkEndsTheCheckOfAnOlder) {
  Desk desk;
  const auto feed =
      makeFeed(desk, [](std::uint64_t number, std::stop_token stop, const OnReport& on) {
        if (number == 1) waitForStop(stop);
        on(reportOf(number, F::kPhongPdf, Outcome::kPass));
      });
  feed->submit(coursework(1));
  desk.waitUntilBegun(1);
  feed->submit(coursework(2));
  desk.waitForWakes(1);
  EXPECT_EQ(feed->report()->build, 2u) << "the older check had been stopped when it reported";
  EXPECT_EQ(desk.wakes(), 1);
}

TEST(CheckFeed, OfThoseThatWaitOnlyTheNewestIsChecked) {
  Desk desk;
  std::mutex held;
  std::unique_lock hold(held);
  const auto feed = makeFeed(desk, [&](std::uint64_t number, std::stop_token, const OnReport&) {
    if (number == 1) const std::lock_guard wait(held);
  });
  feed->submit(coursework(1));
  desk.waitUntilBegun(1);
  for (const std::uint64_t number : {2u, 3u, 4u}) feed->submit(coursework(number));
  hold.unlock();
  EXPECT_EQ(desk.waitUntilBegun(4), (Numbers{1, 4}));
}

TEST(CheckFeed, TheSameCourseworkIsCheckedOnceAndOneWithoutABuildNever) {
  Desk desk;
  const auto feed = makeFeed(desk, [](std::uint64_t number, std::stop_token, const OnReport& on) {
    on(reportOf(number, F::kPhongPdf, Outcome::kPass));
  });
  feed->submit(nullptr);
  feed->submit(std::make_shared<const CourseworkState>());
  feed->submit(coursework(1));
  desk.waitForWakes(1);
  feed->submit(coursework(1));
  feed->submit(coursework(2));
  EXPECT_EQ(desk.waitUntilBegun(2), (Numbers{1, 2}));
}

TEST(CheckFeed, TheReportOfTheBuildBeforeStaysUntilThereIsANewerOne) {
  Desk desk;
  const auto feed =
      makeFeed(desk, [](std::uint64_t number, std::stop_token stop, const OnReport& on) {
        if (number == 2) waitForStop(stop);
        on(reportOf(number, F::kTracePath, Outcome::kPass));
      });
  feed->submit(coursework(1));
  desk.waitForWakes(1);
  feed->submit(coursework(2));
  desk.waitUntilBegun(2);
  EXPECT_EQ(feed->report()->build, 1u);
  feed->submit(coursework(3));
  desk.waitForWakes(2);
  EXPECT_EQ(feed->report()->build, 3u);
}

TEST(CheckFeed, EndsInTheMiddleOfACheck) {
  Desk desk;
  auto feed = makeFeed(desk, [](std::uint64_t, std::stop_token stop, const OnReport&) {
    waitForStop(std::move(stop));
  });
  feed->submit(coursework(1));
  desk.waitUntilBegun(1);
  feed.reset();
  EXPECT_EQ(desk.wakes(), 0);
}

}  // namespace
}  // namespace pathmark::preview
