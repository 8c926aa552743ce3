// pathmark study: do the checks accept what is right and find what is wrong, under many seeds?
#include "commands/commands.h"
#include "diagnosis/catalogue.h"
#include "film/atomic_file.h"
#include "host/build_config.h"
#include "host/exit_code.h"
#include "host/interrupt.h"
#include "host/options.h"
#include "host/progress_bar.h"
#include "host/session.h"
#include "rubric/rubric.h"
#include "study/diagnosis_study.h"
#include "study/kill_table.h"
#include "study/marks_study.h"
#include "study/study.h"
#include "study/study_report.h"
#include "worker/contract.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

struct StudyArguments {
  std::vector<std::string> what;
  int seeds = 0;  // 0: as many as are usual
  unsigned threads = 0;
  bool images = false;
  bool catalogue = false;
  bool diagnosis = false;
  bool marks = false;
  std::string handout;
  std::string log = (fs::path(build::kBuildFolder) / "study/records.jsonl").string();
};

// Small errors: about twice the smallest that the checks promise to find.
constexpr const char* kSlight = "slight";

// Files that are tried on the diagnosis: with a mistake and a difference, and with two mistakes.
constexpr std::size_t kMostFiles = 90;

// Checks are tried under many seeds. Marks are of one for each variant by default: they follow from
// the checks, and from pictures whose intervals allow for noise.
int seedsOf(const StudyArguments& arguments) {
  return arguments.seeds != 0 ? arguments.seeds : arguments.marks ? 1 : 20;
}

bool isSlight(const Variant& variant) { return variant.name.find("_slight_") != std::string::npos; }

std::string sectionOf(const std::string& function) {
  for (const FunctionContract& f : contract())
    if (f.name == function) return std::string(f.section);
  throw std::logic_error(function + " is no function of the contract");
}

unsigned threadsOf(const StudyArguments& arguments) {
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  return arguments.threads != 0 ? arguments.threads : processors;
}

std::vector<Variant> variantsOf(const StudyArguments& arguments) {
  const auto asked = [&](const std::string& name) {
    return arguments.what.empty() ||
           std::find(arguments.what.begin(), arguments.what.end(), name) != arguments.what.end();
  };
  std::vector<Variant> wanted;
  std::vector<std::string> known{"solutions", "correct", "wrong", kSlight};
  for (const Variant& variant : allVariants()) {
    known.push_back(variant.name);
    if ((arguments.images || arguments.marks) && variant.wrong) continue;
    if (asked(variant.wrong ? "wrong" : "correct") || asked(variant.name) ||
        (isSlight(variant) && asked(kSlight)))
      wanted.push_back(variant);
  }
  for (const std::string& word : arguments.what)
    if (std::find(known.begin(), known.end(), word) == known.end())
      throw UsageError(
          fmt::format("There is no {} to study: it is solutions, correct, wrong, slight, or the "
                      "name of a patch in "
                      "grader/variants/ without .patch.",
                      word));
  return wanted;
}

// Each variant is compiled, on several threads.
std::vector<study::StudySubject> subjectsOf(const StudyArguments& arguments) {
  const fs::path scratch = fs::path(build::kBuildFolder) / "study/variants";
  const std::vector<Variant> variants = variantsOf(arguments);
  const study::StudySubject solutions = study::solutionsSubject(arguments.images);
  std::vector<study::StudySubject> subjects(variants.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = 0; (i = next++) < variants.size() && !interrupted();) {
      subjects[i] = study::variantSubject(variants[i], arguments.images, scratch);
      if (variants[i].wrong) subjects[i].selection.only = sectionOf(variants[i].function);
    }
  };
  std::vector<std::future<void>> others;
  for (unsigned k = 1; k < threadsOf(arguments); ++k)
    others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
  if (interrupted()) return {};
  if (arguments.what.empty() ||
      std::find(arguments.what.begin(), arguments.what.end(), "solutions") != arguments.what.end())
    subjects.insert(subjects.begin(), solutions);
  return subjects;
}

std::vector<study::StudyRecord> runSubjects(const StudyArguments& arguments,
                                            const std::vector<study::StudySubject>& subjects) {
  study::StudyLog log(arguments.log);
  ProgressBar progress("study");
  const auto goOn = [&](const study::StudyProgress& p) {
    progress.show(
        static_cast<double>(p.done) / static_cast<double>(std::max<std::size_t>(p.all, 1)),
        fmt::format("{} of {} runs, {:.0f} min left", p.done, p.all, p.secondsLeft / 60.0));
    return !interrupted();
  };
  std::vector<study::StudyRecord> records =
      study::runStudy(subjects, seedsOf(arguments), threadsOf(arguments), log, goOn);
  progress.clear();
  return records;
}

// The mistakes that were asked for; with what they may be disguised as: all that is different.
std::vector<Variant> forDiagnosis(const std::vector<study::StudySubject>& subjects) {
  std::vector<Variant> variants = allVariants();
  const auto asked = [&](const Variant& variant) {
    return std::any_of(subjects.begin(), subjects.end(),
                       [&](const study::StudySubject& s) { return s.name == variant.name; });
  };
  std::erase_if(variants, [&](const Variant& v) { return v.wrong && !asked(v); });
  return variants;
}

study::StudyStep diagnosisStep(ProgressBar& progress) {
  return [&progress](std::size_t done, std::size_t all) {
    progress.show(static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(all, 1)),
                  fmt::format("{} of {} files with mistakes are diagnosed", done, all));
    return !interrupted();
  };
}

int makeCatalogue(const StudyArguments& arguments) {
  ProgressBar progress("catalogue");
  const diagnosis::Catalogue made =
      study::makeCatalogue(allVariants(), threadsOf(arguments), diagnosisStep(progress));
  progress.clear();
  if (interrupted()) return kInterrupted;
  writeCatalogue(made, diagnosis::catalogueFile());
  return kSuccess;
}

