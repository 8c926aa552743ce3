// What must not be in a kit is found in it, wherever and however it is put there.
#include "kit/small_project.h"
#include "worker/contract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHandout = "handouts/part3_lambertian.md";
constexpr const char* kPicture = "handouts/figures/scenes.png";
constexpr const char* kReference = "scenes/references/furnace.exr";

// From the line that declares it to the line that closes it.
std::string bodyOf(const std::string& text, const std::string& function) {
  const std::string name = " " + function + "(";
  const std::size_t at = text.find(name);
  const std::size_t begin = text.rfind('\n', at) + 1;
  return text.substr(begin, text.find("\n}\n", at) + 3 - begin);
}

std::string solved(const SmallProject& project, const std::string& function) {
  for (const FunctionContract& f : contract())
    if (f.name == function)
      return bodyOf(project.read("solutions/" + std::string(partNumbered(f.part).file)), function);
  return {};
}

// The chunk of a PNG file that holds a note, with a checksum that nobody asks for here.
std::string pngNote(const std::string& type, const std::string& text) {
  std::string chunk;
  for (int shift = 24; shift >= 0; shift -= 8)
    chunk += static_cast<char>(text.size() >> shift & 0xffu);
  return chunk + type + text + "0000";
}

void insertBeforeTheEnd(const SmallProject& project, const std::string& chunk) {
  constexpr std::size_t kEndChunk = 12;
  std::string picture = project.read(kPicture);
  picture.insert(picture.size() - kEndChunk, chunk);
  project.write(kPicture, picture);
}

TEST(KitHiddenText, NothingIsFoundWhereNothingIs) {
  const SmallProject project;
  const kit::WrittenKit written = project.makeKit();
  EXPECT_EQ(written.outcome, kit::KitOutcome::kWritten);
  EXPECT_EQ(written.inspection.findings, std::vector<std::string>{});
  EXPECT_TRUE(fs::exists(project.inKit("student/part3_lambertian.cpp")));
  EXPECT_FALSE(fs::exists(project.inKit("solutions")));
  EXPECT_FALSE(fs::exists(project.inKit("grader")));
}

TEST(KitHiddenText, EveryFunctionOfTheSolutionsIsFoundInAHandout) {
  const SmallProject project;
  const std::string handout = project.read(kHandout);
  for (const FunctionContract& function : contract()) {
    SCOPED_TRACE(function.name);
    const std::string code = solved(project, std::string(function.name));
    ASSERT_GT(code.size(), 100u);
    project.write(kHandout, handout + "\n```cpp\n" + code + "```\n");
    project.expectRefused("handouts/part3_lambertian.md:" +
                          std::to_string(3 + std::count(handout.begin(), handout.end(), '\n')) +
                          " quotes ");
  }
}

TEST(KitHiddenText, IsFoundWithOtherLineBreaksAndIndentation) {
  const SmallProject project;
  const std::string code = solved(project, "phongBRDF::brdf");
  project.append(kHandout, std::regex_replace(code, std::regex("\\s+"), " "));
  project.expectRefused("quotes solutions/part4_phong.cpp:");
}

TEST(KitHiddenText, IsFoundInCommentsAndAsAQuotation) {
  for (const char* mark : {"// ", "> ", "+", " * ", "| "}) {
    SCOPED_TRACE(mark);
    const SmallProject project;
    const std::string code = solved(project, "phongBRDF::reflection");
    project.append("student/part4_phong.cpp",
                   mark + std::regex_replace(code, std::regex("\n"), std::string("\n") + mark));
    project.expectRefused("student/part4_phong.cpp:");
  }
}

TEST(KitHiddenText, IsFoundInStrings) {
  for (const char* lineBreak : {"\\n", "\\n\"\n    \""}) {
    SCOPED_TRACE(lineBreak);
    const SmallProject project;
    const std::string code = solved(project, "phongBRDF::reflection");
    project.append(kHandout, "{\"hint\": \"");
    project.append(kHandout, std::regex_replace(code, std::regex("\n"), lineBreak));
    project.append(kHandout, "\"}\n");
    project.expectRefused("quotes solutions/part4_phong.cpp:");
  }
}

