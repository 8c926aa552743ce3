#include "report/part_html.h"

#include "report/check_html.h"
#include "report/clean_text.h"
#include "report/mistake_html.h"
#include "report/page_html.h"
#include "report/picture_html.h"
#include "report/plots.h"
#include "report/record_words.h"
#include "report/svg_samples.h"

#include <map>

namespace pathmark::report {

namespace {

using record::PartRecord;
using record::PictureRecord;
using record::SampleRecord;
using record::SceneRecord;
using record::SubmissionRecord;

constexpr std::size_t kLongestMessage = 40000;

Markup marksTable(const rubric::PartMarks* marks) {
  if (marks == nullptr || marks->lines.empty()) return {};
  Markup rows;
  for (const rubric::MarkLine& line : marks->lines)
    rows += markup(
        "<tr class=\"{}\"><th scope=\"row\">{}</th><td class=\"number\">{}</td><td>{}</td></tr>\n",
        line.points < line.outOf ? "lost" : "full", line.what, lineText(line),
        line.reason.empty() ? "all points" : line.reason);
  return markup(
      "<table class=\"marks\"><thead><tr><th scope=\"col\">for</th>"
      "<th scope=\"col\" class=\"number\">points</th><th scope=\"col\">why</th></tr></thead>\n"
      "<tbody>{}</tbody></table>\n",
      rows);
}

// Focusable, so that a keyboard can scroll it.
Markup messageHtml(const PartRecord& part) {
  if (part.message.empty()) return {};
  const std::string name = fmt::format("Message about {}", part.file);
  return markup(
      "<div class=\"message\"><h4>{}</h4><pre tabindex=\"0\" role=\"region\" "
      "aria-label=\"{}\">{}</pre></div>\n",
      part.file, name, cutAfter(cleanText(part.message), kLongestMessage));
}

Markup samplesHtml(const SampleRecord& samples) {
  Markup histograms;
  for (const record::Histogram& histogram : samples.histograms)
    histograms += histogramPlot(histogram);
  return markup(
      "<section class=\"sampling\"><h4>Samples of <code>{}</code><small>{}</small></h4>"
      "<div class=\"plots\">\n{}{}</div></section>\n",
      samples.name, samples.section, samplePlot(samples), histograms);
}

Markup sceneHtml(const SceneRecord& scene, const PictureSource& source) {
  Markup html = markup("<article class=\"function {}\"><h4>{} <code>{}</code></h4>\n",
                       kindOf(scene.verdict), verdictChip(scene.verdict), scene.file);
  if (!scene.picture.empty())
    html += markup("<figure class=\"scene\">{}<figcaption>{}</figcaption></figure>\n",
                   pngImage(source(scene.picture), scene.file), scene.caption);
  html += markup("<dl class=\"facts\">{}{}</dl></article>\n", term("message", scene.message),
                 term("noise", scene.noise));
  return html;
}

Markup picturesHtml(const std::vector<PictureRecord>& pictures, const PictureSource& source,
                    std::string_view words) {
  if (pictures.empty()) return {};
  Markup html = markup("<h3>Pictures</h3>\n<p class=\"hint\">{}</p>\n", words);
  for (const PictureRecord& picture : pictures) html += pictureHtml(picture, source);
  return html;
}

// What is no radiance in the part's own picture, beside which the mistake's is shown.
std::string invalidIn(const PartRecord& part, const record::MistakePicture& mistake) {
  for (const PictureRecord& picture : part.pictures)
    if (picture.scene == mistake.scene) return picture.invalid;
  return {};
}

Markup contentsOf(const PartView& view, const SubmissionRecord& record,
                  const PictureSource& source) {
  Markup html;
  if (view.part == kScenesPart)
    for (const SceneRecord& scene : record.scenes) html += sceneHtml(scene, source);
  if (view.part == kWhole) {
    html += checksHtml(record.images);
    html += picturesHtml(record.pictures, source,
                         "Made with all of your parts together, beside the same pictures made with "
                         "the solutions.");
  }
  if (view.record == nullptr) return html;
  html += messageHtml(*view.record);
  if (!view.record->functions.empty()) html += Markup{"<h3>Functions</h3>\n"};
  for (const record::FunctionRecord& function : view.record->functions)
    html += functionHtml(function);
  Markup mistakes;
  for (const record::MistakePicture& mistake : view.record->mistakes)
    mistakes += mistakeHtml(mistake, invalidIn(*view.record, mistake), source);
  if (!mistakes.html.empty()) html += markup("<h3>What the mistake looks like</h3>\n{}", mistakes);
  Markup samples;
  for (const SampleRecord& s : record.samples)
    if (s.section.starts_with(fmt::format("{}.", view.part))) samples += samplesHtml(s);
  if (!samples.html.empty()) html += markup("<h3>Samples</h3>\n{}", samples);
  html += picturesHtml(view.record->pictures, source,
                       "Made with this part of yours and all other parts from the solutions, so "
                       "that whatever differs comes from here.");
  return html;
}

}  // namespace

std::string pointsOutOf(const rubric::PartMarks* marks) {
  if (marks == nullptr) return {};
  return fmt::format("{} of {} points", pointsText(marks->points), pointsText(marks->outOf));
}

std::vector<PartView> partViews(const SubmissionRecord& record, const rubric::Marks& marks) {
  std::map<int, PartView> views;
  for (const PartRecord& part : record.parts)
    views[part.part] = {part.part, fmt::format("Part {}: {}", part.part, part.title), &part,
                        nullptr};
  if (!record.scenes.empty()) views[kScenesPart].title = "Part 7: Your own scenes";
  if (!record.images.empty() || !record.pictures.empty())
    views[kWhole].title = "The whole as submitted";
  for (const rubric::PartMarks& part : marks.parts) {
    views[part.part].marks = &part;
    if (!part.title.empty()) views[part.part].title = part.title;
  }
  std::vector<PartView> list;
  for (auto& [number, view] : views) {
    view.part = number;
    list.push_back(view);
  }
  return list;
}

Markup partHtml(const PartView& view, const SubmissionRecord& record, const PictureSource& source) {
  const std::optional<record::Verdict> verdict = verdictOfPart(record, view.part);
  return markup(
      "<section class=\"part\" id=\"part-{}\">\n<h2>{}</h2>\n<p class=\"meta\">{} "
      "<strong>{}</strong> {}</p>\n{}{}</section>\n",
      view.part, view.title, verdict ? verdictChip(*verdict) : Markup{}, pointsOutOf(view.marks),
      view.record ? markup("<code>{}</code>", view.record->file) : Markup{}, marksTable(view.marks),
      contentsOf(view, record, source));
}

}  // namespace pathmark::report
