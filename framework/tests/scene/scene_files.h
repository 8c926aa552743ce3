// What the tests of this folder share: scene files on disk.
//
//   TemporaryFile   a file with a given text, removed afterwards
//   SceneFolder     a folder for a scene and its meshes, removed afterwards
//   loadText        loadScene of a text
//   sceneWith       a small valid scene around the given shapes
#pragma once

#include "scene/load_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace pathmark {

class TemporaryFile {
 public:
  explicit TemporaryFile(std::string_view text) {
    // Tests run as processes at the same time.
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = fmt::format("pathmark-{}-{}.json", getpid(), test ? test->name() : "none");
    for (char& c : name) c = c == '/' ? '-' : c;
    path_ = std::filesystem::temp_directory_path() / name;
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

class SceneFolder {
 public:
  SceneFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "pathmark-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~SceneFolder() { std::filesystem::remove_all(path_); }
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  LoadedScene load(std::string_view text) const {
    write("scene.json", text);
    return loadScene(path_ / "scene.json");
  }

 private:
  std::filesystem::path path_;
};

inline LoadedScene loadText(std::string_view text, const SceneOverrides& overrides = {}) {
  return loadScene(TemporaryFile(text).path(), overrides);
}

// With the lambertian materials "a" and "b", and the eye at (0,0,5) looking at the origin.
inline std::string sceneWith(std::string_view shapes) {
  return fmt::format(R"({{
    "camera": {{"eye": [0, 0, 5], "target": [0, 0, 0], "fieldOfView": 45}},
    "materials": {{"a": {{"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
                  "b": {{"type": "lambertian", "Kd": [0, 0, 0]}}}},
    "shapes": [{}]
  }})",
                     shapes);
}

}  // namespace pathmark
