#include "host/checkpoint_keeper.h"

#include "film/image.h"
#include "host/session.h"

#include <fmt/format.h>

#include <cstdio>
#include <system_error>
#include <utility>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// The first of FILE.old, FILE.old2, ... that is not there.
fs::path freeName(const fs::path& file) {
  for (int k = 1;; ++k) {
    fs::path name = file.string() + (k == 1 ? ".old" : fmt::format(".old{}", k));
    std::error_code error;
    if (!fs::exists(fs::symlink_status(name, error))) return name;
  }
}

// A checkpoint with less than this share of the picture's rays lacks some that one would miss.
constexpr double kClearlyFewer = 0.95;

double raysPerPixelOf(const CheckpointIdentity& identity, const RenderState& state) {
  return static_cast<double>(raysMade(identity.settings, state)) /
         static_cast<double>(identity.settings.pixels());
}

std::string raysOf(const CheckpointIdentity& identity, const RenderState& state) {
  return fmt::format("{:.{}f}", raysPerPixelOf(identity, state), state.row > 0 ? 1 : 0);
}

fs::path checkpointOf(const fs::path& picture) { return picture.string() + ".checkpoint"; }

bool isThere(const fs::path& checkpoint) {
  std::error_code error;
  const fs::file_status status = fs::status(checkpoint, error);
  if (status.type() == fs::file_type::none)
    throw UsageError(fmt::format("{}: the picture's checkpoint cannot be there ({}).",
                                 checkpoint.string(), error.message()));
  return fs::exists(status);
}

}  // namespace

void requirePlaceForCheckpoint(const fs::path& picture) { isThere(checkpointOf(picture)); }

CheckpointKeeper::CheckpointKeeper(const fs::path& picture, CheckpointIdentity identity,
                                   const CheckpointOptions& options)
    : file_(checkpointOf(picture)), identity_(std::move(identity)), options_(options) {}

RenderState CheckpointKeeper::begin() {
  written_ = Clock::now();
  const bool isHopeless = options_.resumeOnlyIfPossible && isThere(file_) && !readHeader().empty();
  if (!options_.resume || isHopeless) {
    look();
    return {};
  }
  if (!isThere(file_)) {
    fmt::print(stderr, "There is no {}: the render starts from the beginning.\n", file_.string());
    return {};
  }
  RenderState state = readOrRefuse();
  fmt::print(stderr, "Going on from {}, with {} of {} rays per pixel.\n", file_.string(),
             raysOf(identity_, state), identity_.settings.raysPerPixel);
  ours_ = true;
  return state;
}

RenderState CheckpointKeeper::readOrRefuse() {
  std::string why;
  try {
    Checkpoint checkpoint = readCheckpoint(file_);
    why = whyNotContinued(checkpoint, identity_);
    if (why.empty()) return std::move(checkpoint.state);
  } catch (const CheckpointError& e) {
    why = e.what();
  }
  throw UsageError(
      fmt::format("--resume cannot go on from {}: {}. Nothing was changed; without --resume the "
                  "render starts afresh, and keeps that file under another name.",
                  file_.string(), why));
}

// Returns why this render cannot go on from it; nothing if it can.
std::string CheckpointKeeper::readHeader() {
  try {
    Checkpoint checkpoint = readCheckpointHeader(file_);
    earlier_ = std::move(checkpoint.state);
    return whyNotContinued(checkpoint, identity_);
  } catch (const CheckpointError& e) {
    return e.what();
  }
}

// A render that does not go on from what is there.
void CheckpointKeeper::look() {
  if (!isThere(file_)) return;
  const std::string why = readHeader();
  found_ = why.empty() ? Found::kEarlier : Found::kForeign;
  if (found_ == Found::kEarlier)
    fmt::print(stderr,
               "{} has {} rays per pixel of this picture: --resume would go on from there. It is "
               "kept until this render has as many.\n",
               file_.string(), raysOf(identity_, earlier_));
  else
    fmt::print(stderr,
               "{} is not of this render: {}. It is kept, under another name if this render has to "
               "write its own.\n",
               file_.string(), why);
}

std::string CheckpointKeeper::afterStep(const RenderState& state) {
  const double seconds = std::chrono::duration<double>(Clock::now() - written_).count();
  if (!(options_.everySeconds > 0.0) || seconds < options_.everySeconds) return {};
  // At the end there is a picture instead.
  if (finished(identity_.settings, state)) return {};
  written_ = Clock::now();
  try {
    return write(state);
  } catch (const std::exception& e) {
    if (std::exchange(warned_, true)) return {};
    return fmt::format("{} The render goes on without a checkpoint.\n", e.what());
  }
}

std::string CheckpointKeeper::onInterrupt(const RenderState& state, double raysPerPixel) {
  if (options_.everySeconds <= 0.0 || !state.begun()) return {};
  try {
    const std::string note = write(state);
    // What is there from an earlier run is kept where it has more.
    const RenderState& kept = ours_ ? state : earlier_;
    const bool fewer = raysPerPixelOf(identity_, kept) < kClearlyFewer * raysPerPixel;
    return fmt::format(
        "{}To go on from {}, which has {} of {} rays per pixel{}: the same command with "
        "--resume.\n",
        note, file_.string(), raysOf(identity_, kept), identity_.settings.raysPerPixel,
        fewer ? ", fewer than the picture, since it keeps whole steps only" : "");
  } catch (const std::exception& e) {
    return fmt::format("{}\n{}", e.what(), rescue(state));
  }
}

std::string CheckpointKeeper::onFinish(const RenderState& state) {
  const bool superseded = ours_ || (found_ == Found::kEarlier && holds(state, earlier_));
  if (!options_.keep) {
    std::error_code error;
    if (superseded) fs::remove(file_, error);
    return error ? fmt::format("{} cannot be removed: {}.\n", file_.string(), error.message()) : "";
  }
  try {
    const std::string note = write(state);
    return fmt::format("{}{}\n", note, howToRefine(identity_.settings));
  } catch (const std::exception& e) {
    return fmt::format("{}\n", e.what());
  }
}

// Beside the picture if that is possible, else where temporary files are.
std::string CheckpointKeeper::rescue(const RenderState& state) const {
  if (!state.begun()) return {};
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error) / file_.filename();
  for (const fs::path& place : {file_, temporary}) {
    try {
      const bool taken = !(ours_ && place == file_) && fs::exists(fs::symlink_status(place, error));
      const fs::path file = taken ? freeName(place) : place;
      writeCheckpoint(file, identity_, state);
      return fmt::format(
          "The work is in {}. As OUTPUT.checkpoint beside a picture that can be written, --resume "
          "makes that picture of it.\n",
          file.string());
    } catch (const std::exception&) {
      continue;
    }
  }
  return "The work could not be kept.\n";
}

std::string CheckpointKeeper::whatIsLeft() const {
  if (!ours_) return {};
  return fmt::format("{} has what was made before.\n", file_.string());
}

std::string CheckpointKeeper::write(const RenderState& state) {
  std::string note;
  if (!ours_ && found_ == Found::kEarlier && !holds(state, earlier_))
    return {};  // the one that is there has more
  if (!ours_ && found_ == Found::kForeign) note = setForeignAside();
  writeCheckpoint(file_, identity_, state);
  ours_ = true;
  warned_ = false;
  return note;
}

std::string CheckpointKeeper::setForeignAside() {
  const fs::path name = freeName(file_);
  // Also of a folder or a link: whatever it is, it is not this program's to replace.
  fs::rename(file_, name);
  found_ = Found::kNothing;
  return fmt::format("{} of another render is now {}.\n", file_.string(), name.string());
}

}  // namespace pathmark
