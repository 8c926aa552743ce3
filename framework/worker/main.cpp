// The worker: the only program that holds coursework. Answers the host's requests until the host
// closes the socket.
#include "render/render_tiles.h"
#include "render/scene_core.h"
#include "worker/call_table.h"
#include "worker/channel.h"
#include "worker/crash_handler.h"
#include "worker/estimate.h"
#include "worker/pixel_recorder.h"
#include "worker/protocol.h"
#include "worker/record_paths.h"

#include <pathmark/unimplemented.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

// The records of PATHMARK_UNIMPLEMENTED; the linker defines both names if there are any.
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier)
[[gnu::weak]] extern const pathmark::StubRecord __start_pathmark_stubs;
[[gnu::weak]] extern const pathmark::StubRecord __stop_pathmark_stubs;
// NOLINTEND(bugprone-reserved-identifier)
}

namespace pathmark {

namespace {

struct WorkerState {
  std::optional<SharedBlock> sceneBlock;
  std::unique_ptr<SceneCore> scene;          // for renders
  std::unique_ptr<SceneCore> sceneAnywhere;  // for calls with points of the host's choice
  FilmBlock film;
};

template <class Head, class T>
void sendReplyWithArray(const Message& request, const Head& head, const std::vector<T>& array) {
  std::vector<std::byte> bytes(sizeof head + array.size() * sizeof(T));
  std::memcpy(bytes.data(), &head, sizeof head);
  if (!array.empty())
    std::memcpy(bytes.data() + sizeof head, array.data(), array.size() * sizeof(T));
  sendReply(request, bytes);
}

void answerStubs(const Message& request) {
  const StubRecord* begin = &__start_pathmark_stubs;
  const StubRecord* end = &__stop_pathmark_stubs;
  sendReply(request, std::as_bytes(std::span(begin, end)));
}

void answerLoadScene(const Message& request, WorkerState& state) {
  LoadSceneReply reply;
  state.scene.reset();
  state.sceneAnywhere.reset();
  state.film.reset();
  if (const auto* body = request.as<LoadSceneRequest>()) {
    state.sceneBlock = SharedBlock::map(request.descriptor, body->bytes, false);
    if (state.sceneBlock) {
      if (const auto view = viewScene(state.sceneBlock->bytes())) {
        state.scene =
            std::make_unique<SceneCore>(*view, ShadowOrigins::kSurfaces, Skips(body->skips));
        reply.understood = 1;
      }
    }
  }
  sendReply(request, asBytes(reply));
}

// The memory of a request for a render.
class RenderMemory {
 public:
  // Nothing if it does not fit the scene.
  static std::optional<RenderMemory> map(const Message& request, const RenderRequest& body,
                                         WorkerState& state) {
    const SimpleCamera camera = cameraOf(*state.scene, body.job);
    const std::size_t pixels =
        static_cast<std::size_t>(camera.width()) * static_cast<std::size_t>(camera.height());
    const SharedBlock* const block = state.film.map(request.descriptor, body.bytes);
    const std::size_t tiles = tileCount(camera.width(), camera.height());
    if (!block || block->bytes().size() <
                      kFilmOffset + pixels * sizeof(FilmPixel) + tiles * sizeof(std::uint64_t))
      return std::nullopt;
    return RenderMemory(block->data(), pixels, tiles);
  }

  ProgressBoard& board() const { return *reinterpret_cast<ProgressBoard*>(memory_); }
  std::span<FilmPixel> film() const {
    return {reinterpret_cast<FilmPixel*>(memory_ + kFilmOffset), pixels_};
  }
  std::span<const std::uint64_t> tileRays() const {
    return {reinterpret_cast<const std::uint64_t*>(film().data() + pixels_), tiles_};
  }

 private:
  RenderMemory(std::byte* memory, std::size_t pixels, std::size_t tiles)
      : memory_(memory), pixels_(pixels), tiles_(tiles) {}

