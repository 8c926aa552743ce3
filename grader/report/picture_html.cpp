#include "report/picture_html.h"

#include "film/signed_picture.h"
#include "report/page_html.h"
#include "report/plots.h"

#include <cmath>

namespace pathmark::report {

namespace {

using record::Estimate;
using record::PictureRecord;

Markup pane(const PictureRecord& picture, const PictureSource& source, const std::string& file,
            std::string_view kind, std::string_view name) {
  if (file.empty()) return {};
  Markup image = pngImage(source(file), fmt::format("{}: {}", picture.scene, name));
  if (image.html.empty()) image = Markup{"<p class=\"missing\">The file is missing.</p>"};
  return markup("<figure class=\"pane {}\">{}<figcaption>{}</figcaption></figure>\n", kind, image,
                name);
}

// Two digits, but all of those before the point, without exponents.
std::string percentDigits(double share) {
  const double percent = 100.0 * share, size = std::abs(percent);
  return size >= 9.95 && size < 1e6 ? fmt::format("{:.0f}", percent)
                                    : fmt::format("{:.2g}", percent);
}

// Of the colours of the signed error: 41 steps from -scale to scale.
Markup legend(double scale) {
  constexpr int kSteps = 20;
  Markup steps;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const auto [r, g, b] = signedColour(i, kSteps);
    steps += markup("<rect x=\"{}\" width=\"1.1\" height=\"4\" fill=\"rgb({},{},{})\"/>",
                    i + kSteps, r, g, b);
  }
  const std::string end = fmt::format("{} %", percentDigits(scale));
  return markup(
      "<div class=\"legend\" role=\"img\" aria-label=\"Signed error: blue where yours is darker by "
      "up to {2}, white where it is equal, red where it is brighter\">"
      "<svg viewBox=\"0 0 {1} 4\" preserveAspectRatio=\"none\" aria-hidden=\"true\">{3}</svg>"
      "<span>yours darker, \u2212{0}</span><span>+{0}, brighter</span></div>\n",
      end, 2 * kSteps + 1, end, steps);
}

// Three channels in one row.
std::string channels(const std::array<Estimate, 3>& errors) {
  const auto percent = [](const Estimate& e) {
    return fmt::format("{}{} %", e.value < 0.0 ? "\u2212" : "+", percentDigits(std::abs(e.value)));
  };
  return fmt::format("red {}, green {}, blue {}", percent(errors[0]), percent(errors[1]),
                     percent(errors[2]));
}

std::string efficiencyText(const Estimate& e) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f}) of the solutions'", e.value, e.low, e.high);
}

Markup numbers(const PictureRecord& picture) {
  Markup rows = term("off by", percentText(picture.bias));
  rows += term("mean error", channels(picture.meanError));
  if (!picture.invalid.empty())
    rows += term("invalid", fmt::format("{}. These are left out; a pixel that has no others is "
                                        "magenta.",
                                        picture.invalid));
  if (picture.efficiency) rows += term("efficiency", efficiencyText(*picture.efficiency));
  if (picture.cpuSeconds > 0.0)
    rows += term("CPU time", fmt::format("{:.2g} s; the solutions {:.2g} s", picture.cpuSeconds,
                                         picture.cpuSecondsOfSolutions));
  return markup("<dl class=\"facts\">{}</dl>\n", rows);
}

}  // namespace

std::string percentText(const Estimate& estimate) {
  return fmt::format("{} % ({} to {} %)", percentDigits(estimate.value),
                     percentDigits(estimate.low), percentDigits(estimate.high));
}

Markup pictureHtml(const PictureRecord& picture, const PictureSource& source) {
  if (!picture.failure.empty())
    return markup("<section class=\"picture\"><h4>{}</h4><p class=\"missing\">{}</p></section>\n",
                  picture.scene, picture.failure);
  Markup panes = pane(picture, source, picture.yours, "yours", "yours");
  panes += pane(picture, source, picture.reference, "reference", "reference");
  panes += pane(picture, source, picture.difference, "difference", "signed error");
  Markup plots = pValuePlot(picture.pValues);
  plots += convergencePlot(picture.convergence);
  return markup(
      "<section class=\"picture\">\n<h4>{}<small>{} \u00D7 {} pixels, {:.6g} rays per "
      "pixel</small></h4>\n<div class=\"sides\">\n<div><div "
      "class=\"compare\">\n{}</div>\n{}</div>\n"
      "<div>{}<div class=\"plots\">\n{}</div></div></div>\n</section>\n",
      picture.scene, picture.width, picture.height, picture.raysPerPixel, panes,
      picture.difference.empty() ? Markup{} : legend(picture.scale), numbers(picture), plots);
}

}  // namespace pathmark::report
