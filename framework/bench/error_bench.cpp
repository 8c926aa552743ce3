#include "bench/error_bench.h"

#include "bench/cycles_peer.h"
#include "bench/error_reference.h"
#include "bench/interrupted_run.h"
#include "bench/progress.h"
#include "film/image_file.h"
#include "host/blob_file.h"
#include "host/build_config.h"
#include "host/content_hash.h"
#include "host/render_state.h"

#include <fmt/format.h>

#include <chrono>
#include <map>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kCyclesName = "Cycles";
constexpr const char* kPeersWords = "peer";  // ErrorRun::made of images from elsewhere

struct SceneBench {
  BenchScene scene;
  BenchReference reference;
  std::string hash;  // of both
};

struct Subject {
  const AskedEstimator* asked;
  RunningEstimator running;
  std::string made;
  bool failed = false;
};

std::string hashOf(const LoadedScene& scene, const Image& reference) {
  ContentHasher hasher;
  hasher.add(sceneHash(scene));
  hasher.add(std::as_bytes(std::span(reference.rgb)));
  return hasher.digits();
}

SceneBench prepareScene(const ErrorPlan& plan, const std::string& name,
                        const Coursework& coursework) {
  const fs::path file = findScene(name);
  if (needsShippedBlobFile(file)) makeShippedBlobFile();
  SceneBench bench;
  bench.scene.scene = loadScene(file, plan.overrides);
  bench.scene.key = bench.scene.name = bench.scene.scene.name;
  bench.reference =
      referenceFor(bench.scene.scene, coursework, plan.referenceRays, plan.referenceFile);
  bench.scene.reference = bench.reference.image;
  bench.hash = hashOf(bench.scene.scene, bench.reference.image);
  return bench;
}

class SceneMeasurement {
 public:
  SceneMeasurement(const ErrorPlan& plan, const SceneBench& bench, ErrorRuns& runs,
                   ErrorFindings& findings, const std::function<void()>& onRun)
      : plan_(plan), bench_(bench), runs_(runs), findings_(findings), onRun_(onRun) {}

  void prepare(const std::map<std::string, Coursework>& courseworks) {
    for (const AskedEstimator& asked : plan_.estimators) {
      const auto coursework = courseworks.find(asked.name);
      if (coursework == courseworks.end()) continue;
      const std::string made = madeBy(
          bench_.hash,
          fmt::format("{}{} {}", coursework->second.worker.string(), asked.way.words, plan_.seed));
      runs_.keepOnly(name(), asked.name, made);
      subjects_.push_back(
          {&asked, RunningEstimator(coursework->second, asked.way, bench_.scene.scene), made});
    }
    // What only the first render of a process costs.
    for (Subject& subject : subjects_)
      guarded(subject, [&] {
        (void)subject.running.render(1, plan_.samplers.front(), plan_.seed);
        stopIfInterrupted();
      });
  }

  // Throws Interrupted.
  void measure(Progress& progress, double seconds, const std::optional<CyclesPeer>& cycles) {
    const Clock::time_point start = Clock::now();
    const auto outOfTime = [&] {
      return seconds > 0.0 && std::chrono::duration<double>(Clock::now() - start).count() > seconds;
    };
    for (std::uint64_t replicate = 0; replicate < plan_.replicates; ++replicate)
      for (const std::uint64_t rays : plan_.raysPerPixel) {
        for (Subject& subject : subjects_)
          for (const SamplerKind sampler : plan_.samplers) {
            if (outOfTime()) return;
            progress.show(fmt::format("{}, {}, {}, {} rays per pixel", name(), subject.asked->name,
                                      nameOf(sampler), rays));
            measureOnce(subject, {name(), subject.asked->name, std::string(nameOf(sampler)), rays},
                        sampler, replicate);
            progress.advance(static_cast<double>(rays));
          }
        if (cycles && !outOfTime()) {
          progress.show(fmt::format("{}, Cycles, {} rays per pixel", name(), rays));
          measureCycles(*cycles, rays, replicate);
        }
      }
  }

  void addPeers() {
    std::map<ErrorPoint, std::uint64_t> replicates;
    const auto isOfScene = [&](const PeerImage& peer) {
      return peer.scene.empty() || peer.scene == name();
    };
    // Which images they were is not kept, and there may have been more of them.
    for (const PeerImage& peer : plan_.peers)
      if (isOfScene(peer)) runs_.keepOnly(name(), peer.name, {});
    for (const PeerImage& peer : plan_.peers) {
      if (!isOfScene(peer)) continue;
      const ErrorPoint point{name(), peer.name, "", peer.raysPerPixel};
      runs_.add({point, replicates[point]++, peer.cpuSeconds, deviationOf(imageOf(peer)),
                 madeBy(bench_.hash, kPeersWords)});
    }
  }

 private:
  const std::string& name() const { return bench_.scene.name; }

  Deviation deviationOf(const Image& image) const {
    return bench::deviationOf(image, bench_.reference.image);
  }

  std::uint64_t seedOf(std::uint64_t replicate) const {
    return replicateSeed(plan_.seed, replicate);
  }

