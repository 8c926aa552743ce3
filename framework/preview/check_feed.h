// CheckFeed: the newest results of the checks, made on a thread of their own.
//
//   submit   a coursework that is to be checked; the newest wins
//   report   what is known; of an older coursework until there is something newer
#pragma once

#include "preview/checker.h"
#include "preview/picture.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace pathmark::preview {

class CheckFeed {
 public:
  // `wake` is called from the feed's thread whenever there is a new report.
  CheckFeed(std::unique_ptr<Checker> checker, std::function<void()> wake);
  ~CheckFeed();
  CheckFeed(const CheckFeed&) = delete;
  CheckFeed& operator=(const CheckFeed&) = delete;

  // Ends the check of an older coursework. One without a build, or with the number of the last
  // one, changes nothing: it may be submitted once a frame.
  void submit(std::shared_ptr<const CourseworkState> state);

  // Null before the first; of an older coursework, by its number, until the check of the newest has
  // something to tell.
  std::shared_ptr<const CheckReport> report() const;

  std::vector<std::string> hints(CourseworkFunction function) { return checker_->hints(function); }

 private:
  void run(std::stop_token stop);
  void take(std::shared_ptr<const CheckReport> report, const std::stop_token& stop);

  std::unique_ptr<Checker> checker_;
  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable_any submitted_;
  std::shared_ptr<const CourseworkState> waiting_;  // null while there is nothing new
  std::uint64_t lastNumber_ = 0;
  std::stop_source check_{std::nostopstate};  // of the check that is being made
  std::shared_ptr<const CheckReport> report_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace pathmark::preview
