// Every malformed mesh, box and transform is refused with one sentence that says where and what.
#include "scene_files.h"

#include <string>
#include <vector>

namespace pathmark {
namespace {

std::string errorOf(const SceneFolder& folder, std::string_view shapes) {
  try {
    folder.load(sceneWith(shapes));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

void expectSays(const std::string& message, const std::vector<std::string>& words) {
  EXPECT_TRUE(message.ends_with('.') || message.ends_with('?')) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_LT(message.size(), 400u) << message;
  for (const std::string& word : words) {
    EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
  }
}

struct MeshCase {
  const char* name;
  std::string text;
  std::vector<std::string> words;
};

void PrintTo(const MeshCase& c, std::ostream* out) { *out << c.name; }

class MeshErrors : public testing::TestWithParam<MeshCase> {};

TEST_P(MeshErrors, SayTheLineAndWhat) {
  SceneFolder folder;
  folder.write("m.obj", GetParam().text);
  const std::string message =
      errorOf(folder, R"({"type": "mesh", "material": "a", "file": "m.obj"})");
  expectSays(message, GetParam().words);
}

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

const MeshCase kMeshCases[] = {
    {"empty", "", {"the file is empty"}},
    {"nothing_but_spaces", " \n\t\n", {"found no face"}},
    {"vertices_only", kThree, {"found no face"}},
    {"letters_for_a_number", "v 0 0 abc\n", {"m.obj:1: found \"abc\"", "a coordinate is a number"}},
    {"number_with_a_tail", "v 0 0 1.5x\n", {"\"1.5x\""}},
    {"comma_for_a_point", "v 0 0 1,5\n", {"\"1,5\""}},
    {"not_a_number", "\nv nan 0 0\n", {"m.obj:2: found \"nan\"", "1e+100"}},
    {"infinite", "v 0 -inf 0\n", {"\"-inf\""}},
    {"too_large", "v 0 1e999 0\n", {"\"1e999\"", "from -1e+100 to 1e+100"}},
    {"out_of_reach", "v 0 1e101 0\n", {"\"1e101\""}},
    {"hexadecimal", "v 0 0x10 0\n", {"\"0x10\""}},
    {"two_coordinates", "v 0 1\n", {"2 numbers", "three coordinates"}},
    {"no_coordinates", "v\n", {"0 numbers"}},
    {"five_numbers", "v 0 1 2 3 4\n", {"5 numbers"}},
    {"eight_numbers", "v 0 1 2 3 4 5 6 7\n", {"more than 7 numbers"}},
    {"unknown_word", kThree + "vv 1 2 3\n", {"m.obj:4: found \"vv\""}},
    {"line_ends_of_the_first_macs",
     "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
     {"m.obj:1: found lines that end in a carriage return", "a line feed"}},
    {"byte_order_mark_further_down", kThree + "\xEF\xBB\xBF" + "f 1 2 3\n", {"m.obj:4: found "}},
    {"json", "{\"type\": \"mesh\"}\n", {"m.obj:1:"}},
    {"bytes",
     std::string("\x7f"
                 "ELF\0\x01\x02",
                 7),
     {"m.obj:1: found \"?ELF???\""}},
    {"index_zero", kThree + "f 0 1 2\n", {"m.obj:4: found the vertex \"0\"", "count from 1"}},
    {"index_beyond", kThree + "f 1 2 4\n", {"\"4\"", "3 vertices stand above"}},
    {"index_before_the_first", kThree + "f 1 2 -4\n", {"\"-4\""}},
    {"index_of_a_later_vertex", "v 0 0 0\nf 1 2 3\nv 1 0 0\nv 0 1 0\n", {"m.obj:2:", "\"2\""}},
    {"index_too_long", kThree + "f 1 2 99999999999999999999\n", {"the vertex \"999999"}},
    {"index_of_32_bits", kThree + "f 1 2 4294967299\n", {"\"4294967299\""}},
    {"index_with_a_point", kThree + "f 1 2 3.0\n", {"\"3.0\"", "as in \"f 1 2 3\""}},
    {"index_of_letters", kThree + "f a b c\n", {"\"a\""}},
    {"index_missing", kThree + "f /1 /2 /3\n", {"\"/1\""}},
    {"face_of_two", kThree + "f 1 2\n", {"a face of 2 vertices", "at least 3"}},
    {"face_of_none", kThree + "f\n", {"a face of 0 vertices"}},
    {"crossed_face",
     "v 0 0 0\nv 4 0 0\nv 0 3 0\nv 2 -1 0\nv 4 3 0\nf 1 2 3 4 5\n",
     {"m.obj:6:", "crosses or touches itself"}},
    {"curve", "cstype bezier\n", {"\"cstype\""}},
    {"only_points", "v 1 1 1\nf 1 1 1\n", {"scene.json:5, /shapes/0: ", "almost nothing"}},
    {"only_lines",
     "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
     {"scene.json:5, /shapes/0: ", "almost nothing"}},
};

INSTANTIATE_TEST_SUITE_P(Obj, MeshErrors, testing::ValuesIn(kMeshCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(MeshErrorsOfFiles, AFaceMayHaveAThousandVertices) {
  SceneFolder folder;
  std::string text = kThree + "f";
  for (int i = 0; i < 1001; ++i) text += " 1";
  folder.write("m.obj", text);
  expectSays(errorOf(folder, R"({"type": "mesh", "material": "a", "file": "m.obj"})"),
             {"m.obj:4:", "at most 1000"});
}

// A mesh of 2^18 triangles, or vertices, and more than 2^6 shapes that are it.
TEST(MeshErrorsOfFiles, TheMeshesOfASceneMayHaveSixteenMillionTrianglesAndVerticesTogether) {
  const auto shapes = [](int count) {
    std::string text;
    for (int k = 0; k < count; ++k)
      text += R"({"type": "mesh", "material": "a", "file": "m.obj"},)";
    text.pop_back();
    return text;
  };
  constexpr int kMany = 1 << 18;
  SceneFolder folder;
  std::string triangles = kThree;
  for (int i = 0; i < kMany; ++i) triangles += "f 1 2 3\n";
  folder.write("m.obj", triangles);
  expectSays(errorOf(folder, shapes(65)),
             {"/shapes/64/file: found a mesh with which the scene has 17039360 triangles",
              "the meshes of a scene may have at most 16777216 together"});
  std::string fan;
  for (int i = 0; i < kMany; ++i) fan += fmt::format("v {} {} 0\n", i, i % 2);
  for (int i = 0; i + 2 < kMany; i += 3) fan += fmt::format("f {} {} {}\n", i + 1, i + 2, i + 3);
  folder.write("m.obj", fan);
  expectSays(errorOf(folder, shapes(70)),
             {"found a mesh with which the scene has", " vertices", "at most 16777216 together"});
}

TEST(MeshErrorsOfFiles, TheLineIsRightInALongFile) {
  SceneFolder folder;
  std::string text = kThree;
  for (int i = 0; i < 100000; ++i) text += i % 10 == 0 ? "# a \\\n comment\n" : "vn 0 0 1\n";
  folder.write("m.obj", text + "f 1 2 7\n");
  expectSays(errorOf(folder, R"({"type": "mesh", "material": "a", "file": "m.obj"})"),
             {"m.obj:110004: found the vertex \"7\""});
}

TEST(MeshErrorsOfFiles, TruncatedAnywhereItIsReadOrRefused) {
  SceneFolder folder;
  const std::string text = kThree + "v 0 0 1\nf 1 3 2\nf 1/1 2//2 4/1/7\n";
  for (std::size_t size = 1; size < text.size(); ++size) {
    folder.write("m.obj", text.substr(0, size));
    const std::string message =
        errorOf(folder, R"({"type": "mesh", "material": "a", "file": "m.obj"})");
    if (message != "no error") expectSays(message, {"m.obj"});
  }
}

TEST(MeshErrorsOfFiles, OnlyFilesBelowTheSceneAreRead) {
  SceneFolder outside, folder;
  outside.write("secret.obj", kThree + "f 1 2 3\n");
  folder.write("below/m.obj", kThree + "f 1 2 3\n");
  const auto ofFile = [&](const std::string& file) {
    return errorOf(folder,
                   fmt::format(R"({{"type": "mesh", "material": "a", "file": "{}"}})", file));
  };
  EXPECT_EQ(ofFile("below/m.obj"), "no error");
  EXPECT_EQ(ofFile("./below/m.obj"), "no error");
  for (const std::string& file :
       {(outside.path() / "secret.obj").string(), std::string("../secret.obj"),
        std::string("below/../../m.obj"), std::string(""), std::string("/etc/passwd"),
        std::string("m.stl"), std::string("below")}) {
    expectSays(ofFile(file), {"scene.json:5, /shapes/0/file: found", "own folder or below it"});
  }
  expectSays(ofFile("none.obj"), {"/shapes/0/file", "there is no file", "none.obj"});
  std::filesystem::create_directory(folder.path() / "folder.obj");
  expectSays(ofFile("folder.obj"), {"this is a folder"});
  std::filesystem::create_symlink(outside.path() / "secret.obj", folder.path() / "link.obj");
  expectSays(ofFile("link.obj"), {"this link leads out of the scene's folder"});
  std::filesystem::create_symlink(folder.path() / "loop.obj", folder.path() / "loop.obj");
  expectSays(ofFile("loop.obj"), {"/shapes/0/file"});
  std::filesystem::create_symlink("below/m.obj", folder.path() / "inside.obj");
  EXPECT_EQ(ofFile("inside.obj"), "no error");
}

TEST(MeshErrorsOfFiles, AMissingFileTellsTheCommandThatMakesIt) {
  SceneFolder folder;
  expectSays(errorOf(folder, R"({"type": "mesh", "material": "a", "file": "m.obj",
                                 "madeBy": "./make it"})"),
             {"there is no file", "this makes it: ./make it"});
}

struct ShapeCase {
  const char* name;
  const char* shape;
  std::vector<std::string> words;
};

void PrintTo(const ShapeCase& c, std::ostream* out) { *out << c.name; }

class BoxErrors : public testing::TestWithParam<ShapeCase> {};

TEST_P(BoxErrors, SayWhereAndWhat) {
  SceneFolder folder;
  folder.write("m.obj", kThree + "f 1 2 3\n");
  expectSays(errorOf(folder, GetParam().shape), GetParam().words);
}

const ShapeCase kShapeCases[] = {
    {"no_high",
     R"({"type": "box", "material": "a", "low": [0, 0, 0]})",
     {"/shapes/0: the key \"high\" is missing"}},
    {"turned_over",
     R"({"type": "box", "material": "a", "low": [0, 0, 0], "high": [1, -1, 1]})",
     {"/shapes/0/high/1: found -1", "above its low one, here 0"}},
    {"no_height",
     R"({"type": "box", "material": "a", "low": [0, 0, 0], "high": [1, 1, 0]})",
     {"/shapes/0/high/2"}},
    {"speck",
     R"({"type": "box", "material": "a", "low": [0.5, 0.5, 0.5],
         "high": [0.5000000001, 0.5000000001, 0.5000000001]})",
     {"/shapes/0: ", "almost nothing"}},
    {"vertices",
     R"({"type": "box", "material": "a", "low": [0, 0, 0], "high": [1, 1, 1], "vertices": []})",
     {"/shapes/0/vertices", "a box has no such key"}},
    {"misspelt_transform",
     R"({"type": "box", "material": "a", "low": [0, 0, 0], "high": [1, 1, 1], "tranform": {}})",
     {"Did you mean \"transform\"?"}},
    {"misspelt_rotation",
     R"({"type": "box", "material": "a", "low": [0, 0, 0], "high": [1, 1, 1],
         "transform": {"rotat": {}}})",
     {"/shapes/0/transform/rotat", "Did you mean \"rotate\"?"}},
    {"transform_of_a_sphere",
     R"({"type": "sphere", "material": "a", "centre": [0, 0, 0], "radius": 1, "transform": {}})",
     {"/shapes/0/transform", "a sphere has no such key"}},
    {"scale_zero",
     R"({"type": "mesh", "material": "a", "file": "m.obj", "transform": {"scale": 0}})",
     {"/shapes/0/transform/scale: found the scale 0"}},
    {"scale_zero_in_y",
     R"({"type": "mesh", "material": "a", "file": "m.obj", "transform": {"scale": [1, 0, 1]}})",
     {"/shapes/0/transform/scale"}},
    {"scale_of_two",
     R"({"type": "mesh", "material": "a", "file": "m.obj", "transform": {"scale": [1, 1]}})",
     {"/shapes/0/transform/scale", "three numbers"}},
    {"scale_in_words",
     R"({"type": "mesh", "material": "a", "file": "m.obj", "transform": {"scale": "big"}})",
     {"the text \"big\""}},
    {"scale_too_large",
     R"({"type": "mesh", "material": "a", "file": "m.obj", "transform": {"scale": 1e101}})",
     {"/shapes/0/transform/scale/0", "1e+100"}},
    {"out_of_reach",
     R"({"type": "mesh", "material": "a", "file": "m.obj",
         "transform": {"scale": 1e100, "translate": [1e100, 1e100, 0]}})",
     {"/shapes/0/transform", "out of reach"}},
    {"no_angle",
     R"({"type": "mesh", "material": "a", "file": "m.obj",
         "transform": {"rotate": {"axis": [0, 1, 0]}}})",
     {"/shapes/0/transform/rotate", "\"angle\" is missing"}},
    {"no_axis",
     R"({"type": "mesh", "material": "a", "file": "m.obj",
         "transform": {"rotate": {"axis": [0, 0, 0], "angle": 3}}})",
     {"/shapes/0/transform/rotate/axis", "zero vector"}},
    {"transform_as_list",
     R"({"type": "mesh", "material": "a", "file": "m.obj", "transform": [1, 2, 3]})",
     {"/shapes/0/transform", "must be an object"}},
    {"mesh_without_file",
     R"({"type": "mesh", "material": "a"})",
     {"/shapes/0: the key \"file\" is missing"}},
    {"mesh_of_a_number", R"({"type": "mesh", "material": "a", "file": 7})", {"/shapes/0/file"}},
};

