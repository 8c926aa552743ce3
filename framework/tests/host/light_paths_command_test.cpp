// --paths, as a user would type it.
#include "film/image_file.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace pathmark::test {
namespace {

// Where the paths are does not matter here, only that they are asked for.
class LightPathsCommand : public testing::Test {
 protected:
  LightPathsCommand() {
    coursework_.setTracePath(
        "Hit hit;\nif (!intersect(ray, hit)) return Colour(0.0f);\n"
        "return Colour(sampler.next1D()) * (hit.emission + Colour(0.25f));");
  }

  ProcessResult pathmark(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), PATHMARK_PROGRAM);
    return run(arguments, folder_.path());
  }
  ProcessResult render(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"render", "cornell_phong", "--with",
                                         coursework_.folder().string(), "--size", "16x16"});
    return pathmark(arguments);
  }
  ProcessResult explain(const std::string& scene, const std::string& paths) const {
    return pathmark({"render", scene, "--paths", paths, "--explain"});
  }

  TemporaryFolder folder_;
  TestCoursework coursework_;
};

TEST_F(LightPathsCommand, AMistakeIsASentenceWithACaret) {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"render", "furnace"}, {"contact-sheet", "furnace"}}) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {"--paths", "L(S|D*E"});
    expectSays(pathmark(arguments), 2,
               "--paths: this group is never closed: its ) is missing.\n  L(S|D*E\n   ^\n");
  }
  expectSays(render({"--paths", ""}), 2, "an expression is needed");
  expectSays(render({"--paths", "EDL"}), 2, "written from the light to the eye");
  expectSays(render({"--paths", "L..........S.*E"}), 2, "too intricate");
}

TEST_F(LightPathsCommand, IsNotForTheWarmUp) {
  expectSays(render({"--paths", "LE", "--warm-up"}), 2, "--paths and --warm-up");
}

TEST_F(LightPathsCommand, HelpNamesWhatIsRefused) {
  expectSays(pathmark({"render", "--help"}), 0, "; not with --warm-up, --mis or --reuse\n");
}

TEST_F(LightPathsCommand, IsKeptInTheImageAndToldOfIt) {
  ASSERT_EQ(render({"--paths", "L S E", "--output", "s.exr"}).exitCode, 0);
  ASSERT_EQ(render({"--output", "all.exr"}).exitCode, 0);
  EXPECT_EQ(readImage(folder_ / "s.exr").origin.paths, "LSE");
  EXPECT_EQ(readImage(folder_ / "all.exr").origin.paths, "");
  const ProcessResult result = pathmark({"compare", "s.exr", "all.exr"});
  expectSays(result, 1, "light paths LSE");
  expectSays(result, 1, "They show different light paths: LSE and all light.");
}

TEST_F(LightPathsCommand, AnotherExpressionIsNotGoneOnWith) {
  const std::vector<std::string> whole{"--rays-per-pixel", "64", "--output", "a.exr"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), whole.begin(), whole.end());
    return render(more);
  };
  ASSERT_EQ(with({"--paths", "LDE", "--keep-checkpoint"}).exitCode, 0);
  expectSays(with({"--paths", "LSE", "--resume"}), 2, "its light paths are LDE, not LSE");
  expectSays(with({"--resume"}), 2, "its light paths are LDE, not of all light");
  expectSays(with({"--paths", "L D E", "--resume"}), 0, "Going on from");
}

TEST_F(LightPathsCommand, ExplainsWhatIsLeftOut) {
  expectSays(explain("cornell_box", "LS+DE"), 0, "LS+DE: none, the picture is black");
  expectSays(explain("cornell_box", "LS+DE"), 0, "no surface has a specular lobe (S)");
  expectSays(explain("cornell_box", "L.........E"), 0,
             "its paths have at least 9 scattering events, and maxBounces is 8");
  expectSays(explain("cornell_box", "LD*E"), 0, "LD*E: all of the scene's");
  expectSays(explain("cornell_phong", "LDD?E"), 0, "1 to 2 scattering events");
  expectSays(explain("cornell_phong", "LDD?E"), 0, "no ray goes on from surface 3");
  expectSays(explain("cornell_phong", "LD*E"), 0, "only the lobe that is asked for");
  expectSays(explain("cornell_phong", "L.E"), 0, "D and S are never told apart");
  expectSays(explain("cornell_phong", "LD.*E"), 0, "one by chance");
  EXPECT_EQ(pathmark({"render", "cornell_box", "--explain"}).output.find("light paths"),
            std::string::npos);
}

TEST_F(LightPathsCommand, AContactSheetHasAPictureOfEach) {
  const ProcessResult result =
      pathmark({"contact-sheet", "cornell_phong", "--with", coursework_.folder().string(),
                "--thumbnail", "16", "--rays-per-pixel", "4", "--paths", "LE", "L.*SE"});
  expectSays(result, 0, "\nLE ");
  expectSays(result, 0, "\nL.*SE ");
  expectSays(result, 0, "2 of 2 pictures");
}

}  // namespace
}  // namespace pathmark::test
