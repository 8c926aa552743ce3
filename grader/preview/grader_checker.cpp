// The preview window's Checker: `pathmark check` without pictures, again and again.
#include "commands/check_session.h"
#include "commands/hints.h"
#include "preview/check_report.h"
#include "preview/checker.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <utility>

namespace pathmark {

namespace {

using preview::CheckerOptions;
using preview::CheckReport;

using OnReport = std::function<void(std::shared_ptr<const CheckReport>)>;

// Reports between the beginning of a run and its end.
class RunningReport {
 public:
  RunningReport(const CheckSession& session, const CourseworkBuild& build, std::uint64_t number,
                std::uint64_t seed, const OnReport& onReport)
      : number_(number), folder_(build.folder), onReport_(onReport) {
    const std::vector<int> changed = session.changedParts(build);
    known_.seed = seed;
    for (const checks::PartResult& part : session.results().parts)
      if (std::find(changed.begin(), changed.end(), part.part.part) == changed.end())
        known_.parts.push_back(part);
  }

  void progress(double fraction, const std::string& id) {
    fraction_ = fraction;
    current_ = id;
    tell();
  }

  void add(const checks::PartResult& part) {
    known_.parts.push_back(part);
    tell();
  }

 private:
  void tell() {
    CheckReport report = reportOf(known_, number_, folder_);
    report.fraction = fraction_;
    report.current = current_;
    onReport_(std::make_shared<const CheckReport>(std::move(report)));
  }

  std::uint64_t number_;
  const std::filesystem::path& folder_;
  const OnReport& onReport_;
  checks::CourseworkResults known_;
  double fraction_ = 0.0;
  std::string current_;
};

class GraderChecker : public preview::Checker {
 public:
  explicit GraderChecker(CheckerOptions options)
      : options_(std::move(options)), session_(functionsOnly(), runOptions(options_)) {}

  void check(const CourseworkBuild& build, std::uint64_t number, std::stop_token stop,
             const OnReport& onReport) override {
    try {
      checkNow(build, number, stop, onReport);
    } catch (const std::exception& e) {
      if (stop.stop_requested()) return;
      CheckReport report = reportOf({}, number, build.folder);
      report.finished = true;
      report.headline = fmt::format("Nothing could be checked: {}", e.what());
      onReport(std::make_shared<const CheckReport>(std::move(report)));
    }
  }

  std::vector<std::string> hints(CourseworkFunction function) override {
    try {
      return hintsFor(contractOf(function));
    } catch (const std::exception& e) {
      return {e.what()};
    }
  }

 private:
  static checks::Selection functionsOnly() {
    checks::Selection selection;
    selection.images = selection.scenes = false;
    return selection;
  }

  static checks::RunOptions runOptions(const CheckerOptions& options) {
    checks::RunOptions run;
    run.seed = options.seed;
    run.threads = options.threads;
    return run;
  }

  void checkNow(const CourseworkBuild& build, std::uint64_t number, std::stop_token stop,
                const OnReport& onReport) {
    RunningReport running(session_, build, number, options_.seed, onReport);
    checks::RunEvents events;
    events.goOn = [&] { return !stop.stop_requested(); };
    events.onProgress = [&](double fraction, const std::string& id) {
      running.progress(fraction, id);
    };
    events.onPart = [&](const checks::PartResult& part) { running.add(part); };
    const checks::CourseworkResults& results = session_.run(build, events);
    if (stop.stop_requested()) return;
    onReport(std::make_shared<const CheckReport>(finishedReport(results, number, build.folder)));
  }

  CheckerOptions options_;
  CheckSession session_;
};

}  // namespace

std::unique_ptr<preview::Checker> preview::makeChecker(const CheckerOptions& options) {
  return std::make_unique<GraderChecker>(options);
}

}  // namespace pathmark
