// pathmark grade: from what a class has handed in to marks with reasons.
#include "commands/commands.h"
#include "commands/grade.h"
#include "film/atomic_file.h"
#include "grading/class_folder.h"
#include "grading/class_run.h"
#include "grading/write_reports.h"
#include "host/display_path.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/progress_bar.h"
#include "host/session.h"
#include "rubric/rubric.h"
#include "sandbox/sandbox.h"
#include "scene/syntax_sentence.h"
#include "submission/names.h"
#include "submission/submission.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

std::string timeInWords(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 5400.0) return fmt::format("{:.0f} min", std::ceil(seconds / 60.0));
  return fmt::format("{:.0f} h {:02.0f} min", std::floor(seconds / 3600.0),
                     std::floor(std::fmod(seconds, 3600.0) / 60.0));
}

// Records that are only marked anew may be of any parts.
grading::RunAsked runAsked(const GradeArguments& arguments) {
  grading::RunAsked asked{arguments.seed, {}, arguments.only.empty()};
  if (arguments.what.empty() && arguments.only.empty()) return asked;
  for (const PartContract& part : parts()) {
    const std::string number = std::to_string(part.part);
    if (arguments.only.empty() || arguments.only == number || arguments.only == "part" + number)
      asked.parts.push_back(part.part);
  }
  if (asked.parts.empty())
    throw UsageError(
        fmt::format("--only: found {}, allowed is a part: part0 to part6, and the "
                    "bonus parts part8 and part9.",
                    arguments.only));
  return asked;
}

// --only 3 and --only part3 are the same.
fs::path outOf(const GradeArguments& arguments, const grading::RunAsked& asked) {
  if (!arguments.out.empty()) return arguments.out;
  return arguments.only.empty() ? "grades" : fmt::format("grades-part{}", asked.parts.front());
}

// An instructor may keep both in one folder.
void forgetOutput(submission::FoundSubmissions& found, const fs::path& out) {
  const std::string whole = fs::weakly_canonical(out).string(),
                    begin = fmt::format("\"{}\" ", shown(whole, whole.size()));
  std::erase_if(found.leftOut, [&](const auto& one) { return one.source == whole; });
  std::erase_if(found.remarks, [&](const auto& remark) { return remark.starts_with(begin); });
}

submission::FoundSubmissions findAll(const GradeArguments& arguments, const fs::path& out) {
  if (arguments.what.empty()) return {};
  const std::vector<fs::path> paths(arguments.what.begin(), arguments.what.end());
  submission::FoundSubmissions found =
      submission::findSubmissions(paths, grading::gradedNames(out));
  if (!found.missing.empty())
    throw UsageError(
        fmt::format("{}: there is no such file or folder.", fmt::join(found.missing, ", ")));
  forgetOutput(found, out);
  for (const std::string& remark : found.remarks) fmt::print(stderr, "{}\n", remark);
  if (found.submissions.empty())
    throw UsageError(
        "There is no submission here: it is a folder or an archive with part*.cpp files, or a "
        "folder of such.");
  return found;
}

// Says in a line of its own what is done; on a terminal a bar stands below.
class Screen {
 public:
  explicit Screen(std::size_t all) : all_(all) {}

  grading::ClassEvents events() {
    grading::ClassEvents events;
    events.onProgress = [this](const grading::ClassProgress& p) {
      bar_.show(p.fraction, p.secondsLeft > 0.0 ? fmt::format("{} of {}, {} left", p.done, p.all,
                                                              timeInWords(p.secondsLeft))
                                                : fmt::format("{} of {}", p.done, p.all));
      left_ = p.secondsLeft;
      return !interrupted();
    };
    events.onDone = [this](const record::SubmissionRecord& record, bool known) {
      tell(record, known);
    };
    return events;
  }

  void clear() { bar_.clear(); }

