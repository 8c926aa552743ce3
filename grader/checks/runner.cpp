#include "checks/runner.h"

#include "checks/all_checks.h"
#include "checks/check_bench.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/probes.h"
#include "host/stub_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <numeric>
#include <optional>
#include <thread>

namespace pathmark::checks {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

FunctionResult* functionIn(PartResult& part, CourseworkFunction f) {
  for (FunctionResult& result : part.functions)
    if (result.function.function == f) return &result;
  return nullptr;
}

// What stands in the way of this check, by the results so far: a function that it needs. One that
// is undecided stands in nobody's way: nothing wrong was found in it.
std::string blockedBy(const Check& check, PartResult& part) {
  for (const CourseworkFunction f : check.needs) {
    const FunctionResult* needed = functionIn(part, f);
    if (needed && severity(needed->status) > severity(Status::kUndecided))
      return fmt::format("{} {}", needed->function.section, needed->function.name);
  }
  return {};
}

void addResult(FunctionResult& function, CheckResult result) {
  if (severity(result.finding.status) > severity(function.status))
    function.status = result.finding.status;
  function.checks.push_back(std::move(result));
}

// Functions that the selected checks need are checked too, though nobody asked for them: unless it
// was said which functions to look at.
bool isNeeded(const Check& check, std::span<const Check> all, const Selection& selection) {
  return selection.selects(check.function) &&
         std::any_of(all.begin(), all.end(), [&](const Check& other) {
           return selection.selects(other) && std::find(other.needs.begin(), other.needs.end(),
                                                        check.function) != other.needs.end();
         });
}

// Throws WorkerStopped if it may not go on.
void checkFunctions(PartResult& part, CheckBench& bench, const Selection& selection,
                    const RunOptions& options, stats::ErrorBudget& budget, RunProgress& progress) {
  const StubReport stubs = makeStubReport(bench.worker().stubs());
  const std::span<const Check> all = checksOfPart(part.part.part);
  for (const FunctionContract& f : contract()) {
    if (f.part != part.part.part) continue;
    part.functions.push_back(
        {f, stubs.isUnwritten(f.function) ? Status::kNotWritten : Status::kPass, {}});
  }
  for (const Check& check : all) {
    FunctionResult& function = *functionIn(part, check.function);
    if (!selection.selects(check) && !isNeeded(check, all, selection)) continue;
    const bool enough = options.untilWrong && function.status == Status::kFail;
    if (function.status == Status::kNotWritten || function.status == Status::kBroken || enough) {
      progress.done();
      continue;
    }
    if (!progress.goesOn()) throw WorkerStopped();
    progress.begun(check);
    CheckResult result{&check, {}, 0.0};
    const auto started = Clock::now();
    if (const std::string blocker = blockedBy(check, part); !blocker.empty()) {
      result.finding.status = Status::kBlocked;
      result.finding.cause = blocker;
    } else {
      result.finding = bench.make(check, budget);
    }
    result.seconds = secondsSince(started);
    addResult(function, std::move(result));
    progress.done();
  }
  std::erase_if(part.functions, [&](const FunctionResult& f) {
    if (!f.checks.empty()) return false;
    return !selection.selects(f.function.function) ||
           (!selection.only.empty() && !selection.only.starts_with(f.function.section));
  });
}

// What a known mistake explains is said once, with the first check that fails: the checks guess at
// causes by themselves, each from what it has seen alone.
void tell(const diagnosis::Diagnosis& diagnosis, FunctionResult& function) {
  bool said = false;
  for (CheckResult& result : function.checks) {
    if (result.finding.status != Status::kFail) continue;
    result.finding.cause = said ? std::string() : diagnosis.what;
    result.finding.evidence = said ? std::string() : diagnosis.evidence;
    said = true;
  }
  function.diagnosis = diagnosis;
}

// The functions that are wrong are asked once more, as the known mistakes were: by a worker that
// has been asked nothing before, since a mistake may be to keep something from one call to the
// next. Throws WorkerStopped if it may not go on.
void diagnose(PartResult& part, CheckBench& bench) {
  const diagnosis::Catalogue& catalogue = diagnosis::shippedCatalogue();
  for (FunctionResult& function : part.functions) {
    const CourseworkFunction f = function.function.function;
    const diagnosis::FunctionCatalogue* known = catalogue.find(f);
    if (function.status != Status::kFail || known == nullptr) continue;
    try {
      bench.forget();
      const diagnosis::Signature seen =
          diagnosis::probe(bench.worker(), f, diagnosis::ProbeSeed::kCatalogue);
      const diagnosis::Diagnosis found = diagnosis::diagnose(seen, *known);
      if (!found.mistake.empty()) tell(found, function);
    } catch (const WorkerError&) {
      // What the checks have found stands, without a name.
      bench.forget();
    }
  }
}

// Nothing if it may not go on.
std::optional<PartResult> checkPart(const CourseworkBuild& build, int number,
                                    const Selection& selection, const RunOptions& options,
                                    stats::ErrorBudget& budget, RunProgress& progress) {
  const PartBuild& compiled = build.parts.at(placeOfPart(number));
  PartResult part{compiled.part, {}, {}, {}};
  if (!progress.goesOn()) return std::nullopt;
  if (!compiled.compiled) {
    part.failure = compiled.problem();
    if (!compiled.missing) part.failure += ":" + compiled.messages;
    return part;
  }
  const LinkedWorker linked = linkWithStandIns(build, std::array{number});
  if (linked.worker.empty()) {
    part.failure = "does not link: " + linked.failure;
    return part;
  }
  CheckBench bench(linked.worker, build, options, progress);
  try {
    checkFunctions(part, bench, selection, options, budget, progress);
    if (options.diagnose) diagnose(part, bench);
  } catch (const WorkerError& e) {
    part.failure = std::string("cannot be started: ") + e.what();
    part.fault = e.fault();
  } catch (const WorkerStopped&) {
    return std::nullopt;
  }
  return part;
}

// A picture shows all parts at once: it says something only where each of them is right.
std::string blockingPart(const CourseworkResults& results) {
  for (const PartResult& part : results.parts) {
    if (part.part.part == 0 || part.part.bonus) continue;
    if (!part.failure.empty()) return fmt::format("part {}", part.part.part);
    for (const FunctionResult& f : part.functions)
      if (f.status != Status::kPass && f.status != Status::kUndecided)
        return fmt::format("part {}: {} {}", part.part.part, f.function.section, f.function.name);
  }
  return {};
}

// The first function, or part, without which there is no picture.
std::string missing(const CourseworkBuild& build, CheckBench* bench) {
  for (const PartBuild& part : build.parts)
    if (!part.compiled && !part.part.bonus)
      return fmt::format("part {}, which {}", part.part.part, part.problem());
  if (bench == nullptr) return {};
  const StubReport stubs = makeStubReport(bench->worker().stubs());
  for (const FunctionContract& f : stubs.unwritten)
    if (f.part != 0 && !isBonus(f)) return fmt::format("part {}: {} {}", f.part, f.section, f.name);
  return {};
}

// The whole coursework in one worker, if it can be made and nothing is known to be wrong with it.
struct Whole {
  std::string blocker;
  std::string failure;
  std::optional<WorkerFault> fault;
  std::unique_ptr<CheckBench> bench;
};

Whole linkWhole(const CourseworkResults& results, const CourseworkBuild& build,
                const RunOptions& options, RunProgress& progress) {
  Whole whole;
  whole.blocker = blockingPart(results);
  if (whole.blocker.empty()) whole.blocker = missing(build, nullptr);
  if (!whole.blocker.empty()) return whole;
  const LinkedWorker linked = linkWithStandIns(build, std::array{0, 1, 2, 3, 4, 5, 6});
  whole.failure = linked.failure;
  if (linked.worker.empty()) return whole;
  whole.bench = std::make_unique<CheckBench>(linked.worker, build, options, progress);
  try {
    whole.blocker = missing(build, whole.bench.get());
  } catch (const WorkerError& e) {
    whole.failure = e.what();
    whole.fault = e.fault();
  }
  if (!whole.blocker.empty() || !whole.failure.empty()) whole.bench.reset();
  return whole;
}

bool isWrong(Status status) { return status == Status::kFail || status == Status::kBroken; }

bool anyWrong(std::span<const CheckResult> results) {
  return std::any_of(results.begin(), results.end(),
                     [](const CheckResult& r) { return isWrong(r.finding.status); });
}

void checkImages(CourseworkResults& results, Whole& whole, const Selection& selection,
                 stats::ErrorBudget& budget, RunProgress& progress) {
  for (const Check& check : imageChecks()) {
    if (!selection.selects(check)) continue;
    if (!progress.goesOn()) return;
    progress.begun(check);
    CheckResult result{&check, {}, 0.0};
    const auto started = Clock::now();
    if (whole.bench) {
      result.finding = whole.bench->make(check, budget);
    } else if (!whole.blocker.empty()) {
      result.finding.status = Status::kBlocked;
      result.finding.cause = whole.blocker;
    } else {
      result.finding.status = Status::kBroken;
      result.finding.got = whole.failure;
      result.finding.fault = whole.fault;
    }
    result.seconds = secondsSince(started);
    // Of pictures that are wrong it says nothing how much noise they have.
    if (anyWrong(results.images)) result.finding.remark.clear();
    results.images.push_back(std::move(result));
    progress.done();
  }
}

void addKnown(CourseworkResults& results, const CourseworkResults& known,
              const Selection& selection) {
  const std::vector<int>& selected = selection.parts;
  for (const PartResult& part : known.parts)
    if (std::find(selected.begin(), selected.end(), part.part.part) == selected.end())
      results.parts.push_back(part);
  std::sort(results.parts.begin(), results.parts.end(),
            [](const PartResult& a, const PartResult& b) { return a.part.part < b.part.part; });
}

void checkOwnScenes(CourseworkResults& results, Whole& whole, const CourseworkBuild& build,
                    const RunOptions& options, RunProgress& progress) {
  WholeWorker worker;
  worker.blocker = whole.blocker.empty() ? whole.failure : whole.blocker;
  worker.get = [&]() -> WorkerProcess& { return whole.bench->worker(); };
  worker.forget = [&] { whole.bench->forget(); };
  worker.goOn = [&] { return progress.goesOn(); };
  results.scenes = checkScenes(build.folder, worker, options.seed);
}

// Places of the parts in the order in which they are begun: with several threads those whose checks
// take longest come first, so that no processor is left with one of them at the end.
std::vector<std::size_t> orderOf(const std::vector<int>& parts, unsigned threads) {
  constexpr std::array kOrder{5, 2, 8, 9, 0, 4, 3, 1, 6};
  std::vector<std::size_t> places;
  if (threads == 1) {
    places.resize(parts.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    return places;
  }
  for (const int part : kOrder)
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (parts[k] == part) places.push_back(k);
  return places;
}

// Several at the same time; those that were done before it could not go on.
std::vector<PartResult> checkParts(const CourseworkBuild& build, const Selection& selection,
                                   const RunOptions& options, stats::ErrorBudget& budget,
                                   RunProgress& progress) {
  std::vector<std::optional<PartResult>> checked(selection.parts.size());
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  const unsigned threads = options.threads != 0 ? options.threads : processors;
  const std::vector<std::size_t> order = orderOf(selection.parts, threads);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = 0; (i = next++) < order.size();) {
      const std::size_t place = order[i];
      checked[place] =
          checkPart(build, selection.parts[place], selection, options, budget, progress);
      if (checked[place]) progress.done(*checked[place]);
    }
  };
  std::vector<std::future<void>> others;
  for (unsigned k = 1; k < threads; ++k) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
  std::vector<PartResult> parts;
  for (std::optional<PartResult>& part : checked)
    if (part) parts.push_back(std::move(*part));
  return parts;
}

