#include "bench/targets/marking_times.h"

#include "bench/targets/own_command.h"
#include "host/session.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <chrono>
#include <fstream>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

// Other contents than ever before, so that nothing compiled earlier fits.
void touch(const fs::path& file) {
  const auto unique = std::chrono::steady_clock::now().time_since_epoch().count();
  std::ofstream(file, std::ios::app) << fmt::format("// {}\n", unique);
}

// What is asked of everybody: without the bonus parts.
void copyAskedParts(const fs::path& from, const fs::path& to) {
  fs::create_directories(to);
  for (const PartContract& part : parts())
    if (!part.bonus)
      fs::copy_file(from / part.file, to / part.file, fs::copy_options::overwrite_existing);
}

}  // namespace

void addMarkingTimes(const fs::path& coursework, const fs::path& scratch, Progress& progress,
                     Report& report) {
  const fs::path copy = scratch / "submission", log = scratch / "log.txt";
  copyAskedParts(coursework, copy);
  progress.show("check");
  runOwn({"check", "--with", copy.string()}, log);  // compiles all parts
  progress.advance(10.0);
  touch(copy / partNumbered(3).file);
  const OwnRun check = runOwn({"check", "--with", copy.string()}, log, "functions are right");
  progress.advance(10.0);
  report.figures.push_back({.key = "checkFirstAnswer",
                            .name = "check after a save: which functions are right",
                            .value = check.saidSeconds,
                            .unit = "s",
                            .target = Target{3.0, 1.0, false}});
  report.figures.push_back({.key = "checkAll",
                            .name = "check after a save: all functions and pictures",
                            .value = check.usage.wallSeconds,
                            .unit = "s",
                            .target = Target{20.0, 8.0, false}});
  if (solvedCoursework() == "student") return;  // a student's kit, which has no grader
  progress.show("grade");
  for (const auto& file : fs::directory_iterator(copy)) touch(file.path());
  const OwnRun grade =
      runOwn({"grade", copy.string(), "--out", (scratch / "grades").string()}, log);
  progress.advance(20.0);
  report.figures.push_back({.key = "gradeOne",
                            .name = "marking one submission, compile included",
                            .value = grade.usage.wallSeconds,
                            .unit = "s",
                            .target = Target{60.0, 20.0, false}});
}

}  // namespace pathmark::bench
