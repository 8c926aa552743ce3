// Reading values of a scene file, each with its place, so that an error can say where it is. Only
// for the sources that know the JSON library.
//
//   describe                         what was found, for an error
//   readNumber, readVector, ...      one value of a kind
//   Object                           a fixed set of keys
//
// All throw SceneError if a value is of another kind.
#pragma once

#include "scene/place.h"
#include "scene/spelling.h"
#include "scene/syntax_sentence.h"

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace pathmark {

using nlohmann::json;

std::string describe(const json& value);
double readNumber(const json& value, const Place& place);
glm::dvec3 readVector(const json& value, const Place& place);
const std::string& readWord(const json& value, const Place& place);
bool readFlag(const json& value, const Place& place);

// An object of the file with a fixed set of keys. `what` names it in sentences: "a sphere".
class Object {
 public:
  Object(const json& value, const Place& place, std::string_view what);

  // Refuses any other key, with a word on what it may have meant.
  void allowOnly(std::initializer_list<std::string_view> keys) const;

  // Hands the value of a key to read(value, place), if the key is there.
  template <typename Read>
  void optional(std::string_view key, Read&& read) const {
    const auto found = value_.find(key);
    if (found != value_.end()) read(*found, Place(place_, key));
  }

  template <typename Read>
  void required(std::string_view key, Read&& read) const {
    if (!value_.contains(key)) {
      place_.refuse(fmt::format("the key \"{}\" is missing, but {} must have it.", key, what_));
    }
    optional(key, read);
  }

  void optional(std::string_view key, double& result) const {
    optional(key, [&](const json& v, const Place& p) { result = readNumber(v, p); });
  }
  void optional(std::string_view key, glm::dvec3& result) const {
    optional(key, [&](const json& v, const Place& p) { result = readVector(v, p); });
  }
  void optional(std::string_view key, bool& result) const {
    optional(key, [&](const json& v, const Place& p) { result = readFlag(v, p); });
  }
  void optional(std::string_view key, std::string& result) const {
    optional(key, [&](const json& v, const Place& p) { result = readWord(v, p); });
  }
  void required(std::string_view key, double& result) const {
    required(key, [&](const json& v, const Place& p) { result = readNumber(v, p); });
  }
  void required(std::string_view key, glm::dvec3& result) const {
    required(key, [&](const json& v, const Place& p) { result = readVector(v, p); });
  }

  // Sets `result` to the entry of `choices` that the key names.
  template <typename Choice, std::size_t N>
  void requiredChoice(std::string_view key,
                      const std::array<std::pair<std::string_view, Choice>, N>& choices,
                      Choice& result) const {
    required(key, [&](const json& v, const Place& p) {
      std::array<std::string_view, N> names;
      for (std::size_t i = 0; i < N; ++i) names[i] = choices[i].first;
      const std::string& name = readWord(v, p);
      const auto found = std::find(names.begin(), names.end(), name);
      if (found == names.end()) {
        p.refuse(fmt::format("found {}, but allowed is {}.{}", inQuotes(name),
                             fmt::join(names, ", "), didYouMean(name, names)));
      }
      result = choices[static_cast<std::size_t>(found - names.begin())].second;
    });
  }

 private:
  const json& value_;
  const Place& place_;
  std::string what_;
};

}  // namespace pathmark
