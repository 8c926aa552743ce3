// CheckpointKeeper: the checkpoint beside one picture, over one run of the program.
//
// What an older run has left there is never lost: it is replaced by a checkpoint that holds all of
// its rays, or else renamed.
#pragma once

#include "host/checkpoint.h"

#include <chrono>
#include <filesystem>
#include <string>

namespace pathmark {

struct CheckpointOptions {
  bool resume = false;
  bool resumeOnlyIfPossible = false;  // and else start afresh, which is no error
  bool keep = false;                  // also when the picture is complete
  double everySeconds = 60.0;         // 0: no checkpoints
};

// Throws UsageError where no file can have the name of the picture's checkpoint, which is longer
// than that of the picture.
void requirePlaceForCheckpoint(const std::filesystem::path& picture);

class CheckpointKeeper {
 public:
  CheckpointKeeper(const std::filesystem::path& picture, CheckpointIdentity identity,
                   const CheckpointOptions& options);

  // What to go on from, if that is wished and there is something. Says on standard error what was
  // found. Throws UsageError for a checkpoint that belongs to something else.
  RenderState begin();

  // Writes if it is time. Returns a line to show, or nothing.
  std::string afterStep(const RenderState& state);

  // The picture is there, and has all of its rays or these. Returns lines to show.
  std::string onInterrupt(const RenderState& state, double raysPerPixel);
  std::string onFinish(const RenderState& state);

  // The picture or its checkpoint could not be written: keeps the work wherever that is possible.
  // Returns lines to show.
  std::string rescue(const RenderState& state) const;

  // Where the work is if the render has failed; nothing if there is none.
  std::string whatIsLeft() const;

  const std::filesystem::path& file() const { return file_; }

 private:
  using Clock = std::chrono::steady_clock;
  enum class Found {
    kNothing,  // or what this run has written
    kEarlier,  // part of this render
    kForeign,  // of another one, or unreadable
  };

  std::string readHeader();
  void look();
  RenderState readOrRefuse();
  std::string write(const RenderState& state);
  std::string setForeignAside();

  std::filesystem::path file_;
  CheckpointIdentity identity_;
  CheckpointOptions options_;
  Found found_ = Found::kNothing;
  RenderState earlier_;  // without its film
  bool ours_ = false;    // the file there is this run's
  bool warned_ = false;  // that it cannot be written
  Clock::time_point written_ = Clock::now();
};

}  // namespace pathmark
