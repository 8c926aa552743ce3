// Place: where in a scene file something stands, so that an error can say it.
//
// A place knows its parent and its own key or index; the JSON pointer is only put together when
// it is needed, so that walking over a million numbers builds no strings.
#pragma once

#include "scene/source.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace pathmark {

class Place {
 public:
  // The top of the file. The source must outlive the place and those below it.
  explicit Place(const SceneSource& source) : source_(&source) {}
  explicit Place(const SceneSource&& source) = delete;

  // The value of a key, or an entry of an array, of the value at `parent`, which must outlive it.
  Place(const Place& parent, std::string_view key)
      : source_(parent.source_), parent_(&parent), key_(key) {}
  Place(const Place& parent, std::size_t index)
      : source_(parent.source_), parent_(&parent), index_(index) {}
  Place(const Place&& parent, std::string_view key) = delete;
  Place(const Place&& parent, std::size_t index) = delete;

  // RFC 6901, such as /shapes/3/radius; empty for the top.
  std::string pointer() const;

  // Throws SceneError "file:line, pointer: sentence".
  [[noreturn]] void refuse(std::string_view sentence) const;

  // Throws SceneError "file:line, pointer: found `found`, but `rule`."
  [[noreturn]] void refuse(std::string_view found, std::string_view rule) const;

 private:
  static constexpr std::size_t kNoIndex = static_cast<std::size_t>(-1);

  const SceneSource* source_;
  const Place* parent_ = nullptr;
  std::string_view key_;
  std::size_t index_ = kNoIndex;
};

}  // namespace pathmark
