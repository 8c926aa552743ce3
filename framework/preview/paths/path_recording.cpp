#include "preview/paths/path_recording.h"

#include "host/render_state.h"
#include "host/stub_report.h"
#include "preview/paths/path_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace pathmark::preview {

namespace {

constexpr double kSecondsWithoutAnswer = 5.0;

// The functions that make the paths.
std::vector<CourseworkFunction> tracersOf(Estimator estimator) {
  switch (estimator) {
    case Estimator::kWarmUp:
      return {CourseworkFunction::kGetRayRadiance};
    case Estimator::kMis:
      return {CourseworkFunction::kTracePathMis};
    default:
      return {CourseworkFunction::kRenderPixel, CourseworkFunction::kTracePath};
  }
}

// A sentence, for which there can be no paths.
class NoPaths : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

RenderJob jobFor(const PathRequest& request) {
  RenderJob job;
  job.estimator = request.made.estimator;
  job.sampler = request.sampler;
  job.paths = request.automaton;
  job.seed = request.seed;
  job.raysPerPass = request.raysPerPass;
  const std::uint64_t passes = (request.rays + request.raysPerPass - 1) / request.raysPerPass;
  job.rays = passes * request.raysPerPass;
  job.region = {request.column, request.row, 1, 1};
  job.ownCamera = 1;
  job.camera = request.camera;
  return job;
}

Colour meanOf(const std::vector<TracedPath>& paths) {
  glm::dvec3 sum(0.0);
  for (const TracedPath& path : paths) sum += glm::dvec3(path.radiance);
  return sum / static_cast<double>(std::max<std::size_t>(paths.size(), 1));
}

// Black without a ray.
Colour meanOf(const FilmPixel& pixel) {
  if (pixel.rays == 0.0) return Colour(0.0f);
  return glm::dvec3(pixel.sum[0], pixel.sum[1], pixel.sum[2]) / pixel.rays;
}

// To the last bit, of finite numbers.
bool same(const FilmPixel& a, const FilmPixel& b) {
  return a.rays == b.rays && std::equal(std::begin(a.sum), std::end(a.sum), std::begin(b.sum));
}

bool near(const Colour& a, const Colour& b) {
  constexpr double kRounding = 1e-4;  // of a sum in float
  for (int c = 0; c < 3; ++c) {
    const double x = a[c], y = b[c];
    if (!(std::abs(x - y) <= kRounding * std::max(std::abs(x), std::abs(y)))) return false;
  }
  return true;
}

// About what renderPixel has made of the paths.
std::string pixelRemark(const FilmPixel& pixel, const PathAnswer& answer,
                        const RecordPathsReply& counts) {
  if (counts.paths != answer.pixelRays)
    return fmt::format("renderPixel was to trace {} rays, and called tracePath {} times.",
                       answer.pixelRays, counts.paths);
  if (answer.paths.size() != counts.paths)
    return fmt::format("There is room for the first {} of {} paths only.", answer.paths.size(),
                       counts.paths);
  if (counts.result.invalid.count() > 0)
    return fmt::format(
        "{} returned NaN, infinity or a negative value, which the picture leaves out.",
        contractOf(tracersOf(answer.request.made.estimator).front()).name);
  if (pixel.rays > 0.0 && !near(answer.pixel, meanOf(answer.paths)))
    return fmt::format("renderPixel returned {}, but the mean of its {} paths is {}.",
                       shortColour(answer.pixel), answer.paths.size(),
                       shortColour(meanOf(answer.paths)));
  return {};
}

// These paths are not those of the picture.
std::string otherPathsRemark(const Colour& recorded, const Colour& rendered) {
  return fmt::format(
      "The same rays gave {}, and {} when they were rendered again: paths must depend on nothing "
      "but the sampler's numbers, not on a static variable, rand(), or the kind of a BRDF.",
      shortColour(recorded), shortColour(rendered));
}

}  // namespace

PathAnswer PathRecording::record(const PathRequest& request, const std::function<bool()>& wanted) {
  wanted_ = &wanted;
  unwantedSince_.reset();
  PathAnswer answer;
  answer.request = request;
  try {
    start(request);
    requireWritten(request);
    load(request);
    fill(answer);
  } catch (const WorkerStopped&) {
    end();
  } catch (const std::exception& e) {
    end();
    answer.failure = e.what();
    answer.paths.clear();
    answer.accounts.clear();
  }
  if (!wanted()) throw Unwanted();
  return answer;
}

