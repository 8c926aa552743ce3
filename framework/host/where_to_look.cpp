#include "host/where_to_look.h"

#include "host/display_path.h"

#include <fmt/format.h>

namespace pathmark {

std::string handoutOf(const PartContract& part) {
  return fmt::format("handouts/{}.md", part.file.substr(0, part.file.rfind('.')));
}

std::string placeOf(const FunctionContract& function, const std::filesystem::path& folder) {
  const PartContract& part = partNumbered(function.part);
  return fmt::format("{} {} in {}; the chapter is {}.", function.section, function.name,
                     displayPath(folder / part.file), handoutOf(part));
}

}  // namespace pathmark
