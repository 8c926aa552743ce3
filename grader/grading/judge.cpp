#include "grading/judge.h"

#include "checks/runner.h"
#include "film/image_formats.h"
#include "grading/record_results.h"
#include "host/render_loop.h"
#include "host/stub_report.h"
#include "marking/samples.h"
#include "sampling/mix.h"
#include "scene/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace pathmark::grading {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kPrintedBytes = 4096;  // that are kept of what a coursework prints
constexpr double kShareOfChecks = 0.6;       // of the time for a submission, about
constexpr int kLongestSide = 192;            // of the pictures of a submission's own scenes

// Of address space. Each thread reserves some for its stack and its heap, used or not.
std::size_t memoryOfWorker() {
  constexpr std::size_t kBase = std::size_t{2} << 30, kThread = std::size_t{128} << 20;
  return kBase + kThread * std::max(1u, std::thread::hardware_concurrency());
}

std::unique_ptr<WorkerProcess> startWorker(const std::filesystem::path& program) {
  WorkerProcess::Options options;
  options.program = program;
  return std::make_unique<WorkerProcess>(std::move(options));
}

std::vector<CourseworkFunction> unwrittenIn(const record::PartRecord& part) {
  std::vector<CourseworkFunction> functions;
  for (const FunctionContract& f : contract())
    for (const record::FunctionRecord& r : part.functions)
      if (r.section == f.section && r.verdict == record::Verdict::kNotWritten)
        functions.push_back(f.function);
  return functions;
}

bool anythingWritten(const record::PartRecord& part) {
  return std::any_of(
      part.functions.begin(), part.functions.end(),
      [](const record::FunctionRecord& f) { return f.verdict != record::Verdict::kNotWritten; });
}

// What an exception says, and what a file is called that is opened, is chosen by the coursework, as
// printed text is.
std::string withoutItsWords(const std::string& sentence) {
  for (const std::string_view before :
       {"an exception that nobody caught", "a forbidden system call"})
    if (const std::size_t at = sentence.find(before); at != std::string::npos)
      return sentence.substr(0, at + before.size()) + ".";
  return sentence;
}

}  // namespace

// One submission on its way.
class Judge::Session {
 public:
  Session(Judge& judge, const std::filesystem::path& folder, unsigned threads,
          const OnProgress& onProgress)
      : judge_(judge), folder_(folder), threads_(threads), onProgress_(onProgress) {}

  Judged run() {
    record::SubmissionRecord& record = judged_.record;
    record.seed = judge_.options_.seed;
    build_ = buildCoursework(folder_, Incomplete::kCompileOnly, judge_.confinement_, threads_);
    check();
    for (record::PartRecord& part : record.parts) {
      show(part);
      advance(0.5 * (1.0 - kShareOfChecks) / static_cast<double>(record.parts.size()));
    }
    if (judge_.options_.whole) showWhole();
    throwIfInterrupted();
    record.printed = printed_;
    forgetFolder(record, folder_);
    record.outOfTime = outOfTime_;
    record.seconds = std::chrono::duration<double>(Clock::now() - started_).count();
    return std::move(judged_);
  }

 private:
  bool timeIsUp() const {
    const double seconds = std::chrono::duration<double>(Clock::now() - started_).count();
    return seconds > judge_.options_.secondsAtMost;
  }

  bool goOn() {
    if (!onProgress_(std::min(fraction_.load(), 1.0))) interrupted_ = true;
    if (timeIsUp()) outOfTime_ = true;
    return !interrupted_ && !outOfTime_;
  }

  void throwIfInterrupted() const {
    if (interrupted_) throw Interrupted();
  }

  void advance(double fraction) { fraction_ = fraction_ + fraction; }

  void keepPrinted(std::string_view text) {
    const std::lock_guard lock(printing_);
    printed_ += text.substr(0, kPrintedBytes - std::min(printed_.size(), kPrintedBytes));
  }

