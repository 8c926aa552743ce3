#include "grading/class_run.h"

#include "grading/build_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <thread>

namespace pathmark::grading {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using record::SubmissionRecord;
using submission::Submission;

constexpr const char* kNoSandbox = "none";

// As it stands in records.
std::string sourceOf(const fs::path& source) {
  return fs::absolute(source).lexically_normal().string();
}

// How far all are together. Safe to use from several threads.
class Pace {
 public:
  Pace(std::size_t all, const ClassEvents& events) : fractions_(all, 0.0), events_(events) {}

  bool tell(std::size_t submission, double fraction) {
    const std::lock_guard lock(mutex_);
    fractions_[submission] = fraction;
    return tell();
  }

  // One that was known already says nothing about the pace.
  void done(std::size_t submission, const SubmissionRecord& record, bool known) {
    const std::lock_guard lock(mutex_);
    ++done_;
    fractions_[submission] = 1.0;
    if (known) ++known_;
    if (events_.onDone) events_.onDone(record, known);
    tell();
  }

  bool stopped() const { return stopped_; }

 private:
  bool tell() {
    double sum = 0.0;
    for (const double f : fractions_) sum += f;
    const auto all = static_cast<double>(fractions_.size()), known = static_cast<double>(known_);
    const double spent = std::chrono::duration<double>(Clock::now() - started_).count();
    const double made = sum - known, left = all - sum;
    const ClassProgress progress{done_, fractions_.size(), sum / std::max(all, 1.0),
                                 made > 0.05 ? spent / made * left : 0.0};
    if (events_.onProgress && !events_.onProgress(progress)) stopped_ = true;
    return !stopped_;
  }

  std::mutex mutex_;
  std::vector<double> fractions_;
  std::size_t done_ = 0, known_ = 0;
  std::atomic<bool> stopped_{false};
  Clock::time_point started_ = Clock::now();
  const ClassEvents& events_;
};

class ClassRun {
 public:
  ClassRun(const submission::FoundSubmissions& found, const ClassFolder& folder,
           std::shared_ptr<Confinement> confinement, const ClassRunOptions& options,
           const ClassEvents& events)
      : submissions_(found.submissions),
        leftOut_(found.leftOut),
        folder_(folder),
        confinement_(std::move(confinement)),
        options_(options),
        build_(thisBuild(confinement_ ? confinement_->name() : kNoSandbox)),
        graded_(found.submissions.size()),
        pace_(found.submissions.size(), events) {}

  std::vector<std::string> run() {
    // Before hours of work whose records could not be kept.
    for (const Submission& submission : submissions_)
      folder_.expectNoOther(submission.name, sourceOf(submission.source));
    std::map<std::string, std::string> sources = recordLeftOut();
    std::vector<std::thread> others;
    for (unsigned k = 1; k < options_.jobs; ++k) others.emplace_back([this] { work(); });
    work();
    for (std::thread& other : others) other.join();
    if (error_) std::rethrow_exception(error_);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < submissions_.size(); ++i) {
      if (!graded_[i]) continue;
      names.push_back(submissions_[i].name);
      sources.emplace(sourceOf(submissions_[i].source), submissions_[i].name);
    }
    folder_.removeRenamed(sources);
    return names;
  }

 private:
  // By their sources the names of their records.
  std::map<std::string, std::string> recordLeftOut() {
    std::map<std::string, std::string> sources;
    for (const submission::LeftOut& one : leftOut_) {
      const std::string source = sourceOf(one.source);
      Judged nothing;
      nothing.record.name = one.name;
      nothing.record.source = source;
      nothing.record.seed = folder_.seed();
      nothing.record.build = build_;
      nothing.record.leftOut = one.reason;
      folder_.put(nothing);
      sources.emplace(source, one.name);
    }
    return sources;
  }

  void work() {
    try {
      for (std::size_t i = 0; (i = next_++) < submissions_.size() && !stopped();) gradeOne(i);
    } catch (const Interrupted&) {
      // The records that are there stay.
    } catch (...) {
      // The output folder cannot be written any more: nothing that follows could be kept.
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      failed_ = true;
    }
  }