void PathRecording::end() {
  worker_.reset();
  scene_.reset();
}

bool PathRecording::isWanted() { return (*wanted_)(); }

// A recording that is not wanted any more is asked to end, and is ended a little later.
bool PathRecording::isPatient() {
  constexpr std::chrono::milliseconds kPatience{200};
  if (isWanted()) return true;
  if (!unwantedSince_) unwantedSince_ = Clock::now();
  return Clock::now() - *unwantedSince_ < kPatience;
}

void PathRecording::start(const PathRequest& request) {
  if (worker_ && build_ == request.coursework->number) return;
  end();
  const auto& build = request.coursework->build;
  if (!build || build->worker.empty() || !build->complete())
    throw NoPaths("The paths can be seen when the coursework compiles.");
  const LinkedWorker linked = linkForRecording(*build);
  if (linked.worker.empty()) throw NoPaths(linked.failure);
  WorkerProcess::Options options;
  options.program = linked.worker;
  options.courseworkFolder = build->folder;
  options.limits.secondsWithoutAnswer = kSecondsWithoutAnswer;
  options.goOn = [this] { return isPatient(); };
  worker_ = std::make_unique<WorkerProcess>(std::move(options));
  build_ = request.coursework->number;
}

void PathRecording::load(const PathRequest& request) {
  if (scene_ == request.scene) return;
  worker_->loadScene(request.scene->loaded.flat);
  scene_ = request.scene;
}

// The request's pixel, as a render has left it in a new film.
FilmPixel PathRecording::pixelOf(const PathRequest& request,
                                 const std::function<void(SharedFilm&)>& render) {
  SharedFilm film(static_cast<int>(request.camera.width), static_cast<int>(request.camera.height));
  render(film);
  const FilmPixel pixel =
      film.pixels()[static_cast<std::size_t>(request.row) * request.camera.width +
                    static_cast<std::size_t>(request.column)];
  if (!isPossible(pixel, static_cast<double>(jobFor(request).rays)))
    worker_->refuseAnswer("The worker's film holds what no render leaves there.");
  return pixel;
}

void PathRecording::requireWritten(const PathRequest& request) {
  const StubReport stubs = makeStubReport(worker_->stubs());
  for (const CourseworkFunction f : tracersOf(request.made.estimator)) {
    const FunctionContract& function = contractOf(f);
    if (stubs.isUnwritten(f))
      throw NoPaths(fmt::format("No paths to see: {} (part {}) is not written yet.", function.name,
                                function.part));
  }
}

void PathRecording::fill(PathAnswer& answer) {
  const PathRequest& request = answer.request;
  const RenderJob job = jobFor(request);
  const auto goOn = [this](const RenderProgress&) { return isWanted(); };
  RecordedPaths recorded;
  const FilmPixel pixel =
      pixelOf(request, [&](SharedFilm& film) { recorded = worker_->recordPaths(job, film, goOn); });
  const FilmPixel again =
      pixelOf(request, [&](SharedFilm& film) { worker_->render(job, film, goOn); });
  if (!isWanted()) return;
  answer.paths = readPaths(recorded.events);
  if (answer.paths.empty())
    throw NoPaths("No paths to see: renderPixel does not call the tracePath of another file.");
  answer.pixelRays = job.rays;
  answer.pixel = meanOf(pixel);
  answer.remark = same(pixel, again) ? pixelRemark(pixel, answer, recorded.counts)
                                     : otherPathsRemark(answer.pixel, meanOf(again));
  answer.paths.resize(std::min<std::size_t>(answer.paths.size(), request.rays));
  answer.mean = meanOf(answer.paths);
  const AccountRules rules{request.made.estimator == Estimator::kWarmUp,
                           request.scene->loaded.flat.lights.size(),
                           request.made.estimator == Estimator::kMis};
  for (const TracedPath& path : answer.paths) answer.accounts.push_back(accountFor(path, rules));
}

}  // namespace pathmark::preview
