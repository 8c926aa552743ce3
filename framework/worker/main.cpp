// The worker: the only program that holds coursework. Answers the host's requests until the host
// closes the socket.
#include "render/render_tiles.h"
#include "render/scene_core.h"
#include "worker/call_table.h"
#include "worker/channel.h"
#include "worker/crash_handler.h"
#include "worker/protocol.h"

#include <pathmark/unimplemented.h>

#include <cstdio>
#include <memory>
#include <optional>

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
};

void answerStubs(const Message& request) {
  const StubRecord* begin = &__start_pathmark_stubs;
  const StubRecord* end = &__stop_pathmark_stubs;
  sendReply(request, std::as_bytes(std::span(begin, end)));
}

void answerLoadScene(const Message& request, WorkerState& state) {
  LoadSceneReply reply;
  state.scene.reset();
  state.sceneAnywhere.reset();
  if (const auto* body = request.as<LoadSceneRequest>()) {
    state.sceneBlock = SharedBlock::map(request.descriptor, body->bytes, false);
    if (state.sceneBlock) {
      if (const auto view = viewScene(state.sceneBlock->bytes())) {
        state.scene = std::make_unique<SceneCore>(*view, ShadowOrigins::kSurfaces);
        reply.understood = 1;
      }
    }
  }
  sendReply(request, asBytes(reply));
}

// A request that does not fit the scene gets an empty answer, which the host knows for what it is.
void answerRender(const Message& request, const WorkerState& state) {
  const auto* body = request.as<RenderRequest>();
  if (!body || !state.scene || body->job.threads > kMaxThreads) return sendReply(request, {});
  const SimpleCamera& camera = state.scene->camera();
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width()) * static_cast<std::size_t>(camera.height());
  const auto block = SharedBlock::map(request.descriptor, body->bytes, true);
  if (!block || block->bytes().size() < kFilmOffset + pixels * sizeof(FilmPixel))
    return sendReply(request, {});
  std::byte* memory = block->data();
  auto& board = *reinterpret_cast<ProgressBoard*>(memory);
  auto* film = reinterpret_cast<FilmPixel*>(memory + kFilmOffset);
  const RenderResult result =
      renderTiles(*state.scene, body->job, {film, pixels}, board, prepareThreadForCrashes);
  sendReply(request, asBytes(result));
}

const SceneCore* sceneForCalls(WorkerState& state) {
  if (!state.sceneAnywhere && state.sceneBlock)
    if (const auto view = viewScene(state.sceneBlock->bytes()))
      state.sceneAnywhere = std::make_unique<SceneCore>(*view, ShadowOrigins::kAnywhere);
  return state.sceneAnywhere.get();
}

void answerCall(const Message& request, WorkerState& state) {
  std::vector<std::uint32_t> outputs;
  const auto* body = request.as<CallRequest>();
  if (body && body->function < contract().size()) {
    const auto function = static_cast<CourseworkFunction>(body->function);
    const std::span words(
        reinterpret_cast<const std::uint32_t*>(request.body.data() + sizeof *body),
        (request.body.size() - sizeof *body) / sizeof(std::uint32_t));
    const std::size_t inputs = body->count * contractOf(function).inputWords;
    if (words.size() == body->objectWords + inputs)
      outputs = callCoursework(
          {function, words.first(body->objectWords), words.subspan(body->objectWords), body->count},
          contractOf(function).needsScene ? sceneForCalls(state) : nullptr);
  }
  sendReply(request, std::as_bytes(std::span(outputs)));
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
  pathmark::sendHello();
  pathmark::serve();
  pathmark::finishWorker();
  return 0;
}
