// Any text is a scene or refused with a sentence, and a scene's arrays hold together.
#include "fuzz/fuzz_target.h"
#include "scene/load_scene.h"

#include <cstdlib>
#include <filesystem>

using namespace pathmark;

namespace {

bool isSentence(const std::string& text) {
  return !text.empty() && (text.back() == '.' || text.back() == '?') &&
         text.find('\n') == std::string::npos && text.size() < 1000;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The folder of the meshes that a scene of the corpus may name.
  static const std::filesystem::path file = std::filesystem::path(PATHMARK_FUZZ_MESHES) / "a.json";
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const LoadedScene scene = loadScene(SceneSource{file, text});
    const std::vector<std::byte> block = packScene(scene.flat);
    if (!viewScene(block)) std::abort();
  } catch (const SceneError& error) {
    if (!isSentence(error.what())) std::abort();
  }
  return 0;
}
