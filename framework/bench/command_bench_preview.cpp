// pathmark bench preview: how long the window waits for new pixels after a save.
//
// Without a window: the engine behind it, with a copy of the coursework whose last file is saved
// again and again with other contents.
#include "bench/alternate.h"
#include "bench/bench_commands.h"
#include "bench/interrupted_run.h"
#include "bench/machine.h"
#include "bench/report.h"
#include "bench/report_file.h"
#include "host/exit_code.h"
#include "host/options.h"
#include "host/session.h"
#include "preview/engine.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <thread>

namespace pathmark::bench {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct BenchPreviewArguments {
  std::vector<std::string> scenes{"cornell_box", "cornell_spheres"};
  std::string with = solvedCoursework();
  std::string json;
  int saves = 7;
};

// A copy of a coursework that can be saved, gone afterwards.
class SavedCoursework {
 public:
  explicit SavedCoursework(const fs::path& from) {
    std::string name = (fs::temp_directory_path() / "pathmark-bench.XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw std::system_error(errno, std::generic_category(), "making a folder");
    folder_ = name;
    for (const PartContract& part : parts()) fs::copy_file(from / part.file, folder_ / part.file);
  }
  ~SavedCoursework() {
    std::error_code error;
    fs::remove_all(folder_, error);
  }
  SavedCoursework(const SavedCoursework&) = delete;
  SavedCoursework& operator=(const SavedCoursework&) = delete;

  // Other contents each time, so that the part is compiled anew. Not to be found in the cache of
  // an earlier run either.
  void save() {
    const auto unique = Clock::now().time_since_epoch().count();
    std::ofstream(folder_ / partNumbered(6).file, std::ios::app) << fmt::format("// {}\n", unique);
  }

  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

class PictureWait {
 public:
  void wake() {
    { const std::lock_guard lock(mutex_); }
    changed_.notify_all();
  }

  // Until there is a picture of another series than `last`.
  std::shared_ptr<const preview::Picture> next(const preview::Engine& engine, std::uint64_t last) {
    constexpr auto kLongest = std::chrono::seconds(60);
    const auto deadline = Clock::now() + kLongest;
    std::unique_lock lock(mutex_);
    for (;;) {
      stopIfInterrupted();
      const auto state = engine.state();
      if (state->picture && state->picture->series > last) return state->picture;
      for (const std::string& failure :
           {state->buildFailure, state->workerFailure, state->sceneFailure})
        if (!failure.empty()) throw CourseworkError(failure);
      if (Clock::now() > deadline) throw CourseworkError("There was no picture for a minute.");
      changed_.wait_for(lock, std::chrono::milliseconds(20));
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
};

// Seconds from a save to the first picture made with it.
std::vector<double> waitsOf(const std::string& scene, const BenchPreviewArguments& arguments) {
  SavedCoursework coursework(findCoursework(arguments.with));
  PictureWait wait;
  preview::EngineRequest request;
  request.with = coursework.folder().string();
  request.scene = findScene(scene);
  request.threads = std::max(1u, std::thread::hardware_concurrency());
  preview::Engine engine(request, [&] { wait.wake(); });
  std::uint64_t series = wait.next(engine, 0)->series;
  std::vector<double> seconds;
  for (int k = 0; k < arguments.saves; ++k) {
    // In the middle of rendering, as a student saves.
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const auto saved = Clock::now();
    coursework.save();
    series = wait.next(engine, series)->series;
    seconds.push_back(std::chrono::duration<double>(Clock::now() - saved).count());
  }
  return seconds;
}

int measure(const BenchPreviewArguments& arguments) {
  Report report{.command = "bench preview", .machine = machineLine(), .tables = {}, .figures = {}};
  try {
    for (const std::string& scene : arguments.scenes) {
      const std::vector<double> seconds = waitsOf(scene, arguments);
      const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
      report.figures.push_back({.key = "save_to_pixels_" + scene,
                                .name = fmt::format("{}: save to new pixels", scene),
                                .value = median(seconds),
                                .unit = "s",
                                .target = Target{1.5, 0.7, false},
                                .note = fmt::format("median of {}, from {:.2f} to {:.2f}",
                                                    seconds.size(), *least, *most)});
    }
  } catch (const Interrupted&) {
    fmt::print(stderr, "Interrupted: no JSON was written.\n");
    return kInterrupted;
  }
  printFigures(report);
  writeJson(arguments.json, report);
  return kSuccess;
}

}  // namespace

void addBenchPreviewCommand(CLI::App& bench, CommandAction& action) {
  const auto arguments = std::make_shared<BenchPreviewArguments>();
  CLI::App* command =
      bench.add_subcommand("preview", "How long the preview waits for new pixels after a save");
  command
      ->add_option("SCENE", arguments->scenes, "Scenes (default: cornell_box and cornell_spheres)")
      ->type_name("");
  command
      ->add_option("--with", arguments->with,
                   "Coursework that is copied and saved: " + courseworkChoices(solvedCoursework()))
      ->type_name("DIR");
  takesWholeNumber(command->add_option("--saves", arguments->saves, "Saves of each (default: 7)"),
                   1, 1000);
  addJsonOption(*command, arguments->json);
  command->footer(
      "Examples:\n"
      "  ./pathmark bench preview\n"
      "  ./pathmark bench preview blob --saves 3\n\n"
      "One file of nine is saved with a new comment, while the picture is being rendered: the\n"
      "time has noticing it, compiling, linking, starting the worker, loading the scene and one\n"
      "ray for each pixel in it.");
  command->callback([arguments, &action] { action = [arguments] { return measure(*arguments); }; });
}

}  // namespace pathmark::bench
