#include "report/submission_html.h"

#include "host/shell_word.h"
#include "picture_slider_js.h"
#include "report/clean_text.h"
#include "report/page_html.h"
#include "report/part_html.h"
#include "report/plots.h"
#include "report/record_words.h"

#include <algorithm>

namespace pathmark::report {

namespace {

using record::FunctionRecord;
using record::PartRecord;
using record::SubmissionRecord;
using record::Verdict;

constexpr std::size_t kLongestPrinted = 20000;

// "14 of 23 functions that were looked at are right, 2 are not, 1 is not written; 1 file does not
// compile."
std::string standing(const SubmissionRecord& record) {
  std::size_t all = 0, right = 0, faults = 0, unwritten = 0, uncompiled = 0;
  for (const PartRecord& part : record.parts) {
    uncompiled += part.verdict == Verdict::kDoesNotCompile ? 1u : 0u;
    for (const FunctionRecord& function : part.functions) {
      ++all;
      right += function.verdict == Verdict::kOk ? 1u : 0u;
      faults += isFault(function.verdict) ? 1u : 0u;
      unwritten += function.verdict == Verdict::kNotWritten ? 1u : 0u;
    }
  }
  if (all == 0) return {};
  const std::size_t others = all - right - faults - unwritten;
  std::string text = fmt::format("{} of {} functions that were looked at are right", right, all);
  if (faults > 0) text += fmt::format(", {} {} not", faults, faults == 1 ? "is" : "are");
  if (unwritten > 0)
    text += fmt::format(", {} {} not written", unwritten, unwritten == 1 ? "is" : "are");
  if (others > 0)
    text += fmt::format(", {} {} blocked or undecided", others, others == 1 ? "is" : "are");
  if (uncompiled > 0)
    text += fmt::format("; {} file{} not compile", uncompiled, uncompiled == 1 ? " does" : "s do");
  return text + ".";
}

struct Loss {
  int part = 0;
  std::string what, reason;
  double points = 0.0;
};

// Lines that lost points; one for a part that lost all, with its first reason.
std::vector<Loss> lossesOf(const PartView& view) {
  std::vector<Loss> losses;
  if (view.marks == nullptr) return losses;
  for (const rubric::MarkLine& line : view.marks->lines)
    if (line.outOf > 0.0 && line.points < line.outOf)
      losses.push_back({view.part, line.what, line.reason, line.outOf - line.points});
  if (losses.size() > 1 && view.marks->points <= 0.0)
    return {{view.part, view.title, losses.front().reason, view.marks->outOf}};
  return losses;
}

Markup whereToBegin(const std::vector<PartView>& views) {
  constexpr std::size_t kMost = 3;
  std::vector<Loss> losses;
  for (const PartView& view : views)
    for (Loss& loss : lossesOf(view)) losses.push_back(std::move(loss));
  if (losses.empty()) return {};
  std::stable_sort(losses.begin(), losses.end(),
                   [](const Loss& a, const Loss& b) { return a.points > b.points; });
  losses.resize(std::min(losses.size(), kMost));
  Markup list;
  for (const Loss& loss : losses)
    list += markup("<li><a href=\"#part-{}\">{}</a> <span class=\"cost\">\u2212{}</span> {}</li>\n",
                   loss.part, loss.what, pointsText(loss.points), loss.reason);
  return markup("<nav class=\"begin\"><h2>Where most points were lost</h2>\n<ol>{}</ol></nav>\n",
                list);
}

Markup headline(const SubmissionRecord& record, const rubric::Marks& marks,
                const std::vector<PartView>& views) {
  if (record.internalError())
    return markup(
        "<header class=\"top\">\n<p class=\"kicker\">Pathmark report</p>\n<h1>{}</h1>\n"
        "<p class=\"banner\"><strong>! Not graded to the end.</strong> That is no fault of this "
        "submission: {}</p>\n</header>\n",
        record.name, record.failure);
  if (!record.leftOut.empty())
    return markup(
        "<header class=\"top\">\n<p class=\"kicker\">Pathmark report</p>\n<h1>{}</h1>\n"
        "<p class=\"banner\"><strong>! Not graded.</strong> There are no marks, which are not 0: "
        "{}</p>\n</header>\n",
        record.name, record.leftOut);
  return markup(
      "<header class=\"top\">\n<p class=\"kicker\">Pathmark report</p>\n<h1>{}</h1>\n"
      "<p class=\"score\"><strong>{}</strong> of {} points</p>\n{}\n<p>{}</p>\n{}</header>\n",
      record.name, pointsText(marks.points), pointsText(marks.outOf),
      pointsBar(marks.points, marks.outOf), standing(record), whereToBegin(views));
}

Markup partsTable(const SubmissionRecord& record, const std::vector<PartView>& views) {
  if (views.empty()) return {};
  Markup rows;
  for (const PartView& view : views) {
    const std::optional<Verdict> verdict = verdictOfPart(record, view.part);
    rows += markup(
        "<tr><th scope=\"row\"><a href=\"#part-{}\">{}</a></th><td>{}</td>"
        "<td class=\"number\">{}</td><td class=\"barcell\">{}</td></tr>\n",
        view.part, view.title, verdict ? verdictChip(*verdict) : Markup{},
        view.marks
            ? fmt::format("{} / {}", pointsText(view.marks->points), pointsText(view.marks->outOf))
            : std::string(),
        view.marks ? pointsBar(view.marks->points, view.marks->outOf) : Markup{});
  }
  return markup(
      "<table class=\"parts\"><thead><tr><th scope=\"col\">part</th><th scope=\"col\">verdict</th>"
      "<th scope=\"col\" class=\"number\">points</th><td class=\"barcell\"></td></tr></thead>\n"
      "<tbody>{}</tbody></table>\n",
      rows);
}

Markup collecting(const SubmissionRecord& record) {
  if (record.collecting.empty()) return {};
  Markup list;
  for (const std::string& sentence : record.collecting) list += markup("<li>{}</li>\n", sentence);
  return markup(
      "<section class=\"part\"><h2>What was found in the submission</h2>\n<ul>{}</ul>"
      "</section>\n",
      list);
}

Markup printed(const SubmissionRecord& record) {
  if (record.printed.empty()) return {};
  return markup(
      "<section class=\"part\"><h2>What the coursework printed</h2>\n<p class=\"hint\">It decides "
      "nothing.</p>\n<pre tabindex=\"0\" role=\"region\" aria-label=\"What the coursework "
      "printed\">{}</pre></section>\n",
      cutAfter(cleanText(record.printed), kLongestPrinted));
}

// A record without pictures of the whole is of one part alone.
bool isOfOnePart(const SubmissionRecord& record) {
  return record.pictures.empty() && record.parts.size() == 1;
}

// Without the folders of the machine that it was graded on: students read it.
std::string gradeCommand(const SubmissionRecord& record, const rubric::Marks& marks) {
  std::string command = fmt::format("./pathmark grade {}", shellWord(endOfPath(record.source)));
  if (isOfOnePart(record)) command += fmt::format(" --only part{}", record.parts.front().part);
  command += fmt::format(" --seed {}", record.seed);
  if (!marks.rubric.empty())
    command += fmt::format(" --rubric {}", shellWord(endOfPath(marks.rubric)));
  return cleanLine(command);
}

// In a student's kit too, which cannot grade.
std::string checkCommand(const SubmissionRecord& record) {
  const std::string part =
      isOfOnePart(record) ? fmt::format(" part{}", record.parts.front().part) : std::string();
  return fmt::format("./pathmark check{} --seed {}", part, record.seed);
}

Markup howItWasMade(const SubmissionRecord& record, const rubric::Marks& marks) {
  Markup rows = term("seed", fmt::format("{}", record.seed));
  rows += term("sandbox", record.build.sandbox);
  rows += term("compiler", record.build.compiler);
  rows += term("flags", record.build.flags);
  rows += term("instructions", record.build.instructions);
  rows += term("grader", record.build.program);
  rows += term("contents", record.contents);
  rows += term("took", fmt::format("{:.0f} s", record.seconds));
  return markup(
      "<section class=\"part\"><h2>How these marks were made</h2>\n<p>Each part was linked with "
      "the solutions of all others, so that no mistake is counted twice, and asked with random "
      "inputs. "
      "The same seed gives the same marks, on any number of threads:</p>\n"
      "<pre tabindex=\"0\"><code>{}</code></pre>\n"
      "<p>With these files in student/ anybody can ask the checks again, with the same inputs; "
      "marks they do not give:</p>\n"
      "<pre tabindex=\"0\"><code>{}</code></pre>\n"
      "<dl class=\"facts\">{}</dl></section>\n",
      gradeCommand(record, marks), checkCommand(record), rows);
}

}  // namespace

std::string submissionHtml(const SubmissionRecord& record, const rubric::Marks& marks,
                           const PictureSource& pictures) {
  const std::vector<PartView> views = partViews(record, marks);
  Markup body = markup("<main>\n{}{}", headline(record, marks, views), partsTable(record, views));
  for (const PartView& view : views) body += partHtml(view, record, pictures);
  body += collecting(record);
  body += printed(record);
  if (record.leftOut.empty()) body += howItWasMade(record, marks);
  body += Markup{"</main>"};
  return page(fmt::format("{} \u2013 Pathmark", record.name), body,
              {assets::kPictureSliderJs, assets::kPictureSliderJsSha256});
}

}  // namespace pathmark::report
