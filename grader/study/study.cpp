#include "study/study.h"

#include "checks/all_checks.h"
#include "host/content_hash.h"
#include "variants/reach.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <future>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace pathmark::study {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

// What a record depends on besides the seed.
std::string keyOf(const StudySubject& subject) {
  std::string text = programHash() + subject.name + (subject.selection.images ? " images " : " ") +
                     subject.selection.only;
  if (subject.variant) text += " " + subject.variant->check;
  for (const CourseworkFunction f : subject.selection.functions)
    text += fmt::format(" {}", contractOf(f).section);
  for (const PartBuild& part : subject.build.parts) text += part.object.filename().string();
  return contentHash(text);
}

Json toJson(const std::string& key, const StudyRecord& record) {
  return {{"key", key},
          {"subject", record.subject},
          {"seed", record.seed},
          {"failed", record.failed},
          {"undecided", record.undecided},
          {"cause", record.cause},
          {"calls", record.calls},
          {"checkSeconds", record.checkSeconds},
          {"distance", record.distance},
          {"farthest", record.farthest},
          {"statistics", record.statistics},
          {"seconds", record.seconds}};
}

// What fails a check without statistics is as far off as can be.
bool isFarther(const checks::CheckResult& result, const StudyRecord& record) {
  if (record.farthest.empty()) return true;
  if (record.distance == 0.0) return false;
  return result.check->delta == 0.0 || result.finding.distance > record.distance;
}

void note(const checks::CheckResult& result, const std::string& named, StudyRecord& record) {
  const checks::Status status = result.finding.status;
  const bool failed = status == checks::Status::kFail || status == checks::Status::kBroken;
  if (failed && (record.failed.empty() || idOf(*result.check) == named)) {
    record.cause = result.finding.cause;
    record.calls = result.finding.calls;
    record.checkSeconds = result.seconds;
  }
  if (failed && isFarther(result, record)) {
    record.distance = result.check->delta > 0.0 ? result.finding.distance : 0.0;
    record.farthest = idOf(*result.check);
  }
  if (failed) record.failed.push_back(idOf(*result.check));
  if (status == checks::Status::kUndecided) record.undecided.push_back(idOf(*result.check));
}

CourseworkFunction functionNamed(const std::string& name) {
  for (const FunctionContract& f : contract())
    if (f.name == name) return f.function;
  throw std::logic_error(name + " is no function of the contract");
}

StudyRecord runOnce(const StudySubject& subject, std::uint64_t seed,
                    const checks::Selection& selection, bool untilWrong) {
  checks::RunOptions options;
  options.seed = seed;
  options.threads = 1;
  options.untilWrong = untilWrong;
  options.diagnose = false;
  const checks::CourseworkResults results = checks::runChecks(subject.build, selection, options);
  StudyRecord record;
  record.subject = subject.name;
  record.seed = seed;
  record.statistics = results.statistics;
  record.seconds = results.seconds;
  const std::string named = subject.variant ? subject.variant->check : "";
  for (const checks::PartResult& part : results.parts) {
    if (!part.failure.empty()) record.failed.push_back(fmt::format("part {}", part.part.part));
    for (const checks::FunctionResult& f : part.functions)
      for (const checks::CheckResult& r : f.checks) note(r, named, record);
  }
  for (const checks::CheckResult& r : results.images) note(r, named, record);
  return record;
}

// How far off a mistake is takes all checks. That the check that it names finds it under other
// seeds too takes that one; where it does not, some other may.
StudyRecord makeRecord(const StudySubject& subject, std::uint64_t seed) {
  const bool quick = seed != 1 && subject.variant && subject.variant->wrong;
  if (quick && !subject.variant->check.empty()) {
    checks::Selection selection = subject.selection;
    selection.only = subject.variant->check;
    selection.functions = {functionNamed(subject.variant->function)};
    StudyRecord record = runOnce(subject, seed, selection, true);
    if (!record.failed.empty()) return record;
  }
  return runOnce(subject, seed, subject.selection, quick);
}

}  // namespace

const std::string& programHash() {
  static const std::string hash = [] {
    std::ifstream in("/proc/self/exe", std::ios::binary);
    return contentHash(std::string(std::istreambuf_iterator<char>(in), {}));
  }();
  return hash;
}

