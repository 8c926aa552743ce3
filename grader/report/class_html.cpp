#include "report/class_html.h"

#include "report/class_numbers.h"
#include "report/class_scenes.h"
#include "report/class_verdicts.h"
#include "report/page_html.h"
#include "report/plots.h"
#include "report/record_words.h"
#include "report/thumbnail.h"
#include "report/to_look_at.h"
#include "sortable_table_js.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark::report {

namespace {

using record::PictureRecord;

constexpr int kThumbnail = 72;  // pixels

std::string linkOf(const Graded& graded) { return escapedUrl(graded.folder + "/report.html"); }

// The first picture of the whole, or else of a part.
Markup smallPicture(const Graded& graded) {
  std::vector<const PictureRecord*> pictures;
  for (const PictureRecord& picture : graded.record->pictures) pictures.push_back(&picture);
  for (const record::PartRecord& part : graded.record->parts)
    for (const PictureRecord& picture : part.pictures) pictures.push_back(&picture);
  for (const PictureRecord* picture : pictures)
    if (!picture->yours.empty() && graded.pictures)
      return pngImage(thumbnail(graded.pictures(picture->yours), kThumbnail),
                      fmt::format("{} of {}", picture->scene, graded.record->name));
  return {};
}

// Sorted by data-value; what has none comes last.
Markup pointsCell(const rubric::PartMarks* marks, bool complete) {
  if (marks == nullptr || !complete)
    return Markup{"<td class=\"number\" data-value=\"\">\u2013</td>"};
  return markup("<td class=\"number\" data-value=\"{:.4f}\">{}{}</td>", marks->points,
                pointsText(marks->points), pointsBar(marks->points, marks->outOf));
}

Markup wordsOf(const Graded& graded) {
  const record::SubmissionRecord& record = *graded.record;
  const std::vector<std::string> sentences =
      record.leftOut.empty() ? whatIsWrong(record, *graded.marks)
                             : std::vector{fmt::format("not graded: {}", record.leftOut)};
  Markup words;
  for (const std::string& sentence : sentences) words += markup("<li>{}</li>", sentence);
  return words.html.empty() ? words : markup("<ul class=\"words\">{}</ul>", words);
}

Markup sourceOf(const record::SubmissionRecord& record) {
  const std::string name = submissionName(record);
  return name.empty() || name == record.name ? Markup{} : markup("<small>{}</small>", name);
}

Markup submissionRow(const Graded& graded, const std::vector<ClassPart>& parts) {
  const bool complete = graded.record->hasMarks();
  Markup cells;
  for (const ClassPart& part : parts) cells += pointsCell(marksOf(graded, part.part), complete);
  const rubric::PartMarks total{0, "", graded.marks->points, graded.marks->outOf, {}};
  return markup(
      "<tr><th scope=\"row\" data-value=\"{0}\"><a href=\"{1}\">{2}<span>{0}{3}</span></a></th>"
      "{4}{5}<td>{6}</td></tr>\n",
      graded.record->name, Markup{linkOf(graded)}, smallPicture(graded), sourceOf(*graded.record),
      pointsCell(&total, complete), cells, wordsOf(graded));
}

Markup submissionsTable(GradedClass graded, const std::vector<ClassPart>& parts) {
  Markup names, rows;
  for (const ClassPart& part : parts)
    names += markup("<th scope=\"col\" class=\"number\" title=\"{}\">{}<small>of {}</small></th>",
                    part.title, partName(part.part), pointsText(part.outOf));
  for (const Graded& g : graded) rows += submissionRow(g, parts);
  return markup(
      "<section class=\"part\"><h2>Submissions</h2>\n<div class=\"scroll\" tabindex=\"0\" "
      "role=\"region\" aria-label=\"Submissions\">"
      "<table class=\"class sortable\"><thead><tr><th scope=\"col\">submission</th>"
      "<th scope=\"col\" class=\"number\">total<small>of {}</small></th>{}"
      "<td>what is wrong</td></tr></thead>\n<tbody>{}</tbody></table></div></section>\n",
      pointsText(largestTotal(graded)), names, rows);
}

Markup partMeans(GradedClass graded, const std::vector<ClassPart>& parts) {
  Markup rows;
  for (const ClassPart& part : parts) {
    const double mean = meanOf(pointsOfPart(graded, part.part));
    rows += markup(
        "<tr><th scope=\"row\">{}</th><td class=\"barcell\">{}</td><td class=\"number\">{:.1f} / "
        "{}</td></tr>\n",
        part.title, pointsBar(mean, part.outOf), mean, pointsText(part.outOf));
  }
  return markup(
      "<table class=\"means\"><caption>Mean of each part</caption><tbody>{}</tbody></table>", rows);
}

Markup overview(GradedClass graded, const std::vector<ClassPart>& parts) {
  const std::vector<double> totals = totalsOf(graded);
  return markup(
      "<section class=\"part overview\"><h2>Marks</h2>\n<div class=\"plots\">\n"
      "<figure class=\"plot-figure\">{}<figcaption>Submissions by their points</figcaption>"
      "</figure>\n{}</div></section>\n",
      distributionPlot(totals, largestTotal(graded)), partMeans(graded, parts));
}

// What is said, and of whom.
struct Remark {
  std::string sentence;
  std::vector<const Graded*> submissions;
};

// Of a submission without marks nothing else is said: it would follow from that.
std::vector<Remark> remarksOf(GradedClass graded) {
  std::vector<Remark> remarks;
  const auto add = [&](const Graded& g, const std::string& sentence) {
    const auto same = [&](const Remark& remark) { return remark.sentence == sentence; };
    auto found = std::find_if(remarks.begin(), remarks.end(), same);
    if (found == remarks.end()) found = remarks.insert(remarks.end(), {sentence, {}});
    found->submissions.push_back(&g);
  };
  for (const Graded& g : graded)
    if (!g.record->hasMarks()) add(g, whyNoMarks(*g.record));
  const std::vector<std::string> same = sameFiles(graded);
  for (std::size_t i = 0; i < graded.size(); ++i)
    if (!same[i].empty()) add(graded[i], same[i]);
  for (const Graded& g : graded)
    for (const std::string& sentence : reviewOf(g))
      if (g.record->hasMarks()) add(g, sentence);
  return remarks;
}

Markup remarkHtml(const Remark& remark) {
  constexpr std::size_t kMany = 6;
  const std::size_t count = remark.submissions.size();
  Markup links;
  for (const Graded* g : remark.submissions)
    links += markup("<a href=\"{}\">{}</a> ", Markup{linkOf(*g)}, g->record->name);
  // It goes on after the names, unlike a sentence of a submission with marks.
  const std::string why = whyNoMarks(*remark.submissions.front()->record, count > 1);
  const std::string& words = why.empty() ? remark.sentence : why;
  if (count < kMany) return markup("<li>{}{}</li>\n", links, words);
  return markup("<li><details><summary>{} submissions{} {}</summary>{}</details></li>\n", count,
                why.empty() ? ":" : "", words, links);
}

// What a person should see before marks are handed out. The same of many takes one line.
Markup toLookAt(GradedClass graded) {
  Markup list;
  for (const Remark& remark : remarksOf(graded)) list += remarkHtml(remark);
  if (list.html.empty()) return {};
  return markup(
      "<section class=\"part review\"><h2>Look at these first</h2>\n<ul>{}</ul></section>\n", list);
}

Markup headline(GradedClass graded) {
  const std::vector<double> totals = totalsOf(graded);
  const std::size_t failed = graded.size() - totals.size();
  std::string sentence;
  if (!totals.empty())
    sentence = fmt::format("Mean {:.1f} and median {:.1f} of {} points.", meanOf(totals),
                           medianOf(totals), pointsText(largestTotal(graded)));
  if (failed > 0) sentence += fmt::format(" {} {} no marks.", failed, failed == 1 ? "has" : "have");
  return markup(
      "<header class=\"top\">\n<p class=\"kicker\">Pathmark report</p>\n<h1>Class</h1>\n"
      "<p class=\"score\"><strong>{}</strong> {}</p>\n<p>{}</p>\n</header>\n",
      graded.size(), graded.size() == 1 ? "submission" : "submissions", sentence);
}

}  // namespace

std::string classHtml(GradedClass graded) {
  const std::vector<ClassPart> parts = partsOf(graded);
  Markup body = markup("<main class=\"wide\">\n{}", headline(graded));
  body += toLookAt(graded);
  body += overview(graded, parts);
  body += submissionsTable(graded, parts);
  body += classScenes(graded);
  body += functionCountsHtml(functionCounts(graded), graded.size());
  body += Markup{"</main>"};
  return page("Class \u2013 Pathmark", body,
              {assets::kSortableTableJs, assets::kSortableTableJsSha256});
}

}  // namespace pathmark::report