  void check() {
    checks::Selection selection;
    selection.parts = judge_.options_.parts;
    selection.images = selection.scenes = judge_.options_.whole;
    checks::RunOptions options;
    options.seed = judge_.options_.seed;
    options.threads = threads_;
    options.memoryBytes = memoryOfWorker();
    options.onText = [&](std::string_view text) { keepPrinted(text); };
    checks::RunEvents events;
    events.onProgress = [&](double fraction, const std::string&) {
      fraction_ = kShareOfChecks * fraction;
    };
    events.goOn = [&] { return goOn(); };
    const checks::CourseworkResults results = checks::runChecks(build_, selection, options, events);
    throwIfInterrupted();
    fraction_ = kShareOfChecks;
    judged_.record.parts = recordParts(results, build_, selection.parts);
    judged_.record.images = recordImages(results);
    judged_.record.scenes = recordScenes(results);
  }

  // A worker of linkWithOthers. Its coursework can read the solutions beside it, and print them:
  // none of its text is kept.
  std::unique_ptr<WorkerProcess> start(const std::filesystem::path& program) {
    WorkerProcess::Options options;
    options.program = program;
    options.courseworkFolder = folder_;
    options.confinement = judge_.confinement_;
    options.limits.memoryBytes = memoryOfWorker();
    options.goOn = [&] { return goOn(); };
    return std::make_unique<WorkerProcess>(std::move(options));
  }

  // Adds a picture to the record, and its files to what is to be written.
  void take(marking::Compared compared, const std::string& name,
            std::vector<record::PictureRecord>& pictures) {
    record::PictureRecord& record = compared.record;
    const auto keep = [&](const char* kind, std::string& bytes) -> std::string {
      if (bytes.empty()) return {};
      std::string file = fmt::format("pictures/{}_{}.png", name, kind);
      judged_.files[file] = std::move(bytes);
      return file;
    };
    record.yours = keep("yours", compared.files.yours);
    record.reference = keep("reference", compared.files.reference);
    record.difference = keep("difference", compared.files.difference);
    pictures.push_back(std::move(record));
  }

