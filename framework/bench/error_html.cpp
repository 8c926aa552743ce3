#include "bench/error_report.h"
#include "bench/error_words.h"
#include "bench/page.h"

#include <algorithm>
#include <iterator>

namespace pathmark::bench {

namespace {

// Lines of one estimator have one colour, those of one sampler one kind of mark.
int indexIn(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  names.push_back(name);
  return static_cast<int>(names.size()) - 1;
}

LogChart chartOf(const SceneSummary& scene) {
  LogChart chart{fmt::format("{}: error against time", scene.scene),
                 "CPU seconds",
                 "relative mean squared error",
                 {},
                 -1.0};
  std::vector<std::string> estimators, samplers;
  for (const CurveSummary& curve : scene.curves)
    if (!curve.sampler.empty()) indexIn(samplers, curve.sampler);
  for (const CurveSummary& curve : scene.curves) {
    ChartLine line;
    line.name = samplers.size() > 1 ? curve.name() : curve.estimator;
    line.colour = indexIn(estimators, curve.estimator);
    line.kind = curve.sampler.empty() ? 0 : indexIn(samplers, curve.sampler);
    if (std::isfinite(curve.slope.value)) line.note = slopeWords(curve.slope);
    for (const PointSummary& p : curve.points)
      if (p.isMeasured())
        line.points.push_back(
            {p.cpuSeconds.value, p.relativeMse.value, p.relativeMse.low, p.relativeMse.high});
    chart.lines.push_back(std::move(line));
  }
  return chart;
}

std::string rowOf(const CurveSummary& curve, const PointSummary& p) {
  return fmt::format(
      "<tr><th>{}</th><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
      "class=\"n\">{}</td>"
      "<td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
      "<td class=\"n\">{}</td><td class=\"n\">{:.1f} %</td><td class=\"n\">{:+.2f} %</td></tr>\n",
      escaped(curve.estimator), escaped(curve.sampler),
      p.raysPerPixel > 0 ? std::to_string(p.raysPerPixel) : "-", p.replicates,
      threeDigits(p.cpuSeconds.value), threeDigits(p.mse.value),
      p.isMeasured() ? threeDigits(p.relativeMse.value) : "below", percentAround(p.relativeMse),
      threeDigits(p.efficiency.value), percentAround(p.efficiency), 100.0 * p.worstShare.value,
      100.0 * p.mean.value);
}

std::string tableOf(const SceneSummary& scene) {
  std::string table =
      "<div class=\"scroll\"><table><thead><tr><th>estimator</th><th>sampler</th><th>rays per "
      "pixel</th><th>renders</th><th>CPU s</th><th>MSE</th><th>relMSE</th><th>\u00b1</th>"
      "<th>efficiency</th><th>\u00b1</th><th>worst 0.1 %</th><th>mean "
      "off</th></tr></thead><tbody>\n";
  for (const CurveSummary& curve : scene.curves)
    for (const PointSummary& point : curve.points) table += rowOf(curve, point);
  return table + "</tbody></table></div>\n";
}

std::string sectionOf(const SceneSummary& scene) {
  const std::string own =
      scene.reference.relativeMse > 0.0
          ? fmt::format("The reference's own relative MSE, {}, is subtracted.",
                        threeDigits(scene.reference.relativeMse))
          : "The reference has no variances: its own error counts as that of the renders.";
  return fmt::format(
      "<section><h2>{}</h2>\n<figure>{}</figure>\n<p class=\"soft\">{}</p>\n{}</section>\n",
      escaped(scene.scene), chartSvg(chartOf(scene)), own, tableOf(scene));
}

constexpr std::string_view kExplanation =
    "<p>Relative MSE: the mean over pixels and channels of (image \u2212 reference)\u00b2 / "
    "(reference\u00b2 + 0.01). Efficiency: 1 / (relative MSE \u00d7 CPU seconds). Bars and \u00b1: "
    "95 % intervals over independent renders. Numbers in the legend: the slope of log error "
    "against log time, with its interval; independent samples have \u22121, the dotted line. Worst "
    "0.1 %: "
    "the share of the squared error in that part of the pixels.</p>\n";

}  // namespace

std::vector<LogChart> errorCharts(const ErrorFindings& findings) {
  std::vector<LogChart> charts;
  for (const SceneSummary& scene : findings.scenes) charts.push_back(chartOf(scene));
  return charts;
}

std::string errorsHtml(const ErrorFindings& findings, const std::string& machine) {
  std::string body = fmt::format("<h1>Error against time</h1>\n{}", kExplanation);
  for (const SceneSummary& scene : findings.scenes) body += sectionOf(scene);
  for (const std::string& note : findings.notes)
    body += fmt::format("<p class=\"soft\">{}</p>\n", escaped(note));
  body += fmt::format("<p class=\"soft\">{}</p>\n", escaped(machine));
  return pageOf("Error against time", body);
}

}  // namespace pathmark::bench