StudyLog::StudyLog(fs::path file) : file_(std::move(file)) {
  fs::create_directories(file_.parent_path());
  std::ifstream in(file_);
  for (std::string line; std::getline(in, line);) {
    // The last line may have been cut off when a study was killed.
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("farthest")) continue;
    StudyRecord record;
    record.subject = json["subject"];
    record.seed = json["seed"];
    record.failed = json["failed"];
    record.undecided = json["undecided"];
    record.cause = json["cause"];
    record.calls = json["calls"];
    record.checkSeconds = json["checkSeconds"];
    record.distance = json["distance"];
    record.farthest = json["farthest"];
    record.statistics = json["statistics"];
    record.seconds = json["seconds"];
    records_[{json["key"], record.seed}] = std::move(record);
  }
}

std::optional<StudyRecord> StudyLog::find(const std::string& key, std::uint64_t seed) const {
  const auto found = records_.find({key, seed});
  return found == records_.end() ? std::nullopt : std::optional(found->second);
}

void StudyLog::add(const std::string& key, const StudyRecord& record) {
  const std::lock_guard lock(mutex_);
  std::ofstream out(file_, std::ios::app);
  out << toJson(key, record).dump() << "\n" << std::flush;
  if (!out)
    throw std::system_error(errno, std::generic_category(),
                            fmt::format("writing {}", file_.string()));
}

StudySubject solutionsSubject(bool images) {
  StudySubject subject{"solutions", {}, {}, {}};
  subject.build = buildCoursework(courseworkFolder("solutions"), Incomplete::kCompileOnly);
  subject.selection.images = images;
  subject.selection.scenes = false;
  if (images) subject.selection.parts.clear();
  return subject;
}

StudySubject variantSubject(const Variant& variant, bool images, const fs::path& scratch) {
  StudySubject subject = solutionsSubject(images);
  const fs::path folder = scratch / variant.name;
  applyVariant(variant, folder);
  // Only the part that is changed comes from there; the others keep their objects.
  const std::size_t part = placeOfPart(variant.part);
  subject.build.parts[part] = compilePart(folder, variant.part);
  subject.name = variant.name;
  subject.variant = variant;
  subject.selection.parts = {variant.part};
  if (!variant.wrong)
    subject.selection.functions =
        functionsThatMayDifferIn(variant.part, subject.build.folder, folder);
  return subject;
}

std::vector<StudyRecord> runStudy(const std::vector<StudySubject>& subjects, int seeds,
                                  unsigned threads, StudyLog& log,
                                  const std::function<bool(const StudyProgress&)>& goOn) {
  struct Job {
    const StudySubject* subject;
    std::string key;
    std::uint64_t seed;
    std::optional<StudyRecord> record;
  };
  std::vector<Job> jobs;
  for (const StudySubject& subject : subjects) {
    const std::string key = keyOf(subject);
    for (int seed = 1; seed <= seeds; ++seed) {
      const auto number = static_cast<std::uint64_t>(seed);
      jobs.push_back({&subject, key, number, log.find(key, number)});
    }
  }
  const auto known = static_cast<std::size_t>(
      std::count_if(jobs.begin(), jobs.end(), [](const Job& j) { return j.record.has_value(); }));
  std::atomic<std::size_t> next{0}, made{0};
  std::mutex asking;
  const auto started = Clock::now();
  const auto work = [&] {
    for (std::size_t i = 0; (i = next++) < jobs.size();) {
      Job& job = jobs[i];
      if (job.record) continue;
      {
        const std::lock_guard lock(asking);
        const double seconds = std::chrono::duration<double>(Clock::now() - started).count();
        const auto done = static_cast<double>(made.load());
        const auto left = static_cast<double>(jobs.size() - known) - done;
        if (!goOn({known + made, jobs.size(), done > 0.0 ? seconds / done * left : 0.0})) return;
      }
      job.record = makeRecord(*job.subject, job.seed);
      log.add(job.key, *job.record);
      ++made;
    }
  };
  std::vector<std::future<void>> others;
  for (unsigned k = 1; k < threads; ++k) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
  std::vector<StudyRecord> records;
  for (Job& job : jobs)
    if (job.record) records.push_back(std::move(*job.record));
  return records;
}

}  // namespace pathmark::study
