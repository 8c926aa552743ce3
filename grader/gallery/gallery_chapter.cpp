#include "gallery/gallery_chapter.h"

#include "gallery/gallery_scenes.h"
#include "gallery/gallery_sheet.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace pathmark::gallery {

namespace {

constexpr std::string_view kIntroduction = R"(# Gallery of mistakes

What does a picture look like if the cosine is missing, or the last light is never chosen? Below are
mistakes that are easily made, part by part, each in the scene that shows it best, behind the
correct picture of that scene. All other parts are right.

A picture that looks like yours is a hint, not a proof: different mistakes may look alike, two
mistakes may hide each other, and some do not show in pictures at all. What is wrong, and by how
much, is said by `./pathmark check`.

Numbers are relative to the correct picture; "noise" is the standard error of a pixel with as many
rays. Mistakes that leave the mean right are shown with few rays per pixel, where only the noise can
tell. Pixels without a valid number are magenta.
)";

// A | would end a cell.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string partChapter(const Gallery& gallery, int part) {
  const std::vector<Group> groups = groupsOf(gallery, part);
  const auto title = std::find_if(parts().begin(), parts().end(),
                                  [&](const PartContract& p) { return p.part == part; });
  std::string text = fmt::format("\n## Part {}: {}\n\n![Mistakes of part {}](figures/{})\n\n", part,
                                 title->title, part, sheetName(part));
  text += "| | Mistake | In | Scene | What to look for |\n|---:|---|---|---|---|\n";
  std::map<int, std::string> rows;
  for (const Group& group : groups)
    for (std::size_t k = 0; k < group.specimens.size(); ++k) {
      const Specimen& s = *group.specimens[k];
      rows[group.numbers[k]] =
          fmt::format("| {} | {} | `{}` | {} | {} |\n", group.numbers[k], cell(s.variant.what),
                      s.variant.function, s.scene, s.words);
    }
  for (const auto& [number, row] : rows) text += row;
  return text;
}

}  // namespace

std::string sheetName(int part) { return fmt::format("mistakes_part{}.png", part); }

std::string galleryChapter(const Gallery& gallery) {
  std::string text(kIntroduction);
  for (const PartContract& part : parts())
    if (std::any_of(gallery.specimens.begin(), gallery.specimens.end(),
                    [&](const Specimen& s) { return s.variant.part == part.part; }))
      text += partChapter(gallery, part.part);
  text += fmt::format(
      "\nThe pictures have {} pixels along the longer side and {} rays per pixel where it is not "
      "said otherwise.\n",
      kPixels, kManyRays);
  return text;
}

}  // namespace pathmark::gallery
