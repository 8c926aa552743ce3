#include "report/mistake_html.h"

#include "report/page_html.h"

namespace pathmark::report {

namespace {

using record::MistakePicture;

constexpr double kSeen = 0.02;  // relative: less is not seen
constexpr double kAlike = 0.25;

Markup small(const std::string& png, std::string_view alt, std::string_view name) {
  Markup image = pngImage(png, alt);
  if (image.html.empty()) image = Markup{"<p class=\"missing\">The file is missing.</p>"};
  return markup("<figure class=\"pane\">{}<figcaption>{}</figcaption></figure>\n", image, name);
}

bool showsSomething(const MistakePicture& m, const std::string& invalid) {
  return m.bias.low >= kSeen || !invalid.empty();
}

std::string sentence(const MistakePicture& m, const std::string& invalid) {
  if (!invalid.empty()) return fmt::format("It shows in your picture: {}.", invalid);
  if (m.bias.low < kSeen)
    return "It hardly shows in the picture: the checks found it, the eye would not.";
  if (looksAlike(m))
    return fmt::format(
        "Your picture looks like the one that this mistake alone makes: it is off by {:.0f} %, and "
        "differs from that one by {:.1f} %.",
        100.0 * m.bias.value, 100.0 * m.apart.value);
  return fmt::format(
      "Beside it is what this mistake alone makes of the same scene. Yours differs from that too, "
      "by {:.0f} %: there may be something else.",
      100.0 * m.apart.value);
}

}  // namespace

bool looksAlike(const MistakePicture& m) {
  return m.bias.low >= kSeen && m.apart.value < kAlike * m.bias.value;
}

Markup mistakeHtml(const MistakePicture& m, const std::string& invalid,
                   const PictureSource& source) {
  Markup panes;
  if (showsSomething(m, invalid)) {
    panes += small(source(m.yours), fmt::format("{}: yours", m.scene), "yours");
    panes += small(source(m.picture), fmt::format("{}: with this mistake", m.scene),
                   "with this mistake");
    panes += small(source(m.reference), fmt::format("{}: correct", m.scene), "correct");
  }
  return markup(
      "<section class=\"mistake\">\n<h4>{}<small>{}</small></h4>\n<p>{}</p>\n"
      "<div class=\"alike\">\n{}</div>\n</section>\n",
      m.what, m.scene, sentence(m, invalid), panes);
}

}  // namespace pathmark::report
