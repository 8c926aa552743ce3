// CompareWorker: a CompareSession on a thread of its own. The newest request wins.
#pragma once

#include "preview/compare/compare_session.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace pathmark::preview {

class CompareWorker {
 public:
  // `wake` is called from the worker's thread when there is a new result.
  explicit CompareWorker(std::function<void()> wake);
  ~CompareWorker();
  CompareWorker(const CompareWorker&) = delete;
  CompareWorker& operator=(const CompareWorker&) = delete;

  // A request that is not `urgent` waits until the thread has rested: comparing takes a tenth of a
  // processor at most, the rest is for rendering.
  void ask(CompareRequest request, bool urgent);

  // Null before the first.
  std::shared_ptr<const CompareResult> newest() const;

 private:
  void run(const std::stop_token& stop);
  void rest(const std::stop_token& stop, std::chrono::steady_clock::duration worked);

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<CompareRequest> request_;
  bool urgent_ = false;
  std::shared_ptr<const CompareResult> newest_;
  CompareSession session_;
  std::jthread thread_;  // last: it uses what is above
};

}  // namespace pathmark::preview
