// Metronome: asks for frames, as long as it exists.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace pathmark::preview {

class Metronome {
 public:
  explicit Metronome(std::function<void()> wake)
      : thread_([wake = std::move(wake)](const std::stop_token& stop) {
          constexpr std::chrono::milliseconds kBeat{33};
          std::mutex mutex;
          std::condition_variable_any never;
          std::unique_lock lock(mutex);
          while (!stop.stop_requested()) {
            never.wait_for(lock, stop, kBeat, [] { return false; });
            wake();
          }
        }) {}

 private:
  std::jthread thread_;
};

}  // namespace pathmark::preview
