#include "gallery/gallery_chapter.h"

#include "gallery/gallery_sheet.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace pathmark::gallery {

namespace {

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

std::string galleryChapter(const Gallery& gallery, std::string_view before) {
  std::string text(before.substr(0, before.find("\n## Part ")));
  if (text.empty()) text = "# Gallery of mistakes\n";
  for (const PartContract& part : parts())
    if (std::any_of(gallery.specimens.begin(), gallery.specimens.end(),
                    [&](const Specimen& s) { return s.variant.part == part.part; }))
      text += partChapter(gallery, part.part);
  return text;
}

}  // namespace pathmark::gallery
