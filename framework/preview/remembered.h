// What the window remembers from one time to the next: its size, the scene and the part.
//
// In $XDG_STATE_HOME/pathmark/preview.json, or ~/.local/state if that is not set. A file that is
// missing, damaged or not writable costs nothing but the memory.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace pathmark::preview {

struct Remembered {
  std::optional<int> width{}, height{};  // of the window
  std::optional<std::string> scene{};    // as on the command line
  std::optional<int> part{};
};

// Empty if there is no place for it.
std::filesystem::path rememberedFile();

Remembered readRemembered(const std::filesystem::path& file);
void writeRemembered(const std::filesystem::path& file, const Remembered& remembered);

}  // namespace pathmark::preview