// Pictures and scenes, with all parts together.
void checkWhole(CourseworkResults& results, const CourseworkBuild& build,
                const Selection& selection, const RunOptions& options, stats::ErrorBudget& budget,
                RunProgress& progress) {
  if (!selection.images && !selection.scenes) return;
  try {
    Whole whole = linkWhole(results, build, options, progress);
    if (selection.images) checkImages(results, whole, selection, budget, progress);
    if (selection.scenes) checkOwnScenes(results, whole, build, options, progress);
  } catch (const WorkerStopped&) {
    // What was done until then stays.
  }
}

std::size_t countSelected(const Selection& selection) {
  std::size_t count = 0;
  for (const int part : selection.parts) {
    const std::span<const Check> all = checksOfPart(part);
    for (const Check& check : all)
      count += selection.selects(check) || isNeeded(check, all, selection) ? 1 : 0;
  }
  for (const Check& check : imageChecks()) count += selection.selects(check) ? 1 : 0;
  return count;
}

}  // namespace

bool Selection::selects(const Check& check) const {
  if (check.whole && !images) return false;
  if (!check.whole && !selects(check.function)) return false;
  if (only.empty()) return true;
  const std::string id = idOf(check);
  return id == only || id.starts_with(only + "/");
}

bool Selection::selects(CourseworkFunction function) const {
  return functions.empty() ||
         std::find(functions.begin(), functions.end(), function) != functions.end();
}

