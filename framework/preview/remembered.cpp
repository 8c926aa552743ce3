#include "preview/remembered.h"

#include "film/atomic_file.h"
#include "film/image.h"
#include "preview/part_picture.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <system_error>

namespace pathmark::preview {

namespace fs = std::filesystem;

namespace {

constexpr int kSmallest = 320, kLargest = 16384;  // sides of a window
constexpr int kLastPart = 9;

std::optional<int> number(const nlohmann::json& json, const char* name, int low, int high) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_number_integer()) return std::nullopt;
  const auto value = found->get<std::int64_t>();
  if (value < low || value > high) return std::nullopt;
  return static_cast<int>(value);
}

}  // namespace

fs::path rememberedFile() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0')
    return fs::path(state) / "pathmark/preview.json";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return fs::path(home) / ".local/state/pathmark/preview.json";
  return {};
}

Remembered readRemembered(const fs::path& file) {
  std::ifstream in(file);
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  Remembered result;
  if (!json.is_object()) return result;
  result.width = number(json, "width", kSmallest, kLargest);
  result.height = number(json, "height", kSmallest, kLargest);
  result.part = number(json, "part", 0, kLastPart);
  if (result.part && !isPart(*result.part)) result.part.reset();
  if (const auto scene = json.find("scene"); scene != json.end() && scene->is_string())
    result.scene = scene->get<std::string>();
  return result;
}

void writeRemembered(const fs::path& file, const Remembered& remembered) {
  if (file.empty()) return;
  nlohmann::json json = nlohmann::json::object();
  if (remembered.width) json["width"] = *remembered.width;
  if (remembered.height) json["height"] = *remembered.height;
  if (remembered.scene) json["scene"] = *remembered.scene;
  if (remembered.part) json["part"] = *remembered.part;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  try {
    writeFileAtomically(file, json.dump(2) + "\n");
  } catch (const ImageError&) {
    return;
  }
}

}  // namespace pathmark::preview
