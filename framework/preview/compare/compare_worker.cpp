#include "preview/compare/compare_worker.h"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <utility>

namespace pathmark::preview {

using Clock = std::chrono::steady_clock;

CompareWorker::CompareWorker(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

CompareWorker::~CompareWorker() = default;

void CompareWorker::ask(CompareRequest request, bool urgent) {
  {
    const std::lock_guard lock(mutex_);
    request_ = std::move(request);
    urgent_ = urgent_ || urgent;
  }
  changed_.notify_all();
}

std::shared_ptr<const CompareResult> CompareWorker::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

void CompareWorker::rest(const std::stop_token& stop, Clock::duration worked) {
  constexpr int kRest = 9;  // times as long as the work
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, stop, kRest * worked, [this] { return urgent_; });
}

void CompareWorker::run(const std::stop_token& stop) {
  while (true) {
    CompareRequest request;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [this] { return request_.has_value(); })) return;
      request = *std::exchange(request_, std::nullopt);
      urgent_ = false;
    }
    const Clock::time_point began = Clock::now();
    std::shared_ptr<const CompareResult> result;
    try {
      result = session_.compare(request);
    } catch (const std::exception& e) {
      CompareResult failed{.picture = request.picture, .wish = request.wish.number};
      failed.view = request.view;
      failed.found.why = fmt::format("The pictures could not be compared: {}", e.what());
      result = std::make_shared<const CompareResult>(std::move(failed));
    }
    {
      const std::lock_guard lock(mutex_);
      newest_ = std::move(result);
    }
    wake_();
    rest(stop, Clock::now() - began);
  }
}

}  // namespace pathmark::preview
