// Checkpoints: files that a render goes on from.
//
//   CheckpointIdentity    what a render must have in common with the one that wrote it
//   Checkpoint            identity, settings and state
//   writeCheckpoint, readCheckpoint
//   whyNotContinued       whether a render can go on from it to the same bits
//   howToRefine           what a complete picture can be refined with
#pragma once

#include "host/render_state.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace pathmark {

// A sentence without the file's name and without a full stop: what is wrong with it.
class CheckpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The settings but for the number of threads, which changes no bit.
struct CheckpointIdentity {
  std::string scene;       // content hash of the scene as a worker gets it
  std::string coursework;  // content hash of the worker program
  std::uint32_t maxBounces = 0;
  RenderSettings settings;
};

struct Checkpoint {
  CheckpointIdentity identity;
  RenderState state;
};

// As a whole, or not at all. Throws ImageError.
void writeCheckpoint(const std::filesystem::path& file, const CheckpointIdentity& identity,
                     const RenderState& state);

// Believes nothing: the file may be cut short, damaged, or no checkpoint at all. Throws
// CheckpointError.
Checkpoint readCheckpoint(const std::filesystem::path& file);

// Its beginning only: the state has no film. Throws CheckpointError.
Checkpoint readCheckpointHeader(const std::filesystem::path& file);

// Says how the render of the checkpoint differs from the wanted one, and where only the number of
// rays does, what could be asked for instead; empty if all rays that it has are rays of the wanted
// one too.
std::string whyNotContinued(const Checkpoint& checkpoint, const CheckpointIdentity& wanted);

// A sentence: the options that go on from the checkpoint of the complete picture, or why none do.
std::string howToRefine(const RenderSettings& made);

// Whether `a` has at least the rays of `b`; both are of the same render.
bool holds(const RenderState& a, const RenderState& b);

}  // namespace pathmark
