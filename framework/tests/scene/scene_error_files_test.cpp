// Files that are no scenes, long texts, and overrides, are refused with one sentence too.
#include "scene_error_text.h"

#include <algorithm>
#include <string>
#include <vector>

namespace pathmark {
namespace {

TEST(SceneErrorsOfFiles, TheirSceneIsValidAsItStands) {
  EXPECT_EQ(loadText(kScene).flat.shapes.size(), 4u);
}

TEST(SceneErrorsOfFiles, CommentsAreAllowed) {
  EXPECT_EQ(loadText("// a line\n/* a\nblock */" + std::string(kScene)).flat.shapes.size(), 4u);
}

TEST(SceneErrorsOfFiles, MissingFileFolderAndDevice) {
  const auto errorOfFile = [](const std::filesystem::path& file) -> std::string {
    try {
      loadScene(file);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string missing = errorOfFile("no/such/scene.json");
  EXPECT_EQ(missing, "no/such/scene.json: there is no such file.");
  const std::string folder = errorOfFile(std::filesystem::temp_directory_path());
  EXPECT_NE(folder.find("folder"), std::string::npos) << folder;
  const std::string device = errorOfFile("/dev/zero");
  EXPECT_NE(device.find("device"), std::string::npos) << device;
}

TEST(SceneErrorsOfFiles, EmptyFile) {
  const std::string message = errorOf("");
  EXPECT_NE(message.find("is empty"), std::string::npos) << message;
}

TEST(SceneErrorsOfFiles, FileOfSpaces) {
  const std::string message = errorOf("  \n\n ");
  EXPECT_NE(message.find("ends here"), std::string::npos) << message;
}

TEST(SceneErrorsOfFiles, FileThatIsTooLarge) {
  const TemporaryFile file("{}");
  std::filesystem::resize_file(file.path(), 257u * 1024 * 1024);
  try {
    loadScene(file.path());
    FAIL() << "no error";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("at most 256 MB"), std::string::npos) << error.what();
  }
}

TEST(SceneErrorsOfFiles, TruncatedAnywhere) {
  // The last character is the closing bracket.
  for (std::size_t size = 1; size < kScene.size(); ++size) {
    const std::string message = errorOf(kScene.substr(0, size));
    ASSERT_NE(message, "no error") << size;
    expectOneSentence(message);
  }
}

TEST(SceneErrorsOfFiles, DeepNestingIsRefusedNotFollowed) {
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  for (const std::string& text :
       {std::string(100000, '['), objects, sceneWith(std::string(100000, '['))}) {
    const std::string message = errorOf(text);
    expectOneSentence(message);
    EXPECT_NE(message.find("nested"), std::string::npos) << message;
  }
}

TEST(SceneErrorsOfFiles, OtherKindsOfJsonAreNoScene) {
  for (const char* text : {"[]", "7", "null", "\"scene\"", "true"}) {
    const std::string message = errorOf(text);
    expectOneSentence(message);
    EXPECT_NE(message.find("a scene must be an object"), std::string::npos) << message;
  }
}

TEST(SceneErrorsOfFiles, ShapesMustBeAnArrayAndMaterialsAnObject) {
  const std::string shapes = errorOf(
      R"({"camera": {"eye": [0,0,5], "target": [0,0,0], "fieldOfView": 45}, "shapes": {}})");
  EXPECT_NE(shapes.find("/shapes: found an object"), std::string::npos) << shapes;
  const std::string materials = errorOf(
      R"({"camera": {"eye": [0,0,5], "target": [0,0,0], "fieldOfView": 45}, "shapes": [],
          "materials": []})");
  EXPECT_NE(materials.find("/materials: found an array"), std::string::npos) << materials;
}

TEST(SceneErrorsOfFiles, LongAndStrangeTextIsShownShortAndClean) {
  std::string text(kScene);
  text.replace(text.find("\"white\", \"vertices\""), 7,
               "\"\\u001b[31m" + std::string(100000, 'x') + "\"");
  const std::string message = errorOf(text);
  expectOneSentence(message);
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
}

// Forty characters of three bytes are cut between two of them.
TEST(SceneErrorsOfFiles, LongTextIsCutBetweenCharacters) {
  std::string longText;
  for (int k = 0; k < 40; ++k) longText += "\u201c";
  std::string text(kScene);
  text.replace(text.find("\"white\", \"vertices\""), 7, "\"" + longText + "\"");
  const std::string message = errorOf(text);
  expectOneSentence(message);
  EXPECT_NE(message.find("\u201c..."), std::string::npos) << message;
}

TEST(SceneErrorsOfFiles, LongAndStrangeKeysAreShownShortAndClean) {
  const std::string key = "\\n\\u001b[31m" + std::string(100000, 'x');
  for (const char* there : {"\"exposure\"", "\"radius\"", "\"white\": {"}) {
    std::string text(kScene);
    text.replace(text.find(there), 1, "\"" + key + "\": 1, \"");
    const std::string message = errorOf(text);
    expectOneSentence(message);
    EXPECT_EQ(message.find('\x1b'), std::string::npos);
  }
}

TEST(SceneErrorsOfOverrides, AreCheckedWithTheSameLimits) {
  const std::string size = errorOf(kScene, {.size = std::array{0, 5}});
  EXPECT_NE(size.find("0 x 5"), std::string::npos) << size;
  EXPECT_NE(size.find("from 1 to 16384"), std::string::npos) << size;
  const std::string bounces = errorOf(kScene, {.maxBounces = 1001});
  EXPECT_NE(bounces.find("1001 bounces"), std::string::npos) << bounces;
}

TEST(SceneOverridesTest, ReplaceWhatTheFileSays) {
  const LoadedScene scene = loadText(kScene, {.size = std::array{320, 200}, .maxBounces = 0});
  EXPECT_EQ(scene.flat.camera.width, 320u);
  EXPECT_EQ(scene.flat.camera.height, 200u);
  EXPECT_EQ(scene.flat.maxBounces, 0u);
}

}  // namespace
}  // namespace pathmark
