// Every malformed scene is refused with one sentence that says where and what.
#include "scene_files.h"

#include <algorithm>
#include <string>
#include <vector>

namespace pathmark {
namespace {

// A scene in which one piece of text is replaced by another.
constexpr std::string_view kScene = R"({
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

struct Case {
  const char* name;
  std::string_view found;     // this piece of kScene ...
  std::string_view replaced;  // ... becomes this
  std::string_view pointer;   // the JSON pointer or the line that the sentence says
  std::vector<std::string_view> words;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

std::string errorOf(std::string_view text, const SceneOverrides& overrides = {}) {
  try {
    loadText(text, overrides);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

void expectOneSentence(const std::string& message) {
  ASSERT_FALSE(message.empty());
  EXPECT_TRUE(message.back() == '.' || message.back() == '?') << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(message.find("exception"), std::string::npos) << message;
  EXPECT_LT(message.size(), 400u) << message;
}

class SceneErrors : public testing::TestWithParam<Case> {};

TEST_P(SceneErrors, SayWhereAndWhat) {
  const Case& c = GetParam();
  std::string text(kScene);
  const std::size_t at = text.find(c.found);
  ASSERT_NE(at, std::string::npos) << "the test looks for what is not in its scene";
  text.replace(at, c.found.size(), c.replaced);
  const std::string message = errorOf(text);
  expectOneSentence(message);
  EXPECT_NE(message.find(std::string(c.pointer) + ": "), std::string::npos) << message;
  const auto line = 1 + std::count(kScene.begin(), kScene.begin() + static_cast<long>(at), '\n');
  if (c.pointer.starts_with("/")) {
    EXPECT_NE(message.find(fmt::format(".json:{}, ", line)), std::string::npos) << message;
  }
  for (const std::string_view word : c.words) {
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
  }
}

const Case kCases[] = {
    // Syntax
    {"trailing_comma",
     "\"radius\": 1.5, \"inward\": false",
     "\"radius\": 1.5,",
     ".json:18:81",
     {"found \"}\" right after a comma, but a comma is followed by another entry."}},
    {"trailing_comma_in_an_array",
     "[64, 48]",
     "[64, 48,]",
     ".json:4:19",
     {"found \"]\" right after a comma"}},
    {"missing_colon", "\"maxBounces\": 4", "\"maxBounces\" 4", ".json:5:16", {"':'"}},
    {"missing_quote",
     "\"maxBounces\": 4",
     "maxBounces: 4",
     ".json:5:3",
     {"found \"maxBounces\"", "JSON wants a text in \"quotes\" here"}},
    {"missing_opening_quote",
     "\"maxBounces\": 4",
     "maxBounces\": 4",
     ".json:5:3",
     {"found \"maxBounces\"", "a text in \"quotes\""}},
    {"line_break_in_a_text",
     "A test",
     "A\ntest",
     ".json:2:14",
     {"found the text \"A\" without a quote at its end", "on one line: \\n in it"}},
    {"break_of_windows_in_a_text", "A test", "A\r\ntest", ".json:2:14", {"the text \"A\" without"}},
    {"unclosed_quote",
     "\"A test\"",
     "\"A test",
     ".json:2:14",
     {"the text \"A test,\" without a quote"}},
    {"unclosed_quote_after_others",
     "\"A test\"",
     "\"A \\\"t\\\" \\\\",
     ".json:2:14",
     {"without a quote at its end"}},
    {"unclosed_quote_of_a_key",
     "\"maxBounces\":",
     "\"maxBounces:",
     ".json:5:3",
     {"\"maxBounces: 4,\""}},
    {"unclosed_quote_at_the_end",
     "\"inward\": false}\n  ]\n}",
     "\"inward",
     ".json:18:82",
     {"the text \"inward\" without a quote"}},
    {"backslash_at_the_end",
     "\"inward\": false}\n  ]\n}",
     "\"inward\\",
     ".json:18:82",
     {"without a quote"}},
    {"number_at_the_end",
     "1.5, \"inward\": false}\n  ]\n}",
     "1.",
     ".json:18:79",
     {"the file ends here"}},
    {"no_digits_of_a_character",
     "A test",
     "A \\u12 test",
     ".json:2:21",
     {"found \"A \\u12\" in a text, but \\u is followed by the four"}},
    {"tab_in_a_text", "A test", "A\ttest", ".json:2:16", {"found a tab after \"A\"", "as \\t."}},
    {"bell_in_a_text", "A test", "A\atest", ".json:2:16", {"a control character", "as \\u0007."}},
    {"break_in_a_text_of_utf8", "A test", "UTF-8\ntest", ".json:2:14", {"on one line"}},
    {"wrong_backslash",
     "A test",
     "A\\test\\qA",
     ".json:2:21",
     {"found \"\\q\"", "written as \\\\."}},
    {"typographic_quotes",
     "\"caption\"",
     "\u201ccaption\u201d",
     ".json:2:3",
     {"found \"\u201c\" (U+201C)", "plain quotes"}},
    {"typographic_quotes_of_a_value",
     "\"A test\"",
     "\u201eA test\u201c",
     ".json:2:14",
     {"found \"\u201e\" (U+201E)", "plain quotes"}},
    {"single_quotes", "\"A test\"", "'A test'", ".json:2:14", {"found \"'\"", "plain quotes"}},
    {"letter_of_two_bytes", "1.5", "\u00e91", ".json:18:77", {"found \"\u00e9\" (U+00E9)"}},
    {"space_that_does_not_break",
     "1.5,",
     "1.5\u00a0,",
     ".json:18:80",
     {"(U+00A0), but JSON wants a comma or '}' here"}},
    {"space_after_a_word",
     "false}",
     "false\u00a0}",
     ".json:18:97",
     {"(U+00A0), but JSON wants a comma or '}' here"}},
    {"column_behind_longer_letters",
     "[0, 1, 0], \"fieldOfView\": 45",
     "[0, 1, 0] /* \u00e9\u201c */ x",
     ".json:3:78",
     {"found \"x\""}},
    {"bad_utf8_outside_of_texts", "1.5", "\xff", ".json:18:77", {"UTF-8"}},
    {"suffix_of_a_float", "1.5,", "0.8f,", ".json:18:77", {"found \"0.8f\", which is no number"}},
    {"suffix_at_the_end",
     "1.5, \"inward\": false}",
     "0.8f}",
     ".json:18:77",
     {"found \"0.8f\", which is no number"}},
    {"number_that_breaks_off", "1.5,", "1.,", ".json:18:77", {"found \"1.\", which is no number"}},
    {"number_without_a_zero", "1.5", ".5", ".json:18:77", {"found \".5\", which is no number"}},
    {"number_with_a_zero", "1.5", "01", ".json:18:77", {"found \"01\", which is no number"}},
    {"two_numbers", "1.5", "1.5 2", ".json:18:81", {"found \"2\", but JSON wants a comma"}},
    {"word_that_breaks_off", "false}", "fals}", ".json:18:92", {"found \"fals\""}},
    {"open_comment",
     "\"inward\": false}\n  ]\n}",
     "/* x",
     ".json:18:86",
     {"a comment is still open"}},
    {"number_too_large", "1.5", "1e999", ".json:18:77", {"1e999", "1.8e308"}},
    {"not_a_number", "1.5", "NaN", ".json:18:77", {"JSON"}},
    {"second_value",
     "\"inward\": false}\n  ]\n}",
     "\"inward\": false}\n  ]\n} {}",
     ".json:20:3",
     {"JSON"}},
    {"cut_off", "\"inward\": false}\n  ]\n}", "\"inward\": false}", ".json:18:98", {"ends here"}},
    {"bad_utf8", "A test", "A \xff test", ".json:2:17", {"UTF-8"}},
    {"repeated_key", "\"exposure\": 2", "\"exposure\": 2, \"exposure\": 3", "/exposure", {"twice"}},
    {"repeated_key_of_a_shape",
     "\"radius\": 1.5",
     "\"radius\": 1.5, \"radius\": 3",
     "/shapes/3/radius",
     {"twice"}},
    {"deep_vertex",
     "[1, 0, 0]",
     "[[[[[[[[[[[[[[1]]]]]]]]]]]]]]",
     "/0",
     {"nested", "/shapes/0/vertices/1/0/0"}},
    // Keys
    {"unknown_key",
     "\"raysPerPixel\"",
     "\"raysPerPixl\"",
     "/raysPerPixl",
     {"Did you mean \"raysPerPixel\"?"}},
    {"american_centre",
     "\"centre\"",
     "\"center\"",
     "/shapes/3/center",
     {"a sphere", "Did you mean \"centre\"?"}},
    {"key_of_another_shape",
     "\"inward\": false",
     "\"vertices\": []",
     "/shapes/3/vertices",
     {"a sphere", "radius"}},
    {"key_of_another_material",
     "\"Kd\": [0.7, 0.7, 0.7]",
     "\"Kd\": [0.7, 0.7, 0.7], \"Ks\": 1",
     "/materials/white/Ks",
     {"a lambertian material"}},
    {"key_with_a_slash", "\"exposure\"", "\"a/b~c\"", "/a~1b~0c", {"no such key"}},
    {"missing_radius", "\"radius\": 1.5, ", "", "/shapes/3", {"\"radius\" is missing"}},
    {"missing_material",
     "\"material\": \"white\", \"vertices\"",
     "\"vertices\"",
     "/shapes/0",
     {"\"material\" is missing"}},
    {"missing_field_of_view", ", \"fieldOfView\": 45", "", "/camera", {"fieldOfView"}},
    {"unknown_shape",
     "\"sphere\"",
     "\"spere\"",
     "/shapes/3/type",
     {"\"spere\"", "Did you mean \"sphere\"?"}},
    {"unknown_material_type",
     "\"phong\"",
     "\"glass\"",
     "/materials/shiny/type",
     {"lambertian, phong"}},
    {"unknown_material",
     "\"material\": \"white\", \"vertices\"",
     "\"material\": \"wite\", \"vertices\"",
     "/shapes/0/material",
     {"Did you mean \"white\"?"}},
    // Kinds of values
    {"text_for_number", "1.5", "\"1.5\"", "/shapes/3/radius", {"the text \"1.5\"", "number"}},
    {"null_for_number", "1.5", "null", "/shapes/3/radius", {"null", "number"}},
    {"number_for_flag",
     "\"inward\": false",
     "\"inward\": 1",
     "/shapes/3/inward",
     {"true or false"}},
    {"array_for_text", "\"A test\"", "[\"A test\"]", "/caption", {"array of 1 entry", "text"}},
    {"two_coordinates",
     "[0, 0, -3]",
     "[0, -3]",
     "/shapes/3/centre",
     {"array of 2 entries", "three numbers"}},
    {"text_in_vertex", "[1, 0, 0]", "[1, \"0\", 0]", "/shapes/0/vertices/1/1", {"number"}},
    {"shape_as_number",
     "{\"type\": \"triangle\"",
     "7, {\"type\": \"triangle\"",
     "/shapes/0",
     {"found 7", "object"}},
    {"camera_as_array",
     "{\"eye\": [0, 0, 5], \"target\": [0, 0, 0], \"up\": [0, 1, 0], \"fieldOfView\": 45}",
     "[]",
     "/camera",
     {"array of 0 entries", "a camera must be an object"}},
    {"material_as_array",
     "{\"type\": \"lambertian\", \"Kd\": [0.7, 0.7, 0.7]}",
     "[0.7, 0.7, 0.7]",
     "/materials/white",
     {"a material must be an object"}},
    {"size_of_three", "[64, 48]", "[64, 48, 1]", "/size", {"[width, height]"}},
    // Values
    {"negative_radius", "1.5", "-1", "/shapes/3/radius", {"found -1", "above 0"}},
    {"tiny_radius", "1.5", "1e-200", "/shapes/3/radius", {"1e-200", "from 1e-100"}},
    {"speck_of_a_sphere", "1.5", "1e-20", "/shapes/3/radius", {"beside the rest"}},
    {"far_coordinate",
     "[0, 0, -3]",
     "[0, -1e101, -3]",
     "/shapes/3/centre/1",
     {"-1e+101", "from -1e+100 to 1e+100"}},
    {"negative_emission", "[1, 1, 1]", "[1, -0.5, 1]", "/shapes/1/emission/1", {"-0.5"}},
    {"bright_reflectance",
     "[0.7, 0.7, 0.7]",
     "[0.7, 0.7, 1.5]",
     "/materials/white/Kd/2",
     {"1.5", "from 0 to 1"}},
    {"too_much_reflectance",
     "[0.5, 0.5, 0.5]",
     "[0.5, 0.9, 0.5]",
     "/materials/shiny",
     {"Kd + Ks = 1.1", "channel 1", "at most 1"}},
    {"negative_exponent",
     "\"exponent\": 10",
     "\"exponent\": -1",
     "/materials/shiny/exponent",
     {"from 0 to 1000000"}},
    {"large_exponent", "\"exponent\": 10", "\"exponent\": 1e7", "/materials/shiny/exponent", {}},
    {"no_field_of_view",
     "\"fieldOfView\": 45",
     "\"fieldOfView\": 180",
     "/camera/fieldOfView",
     {"180", "between 0 and 180"}},
    {"target_at_eye", "\"target\": [0, 0, 0]", "\"target\": [0, 0, 5]", "/camera/target", {"eye"}},
    {"no_up", "\"up\": [0, 1, 0]", "\"up\": [0, 0, 0]", "/camera/up", {"zero vector"}},
    {"up_along_view", "\"up\": [0, 1, 0]", "\"up\": [0, 0, -2]", "/camera/up", {"looks"}},
    {"no_width", "[64, 48]", "[0, 48]", "/size/0", {"from 1 to 16384"}},
    {"half_a_pixel", "[64, 48]", "[64, 47.5]", "/size/1", {"47.5", "whole number"}},
    {"large_image", "[64, 48]", "[64, 16385]", "/size/1", {"16385"}},
    {"negative_bounces",
     "\"maxBounces\": 4",
     "\"maxBounces\": -1",
     "/maxBounces",
     {"from 0 to 1000"}},
    {"broken_bounces", "\"maxBounces\": 4", "\"maxBounces\": 2.5", "/maxBounces", {"whole"}},
    {"no_rays", "\"raysPerPixel\": 16", "\"raysPerPixel\": 0", "/raysPerPixel", {"from 1"}},
    {"no_exposure", "\"exposure\": 2", "\"exposure\": 0", "/exposure", {"above 0"}},
    // Shapes as a whole
    {"triangle_of_four",
     "[0, 1, 0]]",
     "[0, 1, 0], [1, 1, 0]]",
     "/shapes/0/vertices",
     {"4 vertices", "triangle must have 3"}},
    {"rectangle_of_three",
     ", [0, 2, 1]",
     "",
     "/shapes/1/vertices",
     {"3 vertices", "rectangle must have 4"}},
    {"polygon_of_two",
     "[[0, 0, 1], [3, 0, 1], [3, 3, 1], [1, 1, 1], [0, 3, 1]]",
     "[[0, 0, 1], [3, 0, 1]]",
     "/shapes/2/vertices",
     {"2 vertices"}},
    {"skew_rectangle", "[0, 2, 1]]", "[0, 2, 1.001]]", "/shapes/1/vertices", {"parallelogram"}},
    {"flat_rectangle",
     "[1, 2, 1], [0, 2, 1]",
     "[1, 2, 0], [0, 2, 0]",
     "/shapes/1/vertices",
     {"no area"}},
    {"flat_polygon",
     "[[0, 0, 1], [3, 0, 1], [3, 3, 1], [1, 1, 1], [0, 3, 1]]",
     "[[0, 0, 1], [1, 0, 1], [2, 0, 1]]",
     "/shapes/2/vertices",
     {"no area"}},
    {"bow_tie",
     "[[0, 0, 1], [3, 0, 1], [3, 3, 1], [1, 1, 1], [0, 3, 1]]",
     "[[0, 0, 1], [3, 3, 1], [3, 0, 1], [0, 3, 1]]",
     "/shapes/2/vertices",
     {"edge 0-1 meets edge 2-3", "must not touch or cross itself"}},
    {"bow_tie_askew",
     "[[0, 0, 1], [3, 0, 1], [3, 3, 1], [1, 1, 1], [0, 3, 1]]",
     "[[0, 0, 0], [3, 3, 3], [3, 0, 1], [0, 3, 2]]",
     "/shapes/2/vertices",
     {"edge 0-1 meets edge 2-3"}},
    {"polygon_there_and_back",
     "[[0, 0, 1], [3, 0, 1], [3, 3, 1], [1, 1, 1], [0, 3, 1]]",
     "[[0, 0, 1], [1, 0, 1], [2, 0, 1], [1, 0, 1]]",
     "/shapes/2/vertices",
     {"no area", "a point or a line"}},
    {"bent_polygon", "[0, 3, 1]]", "[0, 3, 1.1]]", "/shapes/2/vertices", {"plane"}},
    {"crossed_polygon",
     "[1, 1, 1], [0, 3, 1]",
     "[1, -1, 1], [0, 3, 1]",
     "/shapes/2/vertices",
     {"edge 0-1 meets edge 2-3"}},
    {"speck_of_a_rectangle",
     "[0, 2, 0], [1, 2, 0], [1, 2, 1], [0, 2, 1]",
     "[1, 2, 0], [1.000000001, 2, 0], [1.000000001, 2, 1e-9], [1, 2, 1e-9]",
     "/shapes/1/vertices",
     {"beside the rest"}},
};

INSTANTIATE_TEST_SUITE_P(Scene, SceneErrors, testing::ValuesIn(kCases),
                         [](const auto& test) { return std::string(test.param.name); });

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
