#include "preview/samples/sample_engine.h"

#include "host/display_path.h"
#include "host/stub_report.h"
#include "host/where_to_look.h"
#include "preview/samples/sample_draw.h"

#include <fmt/format.h>

#include <array>
#include <exception>
#include <utility>

namespace pathmark::preview {

namespace {

using F = CourseworkFunction;

// What a function of the same part is likely to call.
constexpr std::array<std::pair<F, F>, 4> kLikelyCalls{
    {{F::kSampleHemisphere, F::kSampleSphere},
     {F::kSphereSample, F::kSpherePdf},
     {F::kLambertianReflection, F::kLambertianPdf},
     {F::kPhongReflection, F::kPhongPdf}}};

std::string notWritten(const FunctionContract& f) {
  return fmt::format("{} is not written yet: see {}, section {}.", f.name,
                     handoutOf(partNumbered(f.part)), f.section);
}

std::string noteAbout(F function, const StubReport& stubs) {
  for (const auto& [caller, called] : kLikelyCalls)
    if (caller == function && stubs.isUnwritten(called))
      return fmt::format("{} is not written yet: if {} calls it, these are not its samples.",
                         contractOf(called).name, contractOf(function).name);
  return {};
}

}  // namespace

// The worker that is running, and what it was made from.
struct SampleEngine::Session {
  std::uint64_t build = 0;
  int part = -1;
  std::string failure;  // why there is no worker
  std::unique_ptr<WorkerProcess> worker;
  StubReport stubs;
};

SampleEngine::SampleEngine(std::function<void()> wake, const WorkerLimits& limits)
    : wake_(std::move(wake)),
      limits_(limits),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

SampleEngine::~SampleEngine() {
  const std::lock_guard lock(mutex_);
  otherBuild_.request_stop();
  thread_.request_stop();
}

void SampleEngine::show(const std::shared_ptr<const CourseworkState>& coursework,
                        const SampleSettings& settings) {
  const std::lock_guard lock(mutex_);
  if (lastSettings_ == settings && lastBuild_ == coursework->number) return;
  if (lastBuild_ != coursework->number) {
    otherBuild_.request_stop();
    otherBuild_ = std::stop_source();
  }
  lastBuild_ = coursework->number;
  lastSettings_ = settings;
  waiting_ = Request{coursework, settings, otherBuild_.get_token()};
  changed_.notify_all();
}

std::shared_ptr<const SampleAnswer> SampleEngine::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

void SampleEngine::run(const std::stop_token& stop) {
  Session session;
  while (true) {
    Request request;
    {
      std::unique_lock lock(mutex_);
      if (!changed_.wait(lock, stop, [&] { return waiting_.has_value(); })) return;
      request = *std::exchange(waiting_, std::nullopt);
    }
    auto answer = answerTo(request, session);
    if (!answer) continue;
    {
      const std::lock_guard lock(mutex_);
      newest_ = std::make_shared<const SampleAnswer>(*std::move(answer));
    }
    wake_();
  }
}

// Leaves a sentence in `failure` if the part cannot be run.
void SampleEngine::start(const Request& request, Session& session) const {
  const int part = contractOf(request.settings.function).part;
  const CourseworkBuild& build = *request.coursework->build;
  session = Session{};
  session.build = request.coursework->number;
  session.part = part;
  const PartBuild& made = build.parts.at(placeOfPart(part));
  if (!made.compiled) {
    session.failure = fmt::format("{} does not compile: there are samples again when it does.",
                                  displayPath(made.source));
    return;
  }
  const std::array parts{part};
  const LinkedWorker linked = linkWithStandIns(build, parts);
  session.failure = linked.failure;
  if (linked.worker.empty()) return;
  WorkerProcess::Options options;
  options.program = linked.worker;
  options.courseworkFolder = build.folder;
  options.limits = limits_;
  options.goOn = [stop = request.stop] { return !stop.stop_requested(); };
  session.worker = std::make_unique<WorkerProcess>(std::move(options));
  session.stubs = makeStubReport(session.worker->stubs());
}

// Nothing if another build has come in the meantime.
std::optional<SampleAnswer> SampleEngine::answerTo(const Request& request, Session& session) const {
  const F function = request.settings.function;
  SampleAnswer answer;
  answer.build = request.coursework->number;
  answer.settings = answer.set.settings = request.settings;
  answer.set.sketch = makeSampleDomain(request.settings)->sketch();
  try {
    const bool same =
        session.build == request.coursework->number && session.part == contractOf(function).part;
    if (!same || (!session.worker && session.failure.empty())) start(request, session);
    if (!session.failure.empty()) {
      answer.sentence = session.failure;
    } else if (session.stubs.isUnwritten(function)) {
      answer.kind = SampleAnswer::Kind::kNotWritten;
      answer.sentence = notWritten(contractOf(function));
    } else {
      answer.set = drawSamples(*session.worker, request.settings);
      answer.note = noteAbout(function, session.stubs);
      answer.kind = SampleAnswer::Kind::kSamples;
    }
  } catch (const WorkerStopped&) {
    session.worker.reset();
    return std::nullopt;
  } catch (const WorkerError& e) {
    session.worker.reset();
    answer.sentence = e.what();
  } catch (const std::exception& e) {
    session = Session{};
    answer.sentence = fmt::format("The samples cannot be drawn: {}.", e.what());
  }
  return answer;
}

}  // namespace pathmark::preview
