// PathEngine: records the paths of a pixel, on a thread of its own, with a worker of its own.
//
//   PathRequest   which paths
//   PathAnswer    what came of it; immutable
#pragma once

#include "preview/paths/path_account.h"
#include "preview/paths/path_record.h"
#include "preview/picture.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace pathmark::preview {

// The first rays of a pixel of a picture: those that a render with this seed makes.
struct PathRequest {
  std::shared_ptr<const PreviewScene> scene;
  FlatCamera camera;  // that sees the pixel
  std::shared_ptr<const CourseworkState> coursework;
  PartPicture made{};
  SamplerKind sampler = SamplerKind::kSobol;
  PathAutomaton automaton{};  // of the light that is let through
  std::uint64_t seed = 0;
  std::uint32_t raysPerPass = 64;
  std::uint32_t rays = 64;
  int column = 0, row = 0;
};

struct PathAnswer {
  PathRequest request;
  std::string failure;              // a sentence; then there are no paths
  std::vector<TracedPath> paths{};  // of the request's rays, in their order
  std::vector<PathAccount> accounts{};
  Colour mean{0.0f};            // of these paths
  Colour pixel{0.0f};           // what renderPixel returned, over `pixelRays`
  std::uint64_t pixelRays = 0;  // whole passes: no fewer than the request's rays
  std::string remark{};         // about what renderPixel made of the paths; may be empty
};

class PathEngine {
 public:
  PathEngine();
  ~PathEngine();
  PathEngine(const PathEngine&) = delete;
  PathEngine& operator=(const PathEngine&) = delete;

  // What was asked for before is given up. `wake` is called when there is an answer.
  void ask(PathRequest request, std::function<void()> wake);
  // Nothing is wanted any more: the worker is ended.
  void forget();

  // To what has been asked last, or before that; null if there is none.
  std::shared_ptr<const PathAnswer> answer() const;
  bool working() const;

 private:
  // A request, or with none that everything is to be forgotten.
  struct Wish {
    std::uint64_t number = 0;
    std::optional<PathRequest> request{};
  };

  void run(const std::stop_token& stop);
  bool await(const std::stop_token& stop, Wish& wish);
  void meet(const Wish& wish, std::shared_ptr<const PathAnswer> answer);

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  Wish wish_;              // the newest
  std::uint64_t met_ = 0;  // number of the wish that has been met
  std::function<void()> wake_;
  std::shared_ptr<const PathAnswer> answer_;
  std::jthread thread_;  // last, as it uses the others
};

}  // namespace pathmark::preview