int runMarks(const StudyArguments& arguments) {
  const std::vector<Variant> variants = variantsOf(arguments);
  if (variants.empty()) throw UsageError("--marks are of what is correct but different.");
  study::MarksOptions options;
  options.seeds = seedsOf(arguments);
  options.threads = threadsOf(arguments);
  options.folder = fs::path(arguments.log).replace_extension(".marks");
  ProgressBar progress("marks");
  const std::vector<study::VariantMarks> marks = study::markVariants(
      variants, study::withBonusParts(rubric::readRubric(rubric::defaultRubric())), options,
      [&](std::size_t done, std::size_t all) {
        progress.show(static_cast<double>(done) / static_cast<double>(all),
                      fmt::format("{} of {} variants are marked", done, all));
        return !interrupted();
      });
  progress.clear();
  const study::MarksReport report = study::reportMarks(marks);
  fmt::print("{}", report.text);
  if (interrupted()) {
    fmt::print(stderr, "Interrupted; the same command goes on from here.\n");
    return kInterrupted;
  }
  return report.asItMustBe ? kSuccess : kCourseworkFault;
}

study::DiagnosisReport runDiagnosis(const StudyArguments& arguments,
                                    const std::vector<study::StudySubject>& subjects) {
  const diagnosis::Catalogue catalogue = diagnosis::readCatalogue(diagnosis::catalogueFile());
  if (catalogue.stamp != study::catalogueStamp())
    throw std::runtime_error(
        "The catalogue of mistakes is older than the variants, the solutions or the probes; "
        "./pathmark study --catalogue makes it anew.");
  ProgressBar progress("diagnosis");
  study::DiagnosisReport report = study::measureDiagnosis(
      catalogue, forDiagnosis(subjects), kMostFiles, threadsOf(arguments),
      fs::path(arguments.log).replace_extension(".named.jsonl"), diagnosisStep(progress));
  progress.clear();
  return report;
}

int runStudyCommand(const StudyArguments& arguments) {
  if (arguments.catalogue) return makeCatalogue(arguments);
  if (arguments.marks) return runMarks(arguments);
  const std::vector<study::StudySubject> subjects = subjectsOf(arguments);
  const std::vector<study::StudyRecord> records = runSubjects(arguments, subjects);
  const bool diagnose = arguments.diagnosis || !arguments.handout.empty();
  study::DiagnosisReport diagnosis;
  if (diagnose && !interrupted()) diagnosis = runDiagnosis(arguments, subjects);
  const std::vector<study::KillRow> rows = study::killTable(subjects, records, diagnosis);
  const study::StudyReport report = study::reportStudy(subjects, records, rows);
  fmt::print("{}", report.text);
  if (diagnose) fmt::print("\n{}", diagnosis.text());
  if (interrupted()) {
    fmt::print(stderr, "Interrupted; the same command goes on from here.\n");
    return kInterrupted;
  }
  if (!arguments.handout.empty())
    writeFileAtomically(arguments.handout, study::asChapter(rows, subjects, records, diagnosis));
  const bool good = report.asItMustBe && (!diagnose || diagnosis.asItMustBe());
  return good ? kSuccess : kCourseworkFault;
}

}  // namespace

void addStudyCommand(CLI::App& app, CommandAction& action) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand(
      "study", "Try the checks on what is known to be right or wrong, under many seeds");
  command
      ->add_option("what", arguments->what,
                   "solutions, correct, wrong, slight (small errors), or names of "
                   "variants; all by default")
      ->type_name("SUBJECT");
  takesWholeNumber(
      command->add_option("--seeds", arguments->seeds, "Seeds for each (20; 1 with --marks)"), 1,
      1000000);
  takesWholeNumber(command->add_option("--threads", arguments->threads,
                                       "Runs at the same time; one for each processor by default"),
                   1, 1024);
  command->add_flag("--images", arguments->images, "The checks of pictures, of what is right");
  command->add_flag("--catalogue", arguments->catalogue,
                    "Measure the known mistakes anew, for grader/diagnosis/catalogue.json");
  command->add_flag("--diagnosis", arguments->diagnosis,
                    "How often the right mistake is named, and how often a wrong one");
  command->add_flag("--marks", arguments->marks,
                    "The marks of what is correct, by the rubric, instead of the checks alone");
  command
      ->add_option("--handout", arguments->handout,
                   "Write the chapter of known mistakes, with --diagnosis")
      ->type_name("FILE");
  command
      ->add_option("--log", arguments->log,
                   "Where records are kept; what is there already is not run again")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  ./pathmark study --diagnosis                 (20 seeds of everything, and the rates)\n"
      "  ./pathmark study --handout handouts/mistakes.md\n"
      "                                               (the same, as a chapter)\n"
      "  ./pathmark study solutions --seeds 1000      (go on with Ctrl-C and the same command)\n"
      "  ./pathmark study solutions --images --seeds 200\n"
      "  ./pathmark study wrong --seeds 1\n"
      "  ./pathmark study slight --seeds 1000         (how often small errors are found)\n"
      "  ./pathmark study --marks                     (does all that is correct get full marks?)\n"
      "  ./pathmark study part3_uniform_hemisphere --marks --seeds 10\n"
      "  ./pathmark study --catalogue                 (after a change of variants or probes)\n\n"
      "Exit code: 0 if all that is right passed, all that is wrong was found by the check that it "
      "names, the diagnosis is as good as it must be, and no marks were lost that should not be; 1 "
      "if not, 130 if interrupted.");
  command->callback(
      [arguments, &action] { action = [arguments] { return runStudyCommand(*arguments); }; });
}

}  // namespace pathmark
