#include "host/invalid_origin.h"

#include "geometry/face_kind.h"
#include "host/coursework_builder.h"
#include "host/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <optional>
#include <set>
#include <vector>

namespace pathmark {

namespace {

using F = CourseworkFunction;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience{3};

// What is looked for: a path that returned something negative has no number that is not finite.
enum class Invalid { kNotFinite, kNegative };

bool isFinite(const float (&v)[3]) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

bool isNegative(const float (&v)[3]) { return v[0] < 0.0f || v[1] < 0.0f || v[2] < 0.0f; }

std::string text(float x) { return std::isnan(x) ? "NaN" : fmt::format("{:g}", x); }

std::string text(const float (&v)[3]) {
  return fmt::format("({}, {}, {})", text(v[0]), text(v[1]), text(v[2]));
}

std::string nameOf(F function) {
  const FunctionContract& f = contractOf(function);
  return fmt::format("{} (part {})", f.name, f.part);
}

F tracerOf(Estimator estimator) {
  return estimator == Estimator::kMis ? F::kTracePathMis : F::kTracePath;
}

F samplerOf(const FlatScene& scene, const FlatLight& light) {
  if (light.sphere != FlatLight::kNoSphere) return F::kSphereSample;
  const FlatFace& face = scene.faces[light.firstFace];
  std::vector<Point> corners;
  for (std::uint32_t k = 0; k < face.vertexCount; ++k) {
    const Float3& v = scene.lightVertices[face.firstVertex + k];
    corners.emplace_back(v[0], v[1], v[2]);
  }
  const Polygon polygon(corners, {}, Vector(face.normal[0], face.normal[1], face.normal[2]));
  const FaceKind kind = faceKind(polygon);
  if (scene.lightSampling == LightSampling::kBySolidAngle && light.faceCount == 1) {
    if (kind == FaceKind::kTriangle) return F::kSphericalTriangleSampling;
    if (isRectangle(polygon)) return F::kSphericalRectangleSampling;
  }
  return kind == FaceKind::kTriangle        ? F::kTriangularSampling
         : kind == FaceKind::kParallelogram ? F::kRectangularSampling
                                            : F::kPolygonSampling;
}

// An event does not say which of the lights it is about.
std::string lightSampler(const FlatScene& scene) {
  std::set<F> samplers;
  for (const FlatLight& light : scene.lights) samplers.insert(samplerOf(scene, light));
  return samplers.size() == 1 ? nameOf(*samplers.begin())
                              : "a function that samples lights (part 2)";
}

// Goes through the events of one path.
class PathSearch {
 public:
  PathSearch(const FlatScene& scene, Estimator estimator, Invalid invalid)
      : scene_(scene), estimator_(estimator), invalid_(invalid) {}

  // A sentence, if this is the event.
  std::string look(const PathEvent& e) {
    switch (e.kind) {
      case PathEventKind::kPath:
        if (estimator_ != Estimator::kPath || (isFinite(e.a) && isFinite(e.b))) return {};
        return returned(nameOf(F::kStratifiedRandomRay), "the ray", e.a, e.b);
      case PathEventKind::kHit:
        if (!inDirect_) material_ = e.integer;
        return {};
      case PathEventKind::kDirectBegin:
        if (!isFinite(e.b)) return passed(nameOf(F::kDirectLighting), "the direction", e.b);
        inDirect_ = true;
        return {};
      case PathEventKind::kDirectEnd:
        inDirect_ = false;
        return ifBad(nameOf(F::kDirectLighting), "the radiance", e.a);
      case PathEventKind::kLightSample:
        // With the density 0 the rest is not to be used, and may be anything.
        if (!isFinite(e.a) && e.x != 0.0f) return returned(lightSampler(scene_), "the point", e.a);
        return ifBad(lightSampler(scene_), "the density", e.x);
      case PathEventKind::kReflection:
        if (!isFinite(e.a)) return passed(brdf(F::kLambertianReflection), "the direction", e.a);
        if (!isFinite(e.b) && e.x != 0.0f)
          return returned(brdf(F::kLambertianReflection), "the direction", e.b);
        return ifBad(brdf(F::kLambertianReflection), "the density", e.x);
      case PathEventKind::kBrdf:
        if (!isFinite(e.a) || !isFinite(e.b))
          return passed(brdf(F::kLambertianBrdf), "the direction", isFinite(e.a) ? e.b : e.a);
        return ifBad(brdf(F::kLambertianBrdf), "the value", e.c);
      case PathEventKind::kPdf:
        if (!isFinite(e.a) || !isFinite(e.b))
          return passed(brdf(F::kLambertianPdf), "the direction", isFinite(e.a) ? e.b : e.a);
        return ifBad(brdf(F::kLambertianPdf), "the density", e.x);
      case PathEventKind::kRoulette:
        if (isBad(e.a)) return passed(nameOf(F::kRussianRoulette), "the throughput", e.a);
        return ifBad(nameOf(F::kRussianRoulette), "the weight", e.y);
      case PathEventKind::kRadiance:
        return e.integer > 0 ? "" : ifBad(nameOf(tracerOf(estimator_)), "the radiance", e.a);
      case PathEventKind::kMiss:
      case PathEventKind::kShadowRay:
      case PathEventKind::kLightPdf:
        break;
    }
    return {};
  }

 private:
  bool isBad(const float (&v)[3]) const {
    return invalid_ == Invalid::kNotFinite ? !isFinite(v) : isNegative(v);
  }

