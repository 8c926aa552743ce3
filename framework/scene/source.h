// SceneSource: a scene file and its text, kept while the scene is checked, so that an error can
// name the line of what is wrong.
#pragma once

#include <filesystem>
#include <string>

namespace pathmark {

struct SceneSource {
  std::filesystem::path file;
  std::string text;
};

}  // namespace pathmark
