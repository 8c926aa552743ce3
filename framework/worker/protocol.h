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
#pragma once

#include "render/progress_board.h"
#include "render/render_job.h"

#include <cstddef>
#include <cstdint>

namespace pathmark {

inline constexpr std::uint32_t kProtocolMagic = 0x31574d50;  // "PMW1"
inline constexpr std::uint32_t kProtocolVersion = 1;

// Descriptors that a worker starts with.
inline constexpr int kWorkerSocket = 3;
inline constexpr int kWorkerCrashPipe = 4;

enum class MessageKind : std::uint32_t {
  kHello = 1,
  kStubs = 2,
  kLoadScene = 3,
  kRender = 4,
  kCall = 5,
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
  std::uint64_t bytes = 0;  // of the block behind the descriptor
};

struct LoadSceneReply {
  std::uint32_t understood = 0;
  std::uint32_t reserved = 0;
};

// The film's descriptor holds a ProgressBoard and then, from kFilmOffset, width x height
// FilmPixels.
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

// Written to the crash pipe in one piece by a worker that dies, or that is asked by SIGUSR1 where
// it is.
enum class CrashKind : std::uint32_t {
  kSignal = 1,
  kStackOverflow = 2,
  kException = 3,
  kWhereabouts = 4,
  kExit = 5,  // coursework called exit()
};

struct CrashRecord {
  static constexpr std::uint32_t kMagic = 0x48535243;  // "CRSH"
  static constexpr std::size_t kMaxFrames = 64;

  std::uint32_t magic = kMagic;
  CrashKind kind = CrashKind::kSignal;
  std::int32_t signal = 0;
  std::uint32_t frameCount = 0;
  char text[256] = {};  // what an exception says
  // Return addresses, innermost first, relative to where the program was loaded.
  std::uint64_t frames[kMaxFrames] = {};
};

static_assert(sizeof(CrashRecord) <= 4096);  // PIPE_BUF: writes of this size are atomic

}  // namespace pathmark
