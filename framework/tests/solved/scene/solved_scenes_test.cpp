// Part 7's scene as it is handed out, and as it is solved.
#include "../../scene/shipped_scenes.h"
#include "scene/load_scene.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

TEST(SolvedScenes, TheStudentsSceneIsValidAndNotWrittenYet) {
  EXPECT_TRUE(loadScene(kRoot / "student" / "scenes" / "my_scene.json").caption.empty());
}

TEST(SolvedScenes, TheSolvedSceneHasACaption) {
  for (const auto& file : sceneFiles(kRoot / "solutions" / "scenes")) {
    const LoadedScene scene = loadScene(file);
    EXPECT_FALSE(scene.caption.empty()) << file;
    EXPECT_TRUE(scene.notes.empty()) << file;
  }
}

}  // namespace
}  // namespace pathmark::test
