#include "report/junit.h"

#include "report/clean_text.h"
#include "report/html_text.h"
#include "report/record_words.h"

#include <algorithm>
#include <vector>

namespace pathmark::report {

namespace {

using record::CheckRecord;
using record::PartRecord;
using record::SubmissionRecord;
using record::Verdict;

constexpr std::size_t kLongestText = 20000;

struct Case {
  std::string name;
  Verdict verdict = Verdict::kOk;
  std::string message, text;
  double seconds = 0.0;
  std::string_view type{};  // in place of the verdict's name
};

struct Suite {
  std::string name;
  std::vector<Case> cases;
};

enum class Outcome { kPassed, kFailure, kError, kSkipped };

Outcome outcomeOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::kOk:
    case Verdict::kUndecided:
      return Outcome::kPassed;
    case Verdict::kWrong:
      return Outcome::kFailure;
    case Verdict::kBlocked:
    case Verdict::kNotWritten:
      return Outcome::kSkipped;
    default:
      return Outcome::kError;
  }
}

std::string messageOf(const CheckRecord& check) {
  if (!check.cause.empty()) return check.cause;
  if (!check.got.empty() && !check.expected.empty())
    return fmt::format("expected {}, got {}", check.expected, check.got);
  return check.got.empty() ? check.statement : check.got;
}

Case caseOf(const CheckRecord& check) {
  return {check.id, check.verdict, messageOf(check), textOf(check), check.seconds};
}

// A part that was not checked is a case of its own: else its tests would be missing without a word.
Suite suiteOf(const PartRecord& part) {
  Suite suite{fmt::format("part {}", part.part), {}};
  if (part.functions.empty())
    suite.cases.push_back(
        {part.file, part.verdict, std::string(nameOf(part.verdict)), part.message, 0.0});
  for (const record::FunctionRecord& function : part.functions)
    for (const CheckRecord& check : function.checks) suite.cases.push_back(caseOf(check));
  return suite;
}

std::vector<Suite> suitesOf(const SubmissionRecord& record) {
  std::vector<Suite> suites;
  if (record.internalError())
    suites.push_back({"grading", {{"complete", Verdict::kInternalError, record.failure, "", 0.0}}});
  if (!record.leftOut.empty())
    suites.push_back(
        {"grading",
         {{"complete", Verdict::kInternalError, record.leftOut, "", 0.0, "not graded"}}});
  for (const PartRecord& part : record.parts) suites.push_back(suiteOf(part));
  Suite images{"images", {}}, scenes{"part 7", {}};
  for (const CheckRecord& check : record.images) images.cases.push_back(caseOf(check));
  for (const record::SceneRecord& scene : record.scenes)
    scenes.cases.push_back({scene.file, scene.verdict, scene.message, scene.noise, 0.0});
  for (Suite& suite : {std::ref(scenes), std::ref(images)})
    if (!suite.cases.empty()) suites.push_back(std::move(suite));
  return suites;
}

Markup detail(const Case& c) {
  const std::string text = cutAfter(cleanText(c.text), kLongestText);
  const std::string message = cutAfter(cleanLine(c.message), kLongestText);
  const std::string_view type = c.type.empty() ? nameOf(c.verdict) : c.type;
  switch (outcomeOf(c.verdict)) {
    case Outcome::kFailure:
      return markup("<failure message=\"{}\" type=\"{}\">{}</failure>", message, type, text);
    case Outcome::kError:
      return markup("<error message=\"{}\" type=\"{}\">{}</error>", message, type, text);
    case Outcome::kSkipped:
      return markup("<skipped message=\"{}\"/>", fmt::format("{}: {}", type, message));
    case Outcome::kPassed:
      break;
  }
  return c.verdict == Verdict::kUndecided ? markup("<system-out>{}</system-out>", text) : Markup{};
}

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
  double seconds = 0.0;

  void add(const Suite& suite) {
    for (const Case& c : suite.cases) {
      const Outcome outcome = outcomeOf(c.verdict);
      ++tests;
      failures += outcome == Outcome::kFailure ? 1u : 0u;
      errors += outcome == Outcome::kError ? 1u : 0u;
      skipped += outcome == Outcome::kSkipped ? 1u : 0u;
      seconds += c.seconds;
    }
  }
};

Markup attributes(const std::string& name, const Counts& counts) {
  return markup(
      "name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"", name,
      counts.tests, counts.failures, counts.errors, counts.skipped, counts.seconds);
}

// Dots separate packages in what reads these files, so that names of submissions have none.
Markup suiteXml(const Suite& suite, const std::string& submission) {
  std::string package = cleanLine(submission);
  std::replace(package.begin(), package.end(), '.', '_');
  Counts counts;
  counts.add(suite);
  Markup xml = markup("  <testsuite {}>\n",
                      attributes(fmt::format("{} {}", submission, suite.name), counts));
  for (const Case& c : suite.cases)
    xml += markup("    <testcase classname=\"{}.{}\" name=\"{}\" time=\"{:.3f}\">{}</testcase>\n",
                  package, suite.name, cleanLine(c.name), c.seconds, detail(c));
  xml += Markup{"  </testsuite>\n"};
  return xml;
}

std::string documentOf(const std::vector<const SubmissionRecord*>& records) {
  Counts counts;
  Markup suites;
  for (const SubmissionRecord* record : records)
    for (const Suite& suite : suitesOf(*record)) {
      counts.add(suite);
      suites += suiteXml(suite, cleanLine(record->name));
    }
  return markup("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n{}</testsuites>\n",
                attributes("pathmark", counts), suites)
      .html;
}

}  // namespace

std::string junitXml(const SubmissionRecord& record) { return documentOf({&record}); }

std::string junitXml(GradedClass graded) {
  std::vector<const SubmissionRecord*> records;
  for (const Graded& g : graded) records.push_back(g.record);
  return documentOf(records);
}

}  // namespace pathmark::report
