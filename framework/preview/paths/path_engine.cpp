#include "preview/paths/path_engine.h"

#include "preview/paths/path_recording.h"

#include <utility>

namespace pathmark::preview {

PathEngine::PathEngine() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

PathEngine::~PathEngine() = default;

void PathEngine::ask(PathRequest request, std::function<void()> wake) {
  const std::scoped_lock lock(mutex_);
  wish_ = {wish_.number + 1, std::move(request)};
  wake_ = std::move(wake);
  changed_.notify_one();
}

void PathEngine::forget() {
  const std::scoped_lock lock(mutex_);
  wish_ = {wish_.number + 1};
  wake_ = nullptr;
  answer_.reset();
  changed_.notify_one();
}

std::shared_ptr<const PathAnswer> PathEngine::answer() const {
  const std::scoped_lock lock(mutex_);
  return answer_;
}

bool PathEngine::working() const {
  const std::scoped_lock lock(mutex_);
  return met_ != wish_.number;
}

bool PathEngine::await(const std::stop_token& stop, Wish& wish) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, stop, [&] { return met_ != wish_.number; });
  wish = wish_;
  return !stop.stop_requested();
}

void PathEngine::meet(const Wish& wish, std::shared_ptr<const PathAnswer> answer) {
  std::function<void()> wake;
  {
    const std::scoped_lock lock(mutex_);
    if (wish.number != wish_.number) return;
    met_ = wish.number;
    answer_ = std::move(answer);
    wake = wake_;
  }
  if (wake) wake();
}

void PathEngine::run(const std::stop_token& stop) {
  PathRecording recording;
  for (Wish wish; await(stop, wish);) {
    if (!wish.request) {
      recording.end();
      meet(wish, nullptr);
      continue;
    }
    const auto wanted = [&] {
      const std::scoped_lock lock(mutex_);
      return wish.number == wish_.number && !stop.stop_requested();
    };
    try {
      meet(wish, std::make_shared<const PathAnswer>(recording.record(*wish.request, wanted)));
    } catch (const Unwanted&) {  // the next wish is there already
    }
  }
}

}  // namespace pathmark::preview
