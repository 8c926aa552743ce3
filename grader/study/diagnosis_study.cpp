#include "study/diagnosis_study.h"

#include "checks/runner.h"
#include "checks/scenes.h"
#include "diagnosis/diagnose.h"
#include "diagnosis/probes.h"
#include "host/build_config.h"
#include "host/content_hash.h"
#include "host/worker_process.h"
#include "study/named_log.h"
#include "study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <future>
#include <iterator>
#include <map>
#include <set>

namespace pathmark::study {

namespace fs = std::filesystem;

namespace {

using diagnosis::ProbeSeed;
using diagnosis::Signature;

// By function; those that break are left out.
using Signatures = std::map<CourseworkFunction, Signature>;
using Functions = std::set<CourseworkFunction>;

Functions functionsOf(int part) {
  Functions functions;
  for (const FunctionContract& f : contract())
    if (f.part == part) functions.insert(f.function);
  return functions;
}

// Those in which a check finds something wrong: of these alone a mistake is named.
Functions failingIn(const CaseBuild& made, int part) {
  if (made.mayDiffer.empty()) return {};
  checks::Selection selection;
  selection.parts = {part};
  selection.functions = made.mayDiffer;
  selection.images = selection.scenes = false;
  checks::RunOptions options;
  options.threads = 1;
  options.untilWrong = true;
  options.diagnose = false;
  Functions failing;
  for (const checks::PartResult& p : checks::runChecks(made.build, selection, options).parts)
    for (const checks::FunctionResult& f : p.functions)
      if (f.status == checks::Status::kFail) failing.insert(f.function.function);
  return failing;
}

Signatures probeAll(const CourseworkBuild& build, int part, const Functions& functions,
                    ProbeSeed seed) {
  Signatures all;
  const LinkedWorker linked = linkWithStandIns(build, std::array{part});
  std::unique_ptr<WorkerProcess> worker;
  for (const FunctionContract& f : contract()) {
    if (!functions.contains(f.function)) continue;
    try {
      if (!worker) {
        WorkerProcess::Options options;
        options.program = linked.worker;
        options.courseworkFolder = build.folder;
        worker = std::make_unique<WorkerProcess>(std::move(options));
        worker->loadScene(checks::emptyRoom());
      }
      all[f.function] = diagnosis::probe(*worker, f.function, seed);
    } catch (const WorkerError&) {
      worker.reset();
    }
  }
  return all;
}

std::string readFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A patch without the line that names its check, which says nothing about what the mistake does.
std::string withoutCheck(std::string patch) {
  const std::size_t begin = patch.find("\nCheck: ");
  if (begin < patch.find("\n\n")) patch.erase(begin, patch.find('\n', begin + 1) - begin);
  return patch;
}

// One after the other on each thread; those that there was no time for stay as they are.
template <typename Work>
void forAll(std::size_t count, unsigned threads, const StudyStep& step, const Work& work) {
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex asking;
  const auto run = [&] {
    for (std::size_t i = 0; (i = next++) < count;) {
      {
        const std::lock_guard lock(asking);
        if (!step(done, count)) return;
      }
      work(i);
      ++done;
    }
  };
  std::vector<std::future<void>> others;
  for (unsigned k = 1; k < threads; ++k) others.push_back(std::async(std::launch::async, run));
  run();
  for (std::future<void>& other : others) other.get();
}

// Where the checks' study has its files too: a mistake by itself is compiled once for both.
fs::path scratchFolder() { return fs::path(build::kBuildFolder) / "study/variants"; }

CourseworkBuild solutions() {
  return buildCoursework(courseworkFolder("solutions"), Incomplete::kCompileOnly);
}

// Of the mistakes that look like this one in a function: itself too.
std::vector<std::string> alike(const diagnosis::FunctionCatalogue& known,
                               const std::string& mistake) {
  std::vector<std::string> names{mistake};
  const auto found = std::find_if(known.mistakes.begin(), known.mistakes.end(),
                                  [&](const auto& k) { return k.mistake == mistake; });
  if (found == known.mistakes.end()) return names;
  for (const diagnosis::KnownSignature& other : known.mistakes)
    if (diagnosis::looksLike(*found, other)) names.push_back(other.mistake);
  return names;
}

enum class LeaveOut { kNothing, kMade, kAlike };

Named nameOf(const MistakenCase& c, const Signatures& signatures,
             const diagnosis::Catalogue& catalogue, LeaveOut leaveOut, std::string& words) {
  bool right = false, wrong = false;
  for (const auto& [function, signature] : signatures) {
    const diagnosis::FunctionCatalogue* known = catalogue.find(function);
    if (known == nullptr) continue;
    std::vector<std::string> unknown;
    for (const Variant& patch : c.patches) {
      if (!patch.wrong || leaveOut == LeaveOut::kNothing) continue;
      const auto names =
          leaveOut == LeaveOut::kAlike ? alike(*known, patch.name) : std::vector{patch.name};
      unknown.insert(unknown.end(), names.begin(), names.end());
    }
    const diagnosis::Match m = diagnosis::match(signature, *known, unknown);
    if (m.mistakes.empty()) continue;
    const bool made = std::any_of(m.mistakes.begin(), m.mistakes.end(),
                                  [&](const auto* k) { return c.makes(k->mistake); });
    (made ? right : wrong) = true;
    if (!made)
      words += fmt::format(" {}: {} at {:.1f}", contractOf(function).name,
                           m.mistakes.front()->mistake, m.distance);
  }
  if (wrong) return Named::kWrong;
  if (right) return Named::kRight;
  return signatures.empty() ? Named::kUnseen : Named::kNothing;
}

// Where nothing was named: how near the mistake was, and which feature was farthest from it.
std::string whyNothing(const MistakenCase& c, const Signatures& signatures,
                       const diagnosis::Catalogue& catalogue) {
  std::string text;
  for (const auto& [function, signature] : signatures) {
    const diagnosis::FunctionCatalogue* known = catalogue.find(function);
    if (known == nullptr || distance(signature, known->right) < diagnosis::kExcluded) continue;
    for (const diagnosis::KnownSignature& mistake : known->mistakes)
      if (c.makes(mistake.mistake))
        text += fmt::format(" {}: {}", contractOf(function).name,
                            diagnosis::farthest(signature, mistake));
  }
  return text;
}

std::vector<NamedCase> nameCases(const std::vector<MistakenCase>& cases,
                                 const diagnosis::Catalogue& catalogue, unsigned threads,
                                 NamedLog& log, const StudyStep& step) {
  const std::string judge = programHash() + contentHash(readFile(diagnosis::catalogueFile()));
  const CourseworkBuild others = solutions();
  std::vector<std::optional<NamedCase>> named(cases.size());
  forAll(cases.size(), threads, step, [&](std::size_t i) {
    const MistakenCase& c = cases[i];
    const auto made = buildCase(c, others, scratchFolder());
    if (!made) return;
    const PartBuild& part = made->build.parts[placeOfPart(c.part())];
    const std::string key = contentHash(judge + c.name() + part.object.filename().string());
    if (const auto known = log.find(key)) {
      named[i] = *known;
      return;
    }
    const Functions failing = failingIn(*made, c.part());
    const Signatures signatures = probeAll(made->build, c.part(), failing, ProbeSeed::kDisguise);
    NamedCase result{c.name(), c.patches.back().name, {}, {}, {}, {}};
    result.known = nameOf(c, signatures, catalogue, LeaveOut::kNothing, result.words);
    result.leftOut = nameOf(c, signatures, catalogue, LeaveOut::kMade, result.words);
    std::string ignored;
    result.leftOutAlike = nameOf(c, signatures, catalogue, LeaveOut::kAlike, ignored);
    if (result.known == Named::kNothing) result.words += whyNothing(c, signatures, catalogue);
    log.add(key, result);
    named[i] = result;
  });
  std::vector<NamedCase> result;
  for (std::optional<NamedCase>& c : named)
    if (c) result.push_back(std::move(*c));
  return result;
}

// The shipped stubs as they are handed in by who deletes their markers and writes nothing.
CourseworkBuild unmarkedStubs() {
  const fs::path folder = scratchFolder() / "stubs";
  fs::create_directories(folder);
  for (const PartContract& part : parts()) {
    std::ifstream in(courseworkFolder("student") / part.file);
    std::ofstream out(folder / part.file);
    for (std::string line; std::getline(in, line);)
      if (line.find("PATHMARK_UNIMPLEMENTED(") == std::string::npos) out << line << '\n';
  }
  return buildCoursework(folder, Incomplete::kCompileOnly);
}

struct Counts {
  std::size_t all = 0, right = 0, wrong = 0, nothing = 0;