  // Pictures of `scenes` with this program, a new worker for each: none sees what another left.
  // A curve of errors is made of the first of the whole. Returns the pictures themselves.
  std::vector<Image> compare(const LinkedWorker& linked,
                             const std::vector<marking::MarkingScene>& scenes,
                             const std::string& name, bool whole,
                             std::vector<record::PictureRecord>& pictures) {
    std::vector<Image> images;
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      marking::Compared compared;
      compared.record.scene = scenes[k].name;
      compared.record.failure = linked.failure;
      if (!linked.worker.empty()) {
        try {
          const auto worker = start(linked.worker);
          const marking::CompareOptions options{mix(judge_.options_.seed + k), threads_,
                                                whole && k == 0};
          compared = marking::comparePicture(*worker, scenes[k], *judge_.solved_, options);
        } catch (const WorkerError& e) {
          compared.record.failure = e.what();
        } catch (const WorkerStopped&) {
          throwIfInterrupted();
          compared.record.failure = "The time for the whole submission was up before this picture.";
        }
      }
      compared.record.failure = withoutItsWords(compared.record.failure);
      images.push_back(std::move(compared.image));
      take(std::move(compared), fmt::format("{}_{}", name, k + 1), pictures);
    }
    return images;
  }

  // Where the checks have named known mistakes, what these do to the scene in which the part's
  // picture is furthest off.
  void showMistakes(record::PartRecord& part, const std::vector<Image>& images) {
    std::size_t worst = images.size();
    for (std::size_t k = 0; k < images.size(); ++k)
      if (!images[k].rgb.empty() &&
          (worst == images.size() || part.pictures[k].bias.value > part.pictures[worst].bias.value))
        worst = k;
    if (worst == images.size()) return;
    const record::PictureRecord& shown = part.pictures[worst];
    const marking::MarkingScene& scene = judge_.scenes_.at(part.part)[worst];
    for (const record::FunctionRecord& f : part.functions) {
      const bool known = std::any_of(part.mistakes.begin(), part.mistakes.end(),
                                     [&](const auto& m) { return m.mistake == f.mistake; });
      if (f.mistake.empty() || known || !goOn()) continue;
      const std::optional<Image>& picture = judge_.mistakes_->of(f.mistake, scene, threads_);
      if (!picture) continue;
      const std::string file =
          fmt::format("pictures/part{}_mistake_{}.png", part.part, part.mistakes.size() + 1);
      judged_.files[file] = encodePng(*picture, scene.exposure);
      part.mistakes.push_back({f.mistake, f.what, shown.scene, shown.yours, shown.reference, file,
                               shown.bias, marking::tileBias(images[worst], *picture)});
    }
  }

  void show(record::PartRecord& part) {
    if (!anythingWritten(part)) return;
    const LinkedWorker linked = linkWithOthers(build_, std::array{part.part}, judge_.solutions_);
    const std::vector<Image> images =
        compare(linked, judge_.scenes_.at(part.part), fmt::format("part{}", part.part), false,
                part.pictures);
    showMistakes(part, images);
    if (linked.worker.empty()) return;
    try {
      const auto worker = start(linked.worker);
      const auto solved = startWorker(judge_.solvedWorker_);
      for (record::SampleRecord& samples :
           marking::drawSamples(*worker, *solved, part.part, unwrittenIn(part)))
        judged_.record.samples.push_back(std::move(samples));
    } catch (const WorkerError&) {
      // The checks have said already what is wrong.
    } catch (const WorkerStopped&) {
      throwIfInterrupted();
    }
  }

  void showWhole() {
    static constexpr std::array kAll{0, 1, 2, 3, 4, 5, 6};
    const LinkedWorker linked = linkWithOthers(build_, kAll, judge_.solutions_);
    compare(linked, judge_.wholeScenes_, "whole", true, judged_.record.pictures);
    std::size_t number = 0;
    for (record::SceneRecord& scene : judged_.record.scenes) showScene(scene, ++number);
  }

  // With the solutions: what a scene shows does not depend on mistakes in other parts.
  void showScene(record::SceneRecord& scene, std::size_t number) {
    try {
      const std::filesystem::path file = folder_ / "scenes" / scene.file;
      const LoadedScene full = loadScene(file);
      const double longest = std::max(full.flat.camera.width, full.flat.camera.height);
      const double factor = std::min(kLongestSide / longest, 1.0);
      const auto side = [&](std::uint32_t pixels) {
        return std::max(static_cast<int>(std::lround(factor * pixels)), 1);
      };
      const LoadedScene shown = loadScene(
          file, {.size = {{side(full.flat.camera.width), side(full.flat.camera.height)}}});
      const auto worker = startWorker(judge_.solvedWorker_);
      worker->loadScene(shown.flat);
      RenderSettings settings;
      settings.width = static_cast<int>(shown.flat.camera.width);
      settings.height = static_cast<int>(shown.flat.camera.height);
      settings.threads = threads_;
      const RenderedImage rendered =
          renderImage(*worker, settings, [&](const RenderStatus&) { return goOn(); });
      throwIfInterrupted();
      // Whatever a student calls it, it is no other picture's name.
      scene.picture = fmt::format("pictures/scene_{}.png", number);
      judged_.files[scene.picture] = encodePng(rendered.image, shown.exposure);
    } catch (const SceneError&) {
      // It was said already.
    } catch (const WorkerError& e) {
      scene.message = e.what();
    }
  }

  Judge& judge_;
  const std::filesystem::path& folder_;
  unsigned threads_;
  const OnProgress& onProgress_;
  Clock::time_point started_ = Clock::now();
  std::atomic<double> fraction_{0.0};
  std::atomic<bool> interrupted_{false}, outOfTime_{false};
  CourseworkBuild build_;
  Judged judged_;
  std::mutex printing_;
  std::string printed_;
};

Judge::Judge(JudgeOptions options, std::shared_ptr<Confinement> confinement)
    : options_(std::move(options)), confinement_(std::move(confinement)) {
  solutions_ = buildCoursework(courseworkFolder("solutions"));
  if (solutions_.worker.empty())
    throw std::runtime_error("The solutions cannot be used: " + solutions_.failure());
  solvedWorker_ = solutions_.worker;
  for (const int part : options_.parts) scenes_[part] = marking::scenesOfPart(part, options_.seed);
  wholeScenes_ = marking::scenesOfWhole(options_.seed);
  solved_ = std::make_unique<marking::SolvedPictures>(
      [program = solvedWorker_] { return startWorker(program); }, options_.seed);
  mistakes_ = std::make_unique<MistakePictures>(solutions_, options_.seed);
}

Judged Judge::judge(const std::filesystem::path& folder, unsigned threads,
                    const OnProgress& onProgress) {
  return Session(*this, folder, threads, onProgress).run();
}

}  // namespace pathmark::grading
