#include "scene/json_object.h"

#include <span>

namespace pathmark {

std::string describe(const json& value) {
  switch (value.type()) {
    case json::value_t::object:
      return "an object { ... }";
    case json::value_t::array:
      return fmt::format("an array of {} {}", value.size(),
                         value.size() == 1 ? "entry" : "entries");
    case json::value_t::string:
      return "the text " + inQuotes(value.get_ref<const std::string&>());
    default:
      return value.dump();
  }
}

double readNumber(const json& value, const Place& place) {
  if (!value.is_number()) place.refuse(describe(value), "this must be a number");
  return value.get<double>();
}

glm::dvec3 readVector(const json& value, const Place& place) {
  if (!value.is_array() || value.size() != 3) {
    place.refuse(describe(value), "this must be three numbers [x, y, z] or [r, g, b]");
  }
  glm::dvec3 result(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    result[static_cast<int>(i)] = readNumber(value[i], Place(place, i));
  }
  return result;
}

const std::string& readWord(const json& value, const Place& place) {
  if (!value.is_string()) place.refuse(describe(value), "this must be a text in quotes");
  return value.get_ref<const std::string&>();
}

bool readFlag(const json& value, const Place& place) {
  if (!value.is_boolean()) place.refuse(describe(value), "this must be true or false");
  return value.get<bool>();
}

Object::Object(const json& value, const Place& place, std::string_view what)
    : value_(value), place_(place), what_(what) {
  if (!value.is_object()) {
    place.refuse(describe(value), fmt::format("{} must be an object {{ ... }}", what));
  }
}

void Object::allowOnly(std::initializer_list<std::string_view> keys) const {
  for (const auto& entry : value_.items()) {
    if (std::find(keys.begin(), keys.end(), entry.key()) != keys.end()) continue;
    Place(place_, entry.key())
        .refuse(fmt::format("found the key {}, but {} has no such key; it has {}.{}",
                            inQuotes(entry.key()), what_, fmt::join(keys, ", "),
                            didYouMean(entry.key(), std::span(keys.begin(), keys.size()))));
  }
}

}  // namespace pathmark