  double share(std::size_t n) const {
    return all == 0 ? 0.0 : 100.0 * static_cast<double>(n) / static_cast<double>(all);
  }
};

Counts count(const std::vector<NamedCase>& cases, Named NamedCase::*which) {
  Counts counts;
  for (const NamedCase& c : cases) {
    if (c.known == Named::kUnseen) continue;
    ++counts.all;
    counts.right += c.*which == Named::kRight ? 1 : 0;
    counts.wrong += c.*which == Named::kWrong ? 1 : 0;
    counts.nothing += c.*which == Named::kNothing || c.*which == Named::kUnseen ? 1 : 0;
  }
  return counts;
}

struct Rate {
  const char* what;
  Counts counts;
};

std::vector<Rate> ratesOf(const DiagnosisReport& report) {
  return {
      {"each mistake, with other random numbers", count(report.single, &NamedCase::known)},
      {"... in a file that differs where it may", count(report.disguised, &NamedCase::known)},
      {"each mistake, unknown to the catalogue", count(report.single, &NamedCase::leftOut)},
      {"... in a file that differs where it may", count(report.disguised, &NamedCase::leftOut)},
      {"each mistake, unknown with all that look the same",
       count(report.single, &NamedCase::leftOutAlike)},
      {"two mistakes in a file (right: one of the two)", count(report.pairs, &NamedCase::known)}};
}

}  // namespace

std::string catalogueStamp() {
  ContentHasher hasher;
  const fs::path project(build::kProjectFolder);
  // What compares signatures does not change them.
  const std::set<std::string> others{"CMakeLists.txt", "catalogue.cpp", "catalogue.h",
                                     "catalogue.json", "diagnose.cpp",  "diagnose.h",
                                     "diagnosis.h"};
  std::set<fs::path> files;
  for (const char* folder : {"solutions", "grader/variants/wrong", "grader/diagnosis"})
    for (const auto& entry : fs::directory_iterator(project / folder))
      if (const std::string name = entry.path().filename().string();
          entry.is_regular_file() && !others.contains(name))
        files.insert(entry.path());
  for (const fs::path& file : files) {
    hasher.add(file.filename().string());
    hasher.add(file.extension() == ".patch" ? withoutCheck(readFile(file)) : readFile(file));
  }
  return hasher.digits();
}

diagnosis::Catalogue makeCatalogue(const std::vector<Variant>& variants, unsigned threads,
                                   const StudyStep& step) {
  const CourseworkBuild others = solutions();
  const std::vector<MistakenCase> cases = singleCases(variants);
  std::vector<Signatures> all(cases.size());
  forAll(cases.size(), threads, step, [&](std::size_t i) {
    const auto made = buildCase(cases[i], others, scratchFolder());
    if (!made)
      throw std::runtime_error(cases[i].name() + " does not apply to the solutions or compile.");
    const int part = cases[i].part();
    all[i] = probeAll(made->build, part, functionsOf(part), ProbeSeed::kCatalogue);
  });
  const CourseworkBuild stubs = unmarkedStubs();
  diagnosis::Catalogue catalogue{catalogueStamp(), {}};
  for (const PartContract& part : parts()) {
    const Signatures rights =
        probeAll(others, part.part, functionsOf(part.part), ProbeSeed::kCatalogue);
    const Signatures ofStubs =
        probeAll(stubs, part.part, functionsOf(part.part), ProbeSeed::kCatalogue);
    for (const auto& [function, right] : rights) {
      diagnosis::FunctionCatalogue f{
          function, hashOf(right), diagnosis::knownSignature("", "", right), {}};
      if (const auto stub = ofStubs.find(function); stub != ofStubs.end())
        f.stub = diagnosis::knownSignature(
            diagnosis::kStub,
            "it answers as the empty stub does: nothing is written, or something keeps all of it "
            "out (a direction or a sign turned round, a test the wrong way round)",
            stub->second);
      for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto found = all[i].find(function);
        if (found == all[i].end()) continue;
        if (!(distance(found->second, f.right) >= diagnosis::kExcluded)) continue;
        const Variant& variant = cases[i].patches.front();
        f.mistakes.push_back(diagnosis::knownSignature(variant.name, variant.what, found->second));
      }
      catalogue.functions.push_back(std::move(f));
    }
  }
  return catalogue;
}