bool isBonusNotBegun(const PartResult& part) {
  return part.part.bonus && part.failure.empty() &&
         std::all_of(part.functions.begin(), part.functions.end(),
                     [](const FunctionResult& f) { return f.status == Status::kNotWritten; });
}

int severity(Status status) {
  switch (status) {
    case Status::kPass:
      return 0;
    case Status::kUndecided:
      return 1;
    case Status::kBlocked:
      return 2;
    case Status::kNotWritten:
      return 3;
    case Status::kFail:
      return 4;
    case Status::kBroken:
      break;
  }
  return 5;
}

const FunctionResult* CourseworkResults::find(CourseworkFunction function) const {
  for (const PartResult& part : parts)
    for (const FunctionResult& f : part.functions)
      if (f.function.function == function) return &f;
  return nullptr;
}

bool CourseworkResults::anythingWrong() const {
  for (const PartResult& part : parts) {
    if (!part.failure.empty()) return true;
    for (const FunctionResult& f : part.functions)
      if (isWrong(f.status)) return true;
  }
  return anyWrong(images) || std::any_of(scenes.begin(), scenes.end(),
                                         [](const SceneFinding& s) { return isWrong(s.status); });
}

CourseworkResults runChecks(const CourseworkBuild& build, const Selection& selection,
                            const RunOptions& options, const RunEvents& events) {
  const auto started = Clock::now();
  CourseworkResults results;
  results.seed = options.seed;
  stats::ErrorBudget budget;
  RunProgress progress(std::max<std::size_t>(countSelected(selection), 1), events);
  results.parts = checkParts(build, selection, options, budget, progress);
  const bool stopped = results.parts.size() < selection.parts.size();
  if (options.known) addKnown(results, *options.known, selection);
  results.seconds = secondsSince(started);
  if (!stopped) {
    if (events.onFunctions) events.onFunctions(results);
    checkWhole(results, build, selection, options, budget, progress);
  }
  results.seconds = secondsSince(started);
  results.statistics = budget.taken();
  return results;
}

}  // namespace pathmark::checks