  bool stopped() const { return pace_.stopped() || failed_; }

  // One that ran out of time may go further now: the clock says something of the machine. What a
  // submission did that nothing shut in is not believed where something can.
  bool isSame(const SubmissionRecord& known, const std::string& name,
              const submission::Collected& collected) const {
    return known.name == name && known.contents == collected.contents &&
           known.seed == folder_.seed() && known.build.program == build_.program &&
           known.build.flags == build_.flags && known.build.compiler == build_.compiler &&
           (known.build.sandbox != kNoSandbox || !confinement_) && known.hasMarks() &&
           !known.outOfTime;
  }

  void gradeOne(std::size_t i) {
    const Submission& submission = submissions_[i];
    const std::string& name = submission.name;
    const submission::Collected collected = submission::collect(
        submission, {},
        folder_.whole() ? std::span<const int>() : std::span<const int>(folder_.parts()));
    if (const auto known = folder_.find(name); known && isSame(*known, name, collected)) {
      folder_.noteHandedIn(*known, sourceOf(submission.source), collected);
      graded_[i] = true;
      pace_.done(i, *known, true);
      return;
    }
    Judged judged;
    SubmissionRecord& record = judged.record;
    if (collected.failure.empty()) {
      judged = tryTwice(i, name, collected);
    } else {
      record.leftOut = collected.failure;
    }
    record.name = name;
    record.source = sourceOf(submission.source);
    record.contents = collected.contents;
    record.collecting = collected.remarks;
    record.refusedScenes = collected.refusedScenes;
    record.seed = folder_.seed();
    record.build = build_;
    folder_.put(judged);
    graded_[i] = true;
    pace_.done(i, record, false);
  }

  Judged tryTwice(std::size_t i, const std::string& name, const submission::Collected& collected) {
    std::string failure;
    for (int attempt = 0; attempt < 2; ++attempt) {
      try {
        return judgeOne(i, name, collected);
      } catch (const Interrupted&) {
        throw;
      } catch (const std::exception& e) {
        failure = e.what();
      }
    }
    Judged judged;
    judged.record.failure = fmt::format("The grader, or the machine, failed twice: {}", failure);
    return judged;
  }

  Judged judgeOne(std::size_t i, const std::string& name, const submission::Collected& collected) {
    const fs::path folder = folder_.scratch(name) / "coursework";
    submission::writeOut(collected, folder);
    const auto onProgress = [&](double fraction) { return pace_.tell(i, fraction) && !failed_; };
    Judged judged = judge().judge(folder, options_.threads, onProgress);
    folder_.removeScratch(name);
    return judged;
  }

  // Made for the first submission that needs it.
  Judge& judge() {
    const std::lock_guard lock(judging_);
    if (!judge_) {
      JudgeOptions options;
      options.seed = folder_.seed();
      options.parts = folder_.parts();
      options.whole = folder_.whole();
      options.secondsAtMost = options_.secondsAtMost;
      judge_.emplace(options, confinement_);
    }
    return *judge_;
  }

  const std::vector<Submission>& submissions_;
  const std::vector<submission::LeftOut>& leftOut_;
  const ClassFolder& folder_;
  std::shared_ptr<Confinement> confinement_;
  ClassRunOptions options_;
  record::BuildRecord build_;
  std::vector<std::atomic<bool>> graded_;
  Pace pace_;
  std::mutex mutex_, judging_;
  std::optional<Judge> judge_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::exception_ptr error_;
};

}  // namespace

std::vector<std::string> gradeClass(const submission::FoundSubmissions& found,
                                    const ClassFolder& folder,
                                    std::shared_ptr<Confinement> confinement,
                                    const ClassRunOptions& options, const ClassEvents& events) {
  return ClassRun(found, folder, std::move(confinement), options, events).run();
}

}  // namespace pathmark::grading