std::string DiagnosisReport::text() const {
  std::string text;
  for (const auto* cases : {&single, &disguised, &pairs})
    for (const NamedCase& c : *cases) {
      const bool isPair = cases == &pairs;
      const bool said = c.known == Named::kWrong || c.leftOut == Named::kWrong;
      if (c.known == Named::kUnseen)
        text += fmt::format("unseen   {}\n", c.name);
      else if (said || (!isPair && c.known != Named::kRight))
        text += fmt::format("{:<8} {}:{}\n",
                            c.known == Named::kWrong     ? "wrong"
                            : c.leftOut == Named::kWrong ? "left out"
                                                         : "nothing",
                            c.name, c.words);
    }
  text += fmt::format("\n{:<52} {:>5}   {:<15} {:<15} {:<15}\n", "diagnosis", "files", "right",
                      "nothing clear", "wrong");
  for (const auto& [what, c] : ratesOf(*this))
    text += fmt::format("{:<52} {:>5}   {:>4} ({:5.1f} %)  {:>4} ({:5.1f} %)  {:>4} ({:5.1f} %)\n",
                        what, c.all, c.right, c.share(c.right), c.nothing, c.share(c.nothing),
                        c.wrong, c.share(c.wrong));
  return text;
}

std::string DiagnosisReport::chapter() const {
  std::string text = "| | files | right | nothing clear | wrong |\n|---|---:|---:|---:|---:|\n";
  for (const auto& [what, c] : ratesOf(*this))
    text += fmt::format("| {} | {} | {} ({:.1f} %) | {} ({:.1f} %) | {} ({:.1f} %) |\n", what,
                        c.all, c.right, c.share(c.right), c.nothing, c.share(c.nothing), c.wrong,
                        c.share(c.wrong));
  return text;
}