TEST(KitHiddenText, IsFoundWithCommentsTakenOutOrPutIn) {
  const SmallProject without;
  without.append(kHandout, std::regex_replace(without.read("solutions/part6_roulette.cpp"),
                                              std::regex("//[^\n]*\n"), ""));
  without.expectRefused("quotes solutions/part6_roulette.cpp:");
  const SmallProject with;
  with.append(kHandout, std::regex_replace(solved(with, "phongBRDF::reflection"), std::regex("\n"),
                                           "\n// a comment\n"));
  with.expectRefused("quotes solutions/part4_phong.cpp:");
}

TEST(KitHiddenText, ThreeShortLinesAreFound) {
  const SmallProject project;
  project.append(kHandout,
                 "const float cosTheta = 1.0f;\n"
                 "    const vec3 s = ray.origin - triangle.positions[0];\n\n"
                 "    const vec3 r = cross(s, e1);\n"
                 "    const float b1 = dot(s, q) / determinant;\n");
  project.expectRefused("quotes solutions/part0_warmup.cpp:");
}

TEST(KitHiddenText, IsFoundInTheBytesOfPictures) {
  for (const char* picture : {kPicture, kReference}) {
    SCOPED_TRACE(picture);
    const SmallProject project;
    project.append(picture, solved(project, "lambertianBRDF::reflection"));
    project.expectRefused(std::string(picture) + ":");
  }
}

TEST(KitHiddenText, IsFoundInTheNotesOfAPngFile) {
  const SmallProject project;
  insertBeforeTheEnd(project, pngNote("tEXt", solved(project, "LitScene::RussianRoulette")));
  project.expectRefused("quotes solutions/part6_roulette.cpp:");
}

TEST(KitHiddenText, WhatCannotBeSearchedIsRefused) {
  const SmallProject notes;
  insertBeforeTheEnd(notes, pngNote("zTXt", "compressed"));
  notes.expectRefused("handouts/figures/scenes.png is a PNG file with more in it than a picture");
  const SmallProject tail;
  tail.append(kPicture, "PK");
  tail.expectRefused("handouts/figures/scenes.png is a PNG file with more after its picture");
  const SmallProject program;
  program.write(kHandout, std::string("\x7f") + "ELF\x02\x01\x01");
  program.expectRefused("handouts/part3_lambertian.md is not text");
  const SmallProject archive;
  archive.write(kReference, "PK\x03\x04");
  archive.expectRefused("scenes/references/furnace.exr is neither a PNG nor an OpenEXR file");
}

TEST(KitHiddenText, HiddenFilesAreFoundUnderAnotherName) {
  const SmallProject test;
  test.copy("grader/tests/part4_phong_test.cpp", "handouts/notes.md");
  test.expectRefused("handouts/notes.md is a copy of grader/tests/part4_phong_test.cpp");
  const SmallProject small;
  small.copy("grader/tests/support/test_scene.cpp", "handouts/notes.md");
  small.expectRefused("handouts/notes.md is a copy of grader/tests/support/test_scene.cpp");
  const SmallProject scene;
  scene.copy("solutions/scenes/my_scene.json", "handouts/notes.md");
  scene.append("handouts/notes.md", "\n");
  scene.expectRefused("handouts/notes.md:1 quotes solutions/scenes/my_scene.json:1");
}

TEST(KitHiddenText, VariantsAreAnswersToo) {
  const SmallProject project;
  const std::string patch = project.read("grader/variants/wrong/part4_half_vector.patch");
  const std::size_t firstHunk = patch.find("@@");
  project.append(kHandout, patch.substr(patch.find('\n', firstHunk) + 1));
  project.expectRefused("handouts/part3_lambertian.md:");
}

TEST(KitHiddenText, FoldersOfThisMachineAreFound) {
  const SmallProject project;
  project.append(kHandout, "\nSee " + project.path().string() + "/notes.txt\n");
  project.expectRefused(" names " + project.path().string() + ", a folder of this machine");
}

TEST(KitHiddenText, SomebodysOwnCourseworkInPlaceOfAStubIsFound) {
  const SmallProject project;
  std::string text = project.read("student/part6_roulette.cpp");
  const std::string stub =
      "PATHMARK_UNIMPLEMENTED(\"part6_roulette.cpp\", \"LitScene::RussianRoulette\");";
  text.erase(text.find(stub), stub.size());
  project.write("student/part6_roulette.cpp", text);
  project.expectRefused(
      "student/part6_roulette.cpp does not have the stub of LitScene::RussianRoulette");
}

}  // namespace
}  // namespace pathmark::test
