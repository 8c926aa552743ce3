#include "preview/check_feed.h"

#include <utility>

namespace pathmark::preview {

CheckFeed::CheckFeed(std::unique_ptr<Checker> checker, std::function<void()> wake)
    : checker_(std::move(checker)),
      wake_(std::move(wake)),
      thread_([this](std::stop_token stop) { run(std::move(stop)); }) {}

CheckFeed::~CheckFeed() {
  thread_.request_stop();
  const std::lock_guard lock(mutex_);
  check_.request_stop();
}

void CheckFeed::submit(std::shared_ptr<const CourseworkState> state) {
  if (!state || !state->build) return;
  {
    const std::lock_guard lock(mutex_);
    if (state->number == lastNumber_) return;
    lastNumber_ = state->number;
    waiting_ = std::move(state);
    check_.request_stop();
  }
  submitted_.notify_one();
}

std::shared_ptr<const CheckReport> CheckFeed::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

void CheckFeed::run(std::stop_token stop) {
  while (true) {
    std::shared_ptr<const CourseworkState> state;
    std::stop_token ofCheck;
    {
      std::unique_lock lock(mutex_);
      if (!submitted_.wait(lock, stop, [&] { return waiting_ != nullptr; })) return;
      // After this, the destructor finds the check that it must stop.
      if (stop.stop_requested()) return;
      state = std::exchange(waiting_, nullptr);
      check_ = std::stop_source();
      ofCheck = check_.get_token();
    }
    checker_->check(*state->build, state->number, ofCheck,
                    [&](std::shared_ptr<const CheckReport> r) { take(std::move(r), ofCheck); });
  }
}

void CheckFeed::take(std::shared_ptr<const CheckReport> report, const std::stop_token& stop) {
  {
    const std::lock_guard lock(mutex_);
    if (stop.stop_requested()) return;
    report_ = std::move(report);
  }
  wake_();
}

}  // namespace pathmark::preview