namespace {

// Where each is one with this probability, there are more among `count` with less than 1e-3.
std::size_t mostInSample(std::size_t count, double probability) {
  constexpr double kFalseFails = 1e-3;
  const auto n = static_cast<double>(count);
  double term = std::pow(1.0 - probability, n), more = 1.0 - term;
  std::size_t most = 0;
  for (; more >= kFalseFails && most < count; ++most) {
    const auto k = static_cast<double>(most);
    term *= (n - k) / (k + 1.0) * probability / (1.0 - probability);
    more -= term;
  }
  return most;
}

}  // namespace

bool DiagnosisReport::asItMustBe() const {
  constexpr double kRight = 90.0, kWrong = 2.0;
  for (const auto* cases : {&single, &disguised}) {
    const Counts known = count(*cases, &NamedCase::known);
    if (known.share(known.right) < kRight || known.share(known.wrong) > kWrong) return false;
  }
  // All mistakes, and a sample of the files in which they can stand.
  const Counts all = count(single, &NamedCase::leftOut),
               some = count(disguised, &NamedCase::leftOut);
  if (all.share(all.wrong) > kWrong || some.wrong > mostInSample(some.all, 0.01 * kWrong))
    return false;
  const Counts two = count(pairs, &NamedCase::known);
  return two.share(two.wrong) <= kWrong;
}

DiagnosisReport measureDiagnosis(const diagnosis::Catalogue& catalogue,
                                 const std::vector<Variant>& variants, std::size_t most,
                                 unsigned threads, const fs::path& file, const StudyStep& step) {
  NamedLog log(file);
  DiagnosisReport report;
  const std::vector<Variant> asked = variants;
  report.single = nameCases(singleCases(asked), catalogue, threads, log, step);
  report.disguised = nameCases(disguisedCases(asked, most), catalogue, threads, log, step);
  report.pairs = nameCases(pairedCases(asked, most), catalogue, threads, log, step);
  return report;
}

}  // namespace pathmark::study