 private:
  void tell(const record::SubmissionRecord& record, bool known) {
    ++done_;
    if (known) return;
    std::string line = fmt::format("[{}/{}] {}: ", done_, all_, record.name);
    line += record.leftOut.empty() ? fmt::format("{:.1f} s", record.seconds)
                                   : fmt::format("not graded. {}", record.leftOut);
    if (record.internalError()) line += "; " + record.failure;
    if (record.outOfTime) line += ", out of time: the same command grades it anew";
    if (done_ < all_ && left_ > 0.0) line += fmt::format("; {} left", timeInWords(left_));
    bar_.printAbove(line + "\n");
  }

  ProgressBar bar_{"grade"};
  std::size_t all_, done_ = 0;
  double left_ = 0.0;
};

constexpr const char* kDefaultRubric = "default";

// The rubric that the class was marked by before, where it was another than the project's own.
fs::path keptRubric(const fs::path& out) { return out / "rubric.json"; }

fs::path rubricFor(const GradeArguments& arguments, const fs::path& out) {
  if (arguments.rubric == kDefaultRubric) return rubric::defaultRubric();
  if (!arguments.rubric.empty()) return arguments.rubric;
  return fs::exists(keptRubric(out)) ? keptRubric(out) : rubric::defaultRubric();
}

rubric::Rubric readRubric(const fs::path& file) {
  try {
    return rubric::readRubric(file);
  } catch (const rubric::RubricError& e) {
    throw UsageError(e.what());
  }
}

// Later runs, with late submissions, mark by it too.
void keepRubric(const fs::path& file, const fs::path& out) {
  std::error_code none;
  if (fs::equivalent(file, keptRubric(out), none)) return;
  if (fs::equivalent(file, rubric::defaultRubric(), none)) {
    fs::remove(keptRubric(out));
    return;
  }
  std::ifstream in(file, std::ios::binary);
  writeFileAtomically(keptRubric(out), std::string(std::istreambuf_iterator<char>(in), {}));
}

std::vector<std::string> notGradedYet(const std::vector<submission::Submission>& submissions,
                                      const grading::ClassFolder& folder) {
  std::vector<std::string> names;
  for (const submission::Submission& one : submissions)
    if (!fs::exists(folder.folderOf(one.name) / "record.json")) names.push_back(one.name);
  return names;
}

std::shared_ptr<Confinement> openSandboxFor(const GradeArguments& arguments) {
  if (!arguments.sandbox.empty()) {
    for (const sandbox::Tier tier : {sandbox::Tier::kBubblewrap, sandbox::Tier::kLandlock})
      if (submission::lowerCase(nameOf(tier)) == submission::lowerCase(arguments.sandbox))
        return sandbox::openSandbox(tier);
    throw UsageError(
        fmt::format("--sandbox: found {}, allowed is bubblewrap or landlock.", arguments.sandbox));
  }
  const sandbox::Opened opened = sandbox::openStrongest(arguments.unsafe);
  if (!opened.confinement)
    fmt::print(stderr,
               "No sandbox works here: submissions can read and change what you can (--unsafe).\n");
  return opened.confinement;
}

}  // namespace

