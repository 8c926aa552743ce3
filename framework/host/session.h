// What the commands share: building a coursework, starting its worker, finding a scene, rendering.
#pragma once

#include "host/render_loop.h"
#include "host/stub_report.h"
#include "host/worker_process.h"
#include "light_paths/expression.h"
#include "scene/load_scene.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark {

class ProgressBar;

// A sentence about coursework that cannot be used at all.
class CourseworkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A sentence about the command line.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Coursework {
  std::string name;  // "student", "solutions", or the folder's name
  std::filesystem::path folder;
  std::filesystem::path worker;
};

// The folder meant by --with. Throws UsageError if there is none.
std::filesystem::path findCoursework(const std::string& with);

// "solutions" where they are, else "student": a student kit has no solutions.
std::string solvedCoursework();

// What --with can be, for --help: "student (default), solutions, or a folder of part*.cpp files".
// `byDefault`: "student", or what solvedCoursework() says. Names solutions only where they are.
std::string courseworkChoices(const std::string& byDefault);

// How it is called in messages and file names.
std::string courseworkName(const std::string& with);

// " --with FOLDER" as a shell takes it, for a command that a person calls in the project's folder
// for this coursework; nothing for student/, which needs none.
std::string withOption(const std::filesystem::path& folder);

// Compiles and links; prints the compiler's warnings to standard error. Throws UsageError and
// CourseworkError.
Coursework prepareCoursework(const std::string& with);

// A scene by its file, or by its name in scenes/ or student/scenes/. Throws UsageError.
std::filesystem::path findScene(const std::string& scene);

// The file names without ending in these folders, sorted.
std::vector<std::string> sceneNames();

// Those in scenes/ only.
std::vector<std::string> shippedSceneNames();

// Where a shipped scene of this name would be.
std::filesystem::path shippedSceneFile(const std::string& name);

struct RenderOptions {
  std::uint64_t raysPerPixel = 64;
  std::uint32_t replicates = 1;
  std::uint32_t threads = 0;  // 0: one for each processor
  std::uint64_t seed = 0;
  SamplerKind sampler = SamplerKind::kSobol;
  Estimator estimator = Estimator::kPath;
  PathSharing sharing{};
  std::optional<PathExpression> paths{};  // nothing: all light
  double secondsWithoutAnswer = 10.0;
};

// The sampler of this name, a value of `option`; throws UsageError if there is none.
SamplerKind findSampler(const std::string& name, std::string_view option = "--sampler");

// The light path expression that --paths says; throws UsageError, with a caret, if it is none.
PathExpression findPaths(const std::string& text);

// A content hash of the scene as a worker gets it.
std::string sceneHash(const LoadedScene& scene);

// What a render of the scene then lets through.
void letThrough(const PathExpression& paths, const FlatScene& scene, RenderSettings& settings);

RenderSettings settingsFor(const LoadedScene& scene, const RenderOptions& options);

struct RenderOutcome {
  RenderedImage rendered;
  RenderState state;
  StubReport stubs;
};

// Called after each step; returns a line to show, or nothing.
using AfterStep = std::function<std::string(const RenderState&)>;

// Renders with a progress bar, from `state` on if it has begun. Throws WorkerError.
RenderOutcome renderScene(const Coursework& coursework, const LoadedScene& scene,
                          const RenderOptions& options, RenderState state = {},
                          const AfterStep& afterStep = {});

// A worker for renders, whose text goes above the bar; the bar must outlive it.
WorkerProcess::Options workerOptions(const Coursework& coursework, const RenderOptions& options,
                                     ProgressBar& bar);

// A line or two about what a picture lacks; empty if nothing.
std::string unwrittenNote(const LoadedScene& scene, Estimator estimator, const StubReport& stubs);

// "12 NaN, 3 negative".
std::string invalidKinds(const InvalidPixels& invalid);

// A sentence about values that are no radiance; empty if there are none.
std::string invalidSentence(const RenderedImage& image, Estimator estimator);

std::string listOfNames(std::span<const FunctionContract> functions);

}  // namespace pathmark
