#include "scene/place.h"

#include "scene/json_text.h"
#include "scene/load_scene.h"
#include "scene/syntax_sentence.h"

#include <fmt/format.h>

namespace pathmark {
namespace {

// Keys are the file's own words, and may be anything.
constexpr std::size_t kLongestPointer = 120;

}  // namespace

std::string Place::pointer() const {
  if (parent_ == nullptr) return {};
  std::string text = parent_->pointer() + '/';
  if (index_ != kNoIndex) return text + std::to_string(index_);
  for (const char c : key_) {
    if (c == '~') {
      text += "~0";
    } else if (c == '/') {
      text += "~1";
    } else {
      text += c;
    }
  }
  return text;
}

void Place::refuse(std::string_view sentence) const {
  const std::string where = pointer();
  const std::size_t line = lineOf(source_->text, where);
  throw SceneError(fmt::format("{}{}{}{}: {}", source_->file.string(),
                               line == 0 ? "" : fmt::format(":{}", line), where.empty() ? "" : ", ",
                               shown(where, kLongestPointer), sentence));
}

void Place::refuse(std::string_view found, std::string_view rule) const {
  refuse(fmt::format("found {}, but {}.", found, rule));
}

}  // namespace pathmark