int grade(const GradeArguments& arguments) {
  const grading::RunAsked asked = runAsked(arguments);
  const fs::path out = outOf(arguments, asked), rubricFile = rubricFor(arguments, out);
  const rubric::Rubric rubric = readRubric(rubricFile);
  const submission::FoundSubmissions found = findAll(arguments, out);
  const std::vector<submission::Submission>& submissions = found.submissions;
  if (submissions.empty() && !grading::holdsGrades(out))
    throw UsageError(
        "Name what is to be graded: folders or archives with part*.cpp files, or a folder of "
        "such.");
  const auto sandbox = submissions.empty() ? nullptr : openSandboxFor(arguments);
  const grading::ClassFolder folder(out, asked);
  keepRubric(rubricFile, out);

  std::size_t graded = 0;
  if (!submissions.empty()) {
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    grading::ClassRunOptions options;
    options.jobs = std::min<unsigned>(arguments.jobs != 0 ? arguments.jobs : processors,
                                      static_cast<unsigned>(submissions.size()));
    options.threads = std::max(1u, processors / options.jobs);
    options.secondsAtMost = arguments.secondsAtMost;
    Screen screen(submissions.size());
    graded = grading::gradeClass(found, folder, sandbox, options, screen.events()).size();
    screen.clear();
  }
  const grading::ClassReports reports =
      grading::writeReports(folder, rubric, notGradedYet(submissions, folder));
  fmt::print("{}", reports.table(isatty(STDOUT_FILENO) == 1));
  fmt::print("\nReports: {}; marks: {}; seed {}\n", displayPath(folder.path() / "report.html"),
             displayPath(folder.path() / "marks.csv"), folder.seed());
  if (fs::exists(keptRubric(out)))
    fmt::print("Marked by {}; --rubric default takes the project's own again.\n",
               displayPath(keptRubric(out)));
  for (const std::string& name : reports.unreadable())
    fmt::print(stderr,
               "{}: this record is damaged, so that there are no marks; grade the submission "
               "again.\n",
               displayPath(folder.folderOf(name) / "record.json"));
  // Nothing is left to do after the last one, whenever Ctrl-C came.
  if (graded < submissions.size()) {
    fmt::print(stderr, "Interrupted; {} goes on from here.\n", arguments.goOnWith);
    return kInterrupted;
  }
  return reports.anyFailed() ? kMachineFault : kSuccess;
}

void addGradeCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<GradeArguments>();
  CLI::App* command =
      app.add_subcommand("grade", "Give marks, with reasons, to a class's submissions");
  command
      ->add_option("submission", arguments->what,
                   "Folders, zips or tars with part*.cpp files, or folders of such; none: only "
                   "make marks and reports anew, of what was graded before")
      ->type_name("SUBMISSION");
  command
      ->add_option("--out", arguments->out,
                   "Where records, marks and reports go (grades/); what is graded there already is "
                   "not graded again")
      ->type_name("DIR");
  takesWholeNumber(command->add_option("--seed", arguments->seed,
                                       "Of all random inputs; by default one that nobody can "
                                       "guess, which the folder keeps"),
                   0, std::int64_t{1} << 53);
  takesWholeNumber(command->add_option("--jobs", arguments->jobs,
                                       "Submissions that are graded at the same time; one for each "
                                       "processor by default"),
                   1, 1024);
  command
      ->add_option("--rubric", arguments->rubric,
                   "Points and bands (grader/rubric/rubric.json); records are marked anew, and "
                   "the folder keeps a copy, by which later runs mark: default takes the "
                   "project's own again")
      ->type_name("FILE");
  command->add_option("--only", arguments->only, "Only this part, without pictures of the whole")
      ->type_name("PART");
  takesSeconds(command->add_option("--time-limit", arguments->secondsAtMost,
                                   "For a whole submission by the clock, from compiling to its "
                                   "last picture (600): so it depends on the machine and on "
                                   "--jobs. What is not done by then counts as too slow, until "
                                   "it is graded anew"),
               1.0, 86400.0);
  command
      ->add_option("--sandbox", arguments->sandbox,
                   "bubblewrap or landlock; by default the stronger one that works")
      ->type_name("TIER");
  command->add_flag("--unsafe", arguments->unsafe,
                    "Also where no sandbox works: submissions can then do whatever you can");
  command->footer(
      "Examples:\n"
      "  ./pathmark grade submissions/\n"
      "  ./pathmark grade a.zip b.tar.gz c/ --out week3 --only part3\n"
      "  ./pathmark grade submissions/ --jobs 1 --seed 7\n"
      "  ./pathmark grade --out grades --rubric mine.json     (marks anew, nothing is run)\n\n"
      "Ctrl-C keeps what is done; the same command goes on, and grades anew what ran out of "
      "time.\n"
      "What cannot be graded, such as an archive that is damaged or a folder without part*.cpp, "
      "has a row without marks, and the reason.\n"
      "Exit code: 0 if all others have marks, whatever these are; 2 for a wrong command line; 3 if "
      "the grader or the machine failed at one, or its record is damaged; 130 if interrupted "
      "before the last one.");
  command->callback([arguments, &action] { action = [arguments] { return grade(*arguments); }; });
}

}  // namespace pathmark