  std::byte* memory_;
  std::size_t pixels_, tiles_;
};

// A request that does not fit the scene gets an empty answer, which the host knows for what it is.
void answerRender(const Message& request, WorkerState& state) {
  const auto* body = request.as<RenderRequest>();
  if (!body || !state.scene || body->job.threads > kMaxThreads || !isPossible(body->job.paths))
    return sendReply(request, {});
  const auto memory = RenderMemory::map(request, *body, state);
  if (!memory) return sendReply(request, {});
  const RenderResult result = renderTiles(*state.scene, body->job, memory->film(), memory->board(),
                                          prepareThreadForCrashes, memory->tileRays());
  sendReply(request, asBytes(result));
}

void answerRecordPaths(const Message& request, WorkerState& state) {
  const auto* body = request.as<RenderRequest>();
  if (!recordPaths || !body || !state.scene || body->job.threads != 1 ||
      !isPossible(body->job.paths))
    return sendReply(request, {});
  const auto memory = RenderMemory::map(request, *body, state);
  if (!memory) return sendReply(request, {});
  const RecordedRender render = recordPaths(*state.scene, body->job, memory->film(),
                                            memory->board(), prepareThreadForCrashes);
  sendReplyWithArray(request, RecordPathsReply{render.result, render.paths}, render.events);
}

const SceneCore* sceneForCalls(WorkerState& state) {
  if (!state.sceneAnywhere && state.sceneBlock)
    if (const auto view = viewScene(state.sceneBlock->bytes()))
      state.sceneAnywhere = std::make_unique<SceneCore>(*view, ShadowOrigins::kAnywhere);
  return state.sceneAnywhere.get();
}

// The words after a request's own fields.
template <class Request>
std::span<const std::uint32_t> wordsAfter(const Message& request) {
  return {reinterpret_cast<const std::uint32_t*>(request.body.data() + sizeof(Request)),
          (request.body.size() - sizeof(Request)) / sizeof(std::uint32_t)};
}

void answerCall(const Message& request, WorkerState& state) {
  std::vector<std::uint32_t> outputs;
  const auto* body = request.as<CallRequest>();
  if (body && body->function < contract().size()) {
    const auto function = static_cast<CourseworkFunction>(body->function);
    const std::span words = wordsAfter<CallRequest>(request);
    const std::size_t inputs = body->count * contractOf(function).inputWords;
    if (words.size() == body->objectWords + inputs)
      outputs = callCoursework(
          {function, words.first(body->objectWords), words.subspan(body->objectWords), body->count},
          contractOf(function).needsScene ? sceneForCalls(state) : nullptr);
  }
  sendReply(request, std::as_bytes(std::span(outputs)));
}

void answerEstimate(const Message& request, WorkerState& state) {
  std::vector<Estimate> estimates;
  const auto* body = request.as<EstimateRequest>();
  const SceneCore* scene = sceneForCalls(state);
  if (body && scene) estimates = estimate(*body, wordsAfter<EstimateRequest>(request), *scene);
  sendReply(request, std::as_bytes(std::span(estimates)));
}

void answerRecordPixel(const Message& request, WorkerState& state) {
  const auto* body = request.as<RecordPixelRequest>();
  const SceneCore* scene = sceneForCalls(state);
  if (!body || !scene) return sendReply(request, {});
  const auto vector = [&](int at) {
    return vec3(body->camera[at], body->camera[at + 1], body->camera[at + 2]);
  };
  const SimpleCamera camera(vector(0), vector(3), vector(6), vector(9), body->width, body->height);
  PixelRecorder recorder(*body);
  const Colour mean = LitScene(*scene, scene->maxBounces())
                          .renderPixel(body->i, body->j, camera, body->rays, recorder);
  RecordPixelReply reply = recorder.counts();
  for (int c = 0; c < 3; ++c) reply.mean[c] = mean[c];
  sendReplyWithArray(request, reply, recorder.rays());
}

void serve() {
  WorkerState state;
  while (const std::optional<Message> request = receiveRequest()) {
    switch (request->header.kind) {
      case MessageKind::kStubs:
        answerStubs(*request);
        break;
      case MessageKind::kLoadScene:
        answerLoadScene(*request, state);
        break;
      case MessageKind::kRender:
        answerRender(*request, state);
        break;
      case MessageKind::kCall:
        answerCall(*request, state);
        break;
      case MessageKind::kEstimate:
        answerEstimate(*request, state);
        break;
      case MessageKind::kRecordPixel:
        answerRecordPixel(*request, state);
        break;
      case MessageKind::kRecordPaths:
        answerRecordPaths(*request, state);
        break;
      default:
        return;
    }
  }
}

}  // namespace

}  // namespace pathmark

int main() {
  // What coursework prints is seen when it is printed, also if it crashes next.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  pathmark::reportExits(pathmark::kMaxThreads);
  pathmark::sendHello();
  pathmark::serve();
  pathmark::finishWorker();
  return 0;
}