  // An estimator that fails is left out from then on; the others go on.
  template <class Work>
  void guarded(Subject& subject, const Work& work) {
    try {
      work();
    } catch (const WorkerError& e) {
      subject.failed = true;
      findings_.fault = true;
      findings_.notes.push_back(fmt::format("{} on {}: {}", subject.asked->name, name(), e.what()));
    }
  }

  void measureOnce(Subject& subject, const ErrorPoint& point, SamplerKind sampler,
                   std::uint64_t replicate) {
    if (subject.failed || runs_.find(point, replicate, subject.made) != nullptr) return;
    guarded(subject, [&] {
      const auto made = subject.running.render(point.raysPerPixel, sampler, seedOf(replicate));
      if (!made) throw Interrupted{};
      runs_.add({point, replicate, made->cpuSeconds, deviationOf(made->image), subject.made});
      onRun_();
    });
  }

  void measureCycles(const CyclesPeer& cycles, std::uint64_t rays, std::uint64_t replicate) {
    const ErrorPoint point{name(), kCyclesName, "", rays};
    const std::string made =
        madeBy(bench_.hash, fmt::format("{} {}", cycles.version(), plan_.seed));
    runs_.keepOnly(name(), kCyclesName, made);
    if (runs_.find(point, replicate, made) != nullptr) return;
    const CyclesResult result = cycles.render(bench_.scene, rays, plan_.seed + replicate);
    runs_.add({point, replicate, result.renderCpuSeconds, deviationOf(result.image), made});
    onRun_();
  }

  Image imageOf(const PeerImage& peer) const {
    Image image = readImage(peer.image).image;
    const Image& reference = bench_.reference.image;
    if (image.width != reference.width || image.height != reference.height)
      throw UsageError(fmt::format("--peer {}: {} has {} x {} pixels, and {} has {} x {}.",
                                   peer.name, peer.image.string(), image.width, image.height,
                                   name(), reference.width, reference.height));
    return image;
  }

  const ErrorPlan& plan_;
  const SceneBench& bench_;
  ErrorRuns& runs_;
  ErrorFindings& findings_;
  const std::function<void()>& onRun_;
  std::vector<Subject> subjects_;
};

// By the estimators' names. Labs that nobody named and that are not written yet, or do not compile,
// are left out with a note.
std::map<std::string, Coursework> prepareEstimators(const ErrorPlan& plan,
                                                    ErrorFindings& findings) {
  std::map<std::string, Coursework> courseworks;
  for (const AskedEstimator& asked : plan.estimators) {
    try {
      Coursework coursework = prepareCoursework(asked.folder.string());
      const std::string unwritten = whatIsUnwritten(coursework, asked.way);
      if (unwritten.empty())
        courseworks.emplace(asked.name, std::move(coursework));
      else if (asked.byName)
        throw CourseworkError(fmt::format("{}: {}.", asked.name, unwritten));
      else
        findings.notes.push_back(fmt::format("{} is left out: {}.", asked.name, unwritten));
    } catch (const CourseworkError& e) {
      if (asked.byName) throw;
      findings.notes.push_back(fmt::format("{} is left out: {}", asked.name, e.what()));
    }
  }
  return courseworks;
}

std::optional<CyclesPeer> findCycles(const ErrorPlan& plan) {
  if (!plan.cycles) return std::nullopt;
  const fs::path folder = fs::path(build::kBuildFolder) / "bench-cycles";
  fs::create_directories(folder);
  std::optional<CyclesPeer> cycles = CyclesPeer::find(folder);
  if (!cycles)
    throw UsageError(
        "--peer cycles: there is no program blender; on Debian and Ubuntu it is the package "
        "blender.");
  return cycles;
}

double stepsOf(const ErrorPlan& plan) {
  double rays = 0.0;
  for (const std::uint64_t n : plan.raysPerPixel) rays += static_cast<double>(n);
  return rays * static_cast<double>(plan.replicates * plan.estimators.size() *
                                    plan.samplers.size() * plan.scenes.size());
}

}  // namespace

ErrorFindings measureErrors(const ErrorPlan& plan, ErrorRuns& runs,
                            const std::function<void()>& onRun) {
  ErrorFindings findings;
  const std::optional<CyclesPeer> cycles = findCycles(plan);
  const std::map<std::string, Coursework> courseworks = prepareEstimators(plan, findings);
  const Coursework coursework = prepareCoursework(plan.with);
  Progress progress("bench error", stepsOf(plan));
  for (const std::string& name : plan.scenes) {
    try {
      stopIfInterrupted();
      const SceneBench bench = prepareScene(plan, name, coursework);
      SceneMeasurement measurement(plan, bench, runs, findings, onRun);
      const double share = plan.seconds / static_cast<double>(plan.scenes.size());
      try {
        measurement.addPeers();
        measurement.prepare(courseworks);
        measurement.measure(progress, share, cycles);
      } catch (const Interrupted&) {
        findings.interrupted = true;
      }
      findings.scenes.push_back(
          summarise(bench.scene.name, bench.reference.own, runs.of(bench.hash)));
    } catch (const Interrupted&) {
      findings.interrupted = true;
    }
    if (findings.interrupted) break;
  }
  progress.clear();
  return findings;
}

}  // namespace pathmark::bench
