// A scene to make mistakes in, and what is said of them.
#pragma once

#include "scene_files.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace pathmark {

inline constexpr std::string_view kScene = R"({
  "caption": "A test",
  "camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 45},
  "size": [64, 48],
  "maxBounces": 4,
  "raysPerPixel": 16,
  "exposure": 2,
  "materials": {
    "white": {"type": "lambertian", "Kd": [0.7, 0.7, 0.7]},
    "shiny": {"type": "phong", "Kd": [0.2, 0.2, 0.2], "Ks": [0.5, 0.5, 0.5], "exponent": 10}
  },
  "shapes": [
    {"type": "triangle", "material": "white", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]},
    {"type": "rectangle", "material": "white", "emission": [1, 1, 1], "frontOnly": true,
     "vertices": [[0, 2, 0], [1, 2, 0], [1, 2, 1], [0, 2, 1]]},
    {"type": "polygon", "material": "shiny",
     "vertices": [[0, 0, 1], [3, 0, 1], [3, 3, 1], [1, 1, 1], [0, 3, 1]]},
    {"type": "sphere", "material": "shiny", "centre": [0, 0, -3], "radius": 1.5, "inward": false}
  ]
})";

inline std::string errorOf(std::string_view text, const SceneOverrides& overrides = {}) {
  try {
    loadText(text, overrides);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

inline void expectOneSentence(const std::string& message) {
  ASSERT_FALSE(message.empty());
  EXPECT_TRUE(message.back() == '.' || message.back() == '?') << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(message.find("exception"), std::string::npos) << message;
  EXPECT_LT(message.size(), 400u) << message;
}

}  // namespace pathmark