INSTANTIATE_TEST_SUITE_P(Shape, BoxErrors, testing::ValuesIn(kShapeCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(CameraErrors, ACameraThatSeesNothingIsRefused) {
  SceneFolder folder;
  const std::string behind = R"({"type": "sphere", "material": "a", "centre": [0, 0, 8],
                                 "radius": 1})";
  expectSays(errorOf(folder, behind), {"/camera", "sees none of the shapes"});
  const std::string beside = R"({"type": "triangle", "material": "a",
                                 "vertices": [[9, 0, 0], [10, 0, 0], [9, 1, 0]]})";
  expectSays(errorOf(folder, beside), {"sees none of the shapes"});
  // Around the eye, across the view without a vertex in it, and beside another that is seen.
  for (const std::string& seen :
       {std::string(R"({"type": "sphere", "material": "a", "centre": [0, 0, 8], "radius": 4})"),
        std::string(R"({"type": "triangle", "material": "a",
                        "vertices": [[-99, -1, 0], [99, -1, 0], [0, 99, 0]]})"),
        beside + R"(, {"type": "sphere", "material": "a", "centre": [0, 0, 0], "radius": 1})"}) {
    EXPECT_EQ(errorOf(folder, seen), "no error") << seen;
  }
}

}  // namespace
}  // namespace pathmark
