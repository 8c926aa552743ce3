#include "report/class_scenes.h"

#include "report/page_html.h"
#include "report/thumbnail.h"

#include <fmt/format.h>

namespace pathmark::report {

namespace {

constexpr int kSide = 160;  // pixels

Markup sceneHtml(const Graded& graded, const record::SceneRecord& scene) {
  const std::string& name = graded.record->name;
  const std::string png =
      graded.pictures ? thumbnail(graded.pictures(scene.picture), kSide) : std::string();
  if (png.empty()) return {};
  const std::string link = escapedUrl(graded.folder + "/report.html");
  const Markup noise = scene.noise.empty() ? Markup{} : markup("<small>{}</small>", scene.noise);
  return markup(
      "<figure class=\"scene\">{}<figcaption><a href=\"{}\">{}</a> <code>{}</code>: "
      "{}{}</figcaption></figure>\n",
      pngImage(png, fmt::format("{} of {}", scene.file, name)), Markup{link}, name, scene.file,
      scene.caption, noise);
}

}  // namespace

Markup classScenes(GradedClass graded) {
  Markup scenes;
  for (const Graded& g : graded)
    for (const record::SceneRecord& scene : g.record->scenes)
      if (!scene.picture.empty()) scenes += sceneHtml(g, scene);
  if (scenes.html.empty()) return {};
  return markup(
      "<section class=\"part\"><h2>Scenes of their own</h2>\n<p class=\"hint\">Points say only "
      "that "
      "a scene can be read, has a caption and is not black. What it shows, and whether the caption "
      "says why it is hard, is for you to judge. Rendered with the solutions.</p>\n"
      "<div class=\"scenes\">\n{}</div></section>\n",
      scenes);
}

}  // namespace pathmark::report
