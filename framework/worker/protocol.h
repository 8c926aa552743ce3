// The wire between the host and a worker: messages over a socket, bulk data in shared memory.
//
// A worker says kHello when it has started, and then answers each request, in order, with a
// message of the same kind and sequence number. Bodies are the structs below, followed by raw
// arrays where noted. Descriptors travel with the message that needs them (SCM_RIGHTS).
//
//   kHello       -> Hello
//   kStubs       {} -> StubRecord[]
//   kLoadScene   LoadSceneRequest + descriptor of a packed scene, sealed -> LoadSceneReply
//   kRender      RenderRequest + descriptor of a film -> RenderResult, or nothing without a scene
//   kCall        CallRequest, object words, input words -> output words
//   kEstimate    EstimateRequest, input words -> Estimate[calls x replicates]
//   kRecordPixel RecordPixelRequest -> RecordPixelReply, RecordedRay[]
//   kRecordPaths RenderRequest for one thread + descriptor of a film -> RecordPathsReply,
//                PathEvent[]; nothing from a worker that does not record
#pragma once

#include "render/progress_board.h"
#include "render/render_job.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pathmark {

inline constexpr std::uint32_t kProtocolMagic = 0x31574d50;  // "PMW1"
inline constexpr std::uint32_t kProtocolVersion = 1;

// Descriptors that a worker starts with.
inline constexpr int kWorkerSocket = 3;
inline constexpr int kWorkerCrashPipe = 4;

// The argument of a worker that locks itself: see lock.h.
inline constexpr std::string_view kLockArgument = "--locked";

enum class MessageKind : std::uint32_t {
  kHello = 1,
  kStubs = 2,
  kLoadScene = 3,
  kRender = 4,
  kCall = 5,
  kEstimate = 6,
  kRecordPixel = 7,
  kRecordPaths = 8,
};

struct MessageHeader {
  std::uint32_t magic = kProtocolMagic;
  MessageKind kind = MessageKind::kHello;
  std::uint32_t sequence = 0;
  std::uint32_t reserved = 0;
  std::uint64_t length = 0;  // of the body, bytes
};

struct Hello {
  std::uint32_t version = kProtocolVersion;
  std::uint32_t reserved = 0;
};

struct LoadSceneRequest {
  std::uint64_t bytes = 0;    // of the block behind the descriptor
  std::uint32_t skips = ~0u;  // Skips; of renders only
  std::uint32_t reserved = 0;
};

struct LoadSceneReply {
  std::uint32_t understood = 0;
  std::uint32_t reserved = 0;
};

// The film's descriptor holds a ProgressBoard; then, from kFilmOffset, width x height FilmPixels;
// then one std::uint64_t for each tile of the image, row by row: see RenderJob::raysByTile.
inline constexpr std::size_t kFilmOffset = (sizeof(ProgressBoard) + 4095) / 4096 * 4096;

struct RenderRequest {
  RenderJob job;
  std::uint64_t bytes = 0;  // of the block behind the descriptor
};

struct CallRequest {
  std::uint32_t function = 0;  // CourseworkFunction
  std::uint32_t objectWords = 0;
  std::uint64_t count = 0;
};

// Means of an estimator over many rays, in independently randomised replicates. A call has the
// words of contract.h without the seed; those of paths have the largest number of bounces after
// their ray. Replicate r of call c is in place c x replicates + r of the answer.
struct EstimateRequest {
  std::uint32_t function = 0;  // CourseworkFunction: directLighting, tracePath, tracePathMIS
  SamplerKind sampler = SamplerKind::kSobol;
  std::uint64_t seed = 0;
  std::uint32_t replicates = 1;
  std::uint32_t calls = 0;
  std::uint64_t rays = 1;  // of one replicate of one call
};

struct Estimate {
  double mean[3] = {0.0, 0.0, 0.0};  // radiance; of the valid values, NaN without any
  std::uint64_t invalid = 0;         // values that are not finite, or negative
};

// What numbers renderPixel is given: independent ones in [0,1), or one number again and again.
enum class RecordedNumbers : std::uint32_t { kRandom = 0, kConstant = 1 };

struct RecordPixelRequest {
  float camera[12] = {};  // eye, topLeft, pixelRight, pixelDown
  std::int32_t width = 1, height = 1;
  std::int32_t i = 0, j = 0, rays = 1;
  RecordedNumbers numbers = RecordedNumbers::kRandom;
  float constant = 0.0f;
  std::uint32_t reserved = 0;
  std::uint64_t seed = 0;
};

struct RecordPixelReply {
  float mean[3] = {};              // what renderPixel returned
  std::uint32_t started = 0;       // calls of startRay
  std::uint32_t strayNumbers = 0;  // taken before any startRay
  std::uint32_t traced = 0;        // calls of tracePath; those beyond the list are only counted
};

struct RecordedRay {
  float origin[3] = {}, direction[3] = {};
  std::int32_t startRay = -1;       // argument of the startRay before it
  std::uint32_t startedBefore = 0;  // calls of startRay before it
  std::uint32_t numbers = 0;        // taken since the last startRay
};

struct RecordPathsReply {
  RenderResult result;
  std::uint64_t paths = 0;  // that have begun; those for which there is no room are only counted
};

// Rays that are recorded beyond those that were asked for.
inline constexpr std::uint32_t kExtraRecordedRays = 16;

// Written to the crash pipe in one piece by a worker that dies, or that is asked by SIGUSR1 where
// it is.
enum class CrashKind : std::uint32_t {
  kSignal = 1,
  kStackOverflow = 2,
  kException = 3,
  kWhereabouts = 4,
  kExit = 5,           // coursework called exit()
  kForbiddenCall = 6,  // of the operating system, refused by a sandbox
};

struct CrashRecord {
  static constexpr std::uint32_t kMagic = 0x48535243;  // "CRSH"
  static constexpr std::size_t kMaxFrames = 64;

  std::uint32_t magic = kMagic;
  CrashKind kind = CrashKind::kSignal;
  std::int32_t signal = 0;
  std::uint32_t frameCount = 0;
  std::int32_t systemCall = 0;  // number of the forbidden call
  std::int32_t reserved = 0;
  char text[256] = {};  // what an exception says, or the path that a forbidden call names
  // Return addresses, innermost first, relative to where the program was loaded.
  std::uint64_t frames[kMaxFrames] = {};
};

static_assert(sizeof(CrashRecord) <= 4096);  // PIPE_BUF: writes of this size are atomic

}  // namespace pathmark