  // The function of the material that the path has met last, of the same name.
  std::string brdf(F lambertian) const {
    const auto at = static_cast<std::size_t>(material_);
    const bool phong =
        at < scene_.materials.size() && scene_.materials[at].kind == FlatMaterialKind::kPhong;
    constexpr auto kBetween =
        static_cast<std::uint32_t>(F::kPhongBrdf) - static_cast<std::uint32_t>(F::kLambertianBrdf);
    return nameOf(phong ? static_cast<F>(static_cast<std::uint32_t>(lambertian) + kBetween)
                        : lambertian);
  }

  template <class... Numbers>
  std::string returned(const std::string& function, const char* what,
                       const Numbers&... numbers) const {
    std::string all;
    for (const std::string& one : {text(numbers)...}) all += (all.empty() ? "" : " ") + one;
    return fmt::format("In that pixel the first was returned by {}: {} {}.", function, what, all);
  }

  std::string passed(const std::string& to, const char* what, const float (&v)[3]) const {
    return fmt::format("In that pixel the first was passed by {} to {}: {} {}.",
                       nameOf(inDirect_ ? F::kDirectLighting : tracerOf(estimator_)), to, what,
                       text(v));
  }

  std::string ifBad(const std::string& function, const char* what, const float (&v)[3]) const {
    return isBad(v) ? returned(function, what, v) : std::string();
  }
  std::string ifBad(const std::string& function, const char* what, float x) const {
    const bool bad = invalid_ == Invalid::kNotFinite ? !std::isfinite(x) : x < 0.0f;
    if (!bad) return {};
    return fmt::format("In that pixel the first was returned by {}: {} {}.", function, what,
                       text(x));
  }

  const FlatScene& scene_;
  Estimator estimator_;
  Invalid invalid_;
  bool inDirect_ = false;
  std::int32_t material_ = -1;
};

std::string originIn(std::span<const PathEvent> path, const FlatScene& scene, Estimator estimator) {
  const auto& radiance = path.back().a;
  PathSearch search(scene, estimator,
                    isFinite(radiance) ? Invalid::kNegative : Invalid::kNotFinite);
  for (const PathEvent& event : path)
    if (std::string sentence = search.look(event); !sentence.empty()) return sentence;
  return {};
}

RenderJob passOf(const RenderSettings& settings, const PixelPasses& passes, std::uint32_t replicate,
                 std::uint64_t firstRay, std::uint64_t pixel) {
  RenderJob job = jobOf(settings, replicate);
  job.threads = 1;
  job.raysPerPass = passes.raysPerPass;
  job.firstRay = firstRay;
  job.rays = std::min<std::uint64_t>(passes.raysPerPass, passes.rays - firstRay);
  const auto width = static_cast<std::uint64_t>(settings.width);
  job.region = {static_cast<std::int32_t>(pixel % width), static_cast<std::int32_t>(pixel / width),
                1, 1};
  return job;
}

// The first pass of the pixel that gives such a value.
std::optional<RecordedPaths> findPass(WorkerProcess& worker, const RenderSettings& settings,
                                      const PixelPasses& passes, std::uint64_t pixel) {
  const auto deadline = Clock::now() + kPatience;
  const auto goOn = [&](const RenderProgress&) {
    return Clock::now() < deadline && !interrupted();
  };
  SharedFilm film(settings.width, settings.height);
  for (std::uint32_t replicate = 0; replicate < passes.replicates; ++replicate)
    for (std::uint64_t ray = 0; ray < passes.rays; ray += passes.raysPerPass) {
      if (!goOn({})) return std::nullopt;
      RecordedPaths recorded =
          worker.recordPaths(passOf(settings, passes, replicate, ray, pixel), film, goOn);
      if (recorded.counts.result.invalid.count() > 0) return recorded;
    }
  return std::nullopt;
}

}  // namespace

std::string firstInvalid(std::span<const PathEvent> paths, const FlatScene& scene,
                         Estimator estimator) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].kind == PathEventKind::kPath) begin = i;
    if (paths[i].kind != PathEventKind::kRadiance) continue;
    if (!isFinite(paths[i].a) || isNegative(paths[i].a))
      return originIn(paths.subspan(begin, i - begin + 1), scene, estimator);
  }
  return {};
}

std::string invalidOrigin(const Coursework& coursework, const LoadedScene& scene,
                          const RenderSettings& settings, const PixelPasses& passes,
                          std::uint64_t pixel) {
  if (settings.estimator != Estimator::kPath && settings.estimator != Estimator::kMis) return {};
  try {
    const LinkedWorker linked = linkForRecording(buildCoursework(coursework.folder));
    if (linked.worker.empty()) return {};
    WorkerProcess::Options options;
    options.program = linked.worker;
    options.courseworkFolder = coursework.folder;
    WorkerProcess worker(std::move(options));
    worker.loadScene(scene.flat);
    const auto pass = findPass(worker, settings, passes, pixel);
    if (!pass) return {};
    if (std::string sentence = firstInvalid(pass->events, scene.flat, settings.estimator);
        !sentence.empty())
      return sentence;
    const auto bad = [](const PathEvent& e) {
      return e.kind == PathEventKind::kRadiance && (!isFinite(e.a) || isNegative(e.a));
    };
    const bool allSeen =
        pass->counts.paths > 0 && std::none_of(pass->events.begin(), pass->events.end(), bad);
    if (settings.estimator != Estimator::kPath || !allSeen) return {};
    return fmt::format("In that pixel the first was returned by {}: no path has returned one.",
                       nameOf(F::kRenderPixel));
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace pathmark
