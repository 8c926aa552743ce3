// The scenes of a coursework are looked at one after another, and may be left off between them.
#include "checks/scene_checks.h"
#include "host/worker_process.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace pathmark::checks {
namespace {

// With a caption, and without a material: what is wrong with it is its format.
constexpr const char* kScene = R"({"caption": "Nothing.", "shapes": []})";
constexpr const char* kGoodScene = R"({"caption": "A lamp.", "size": [4, 4],
  "camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "fieldOfView": 45},
  "materials": {"a": {"type": "lambertian", "Kd": [0.5, 0.5, 0.5]}},
  "shapes": [{"type": "sphere", "material": "a", "centre": [0, 0, 0], "radius": 1,
              "emission": [1, 1, 1]}]})";

class SceneChecks : public testing::Test {
 protected:
  void write(const std::string& name, const char* scene) {
    std::filesystem::create_directories(folder_ / "scenes");
    std::ofstream(folder_ / ("scenes/" + name)) << scene;
  }

  test::TemporaryFolder folder_;
};

TEST_F(SceneChecks, AreLeftOffBetweenScenesAndKeepWhatWasFound) {
  for (const char* name : {"a.json", "b.json", "c.json", "d.json"}) write(name, kScene);
  int asked = 0;
  WholeWorker worker;
  worker.blocker = "part 3";
  worker.goOn = [&] { return ++asked <= 2; };
  const std::vector<SceneFinding> findings = checkScenes(folder_.path(), worker, 1);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[1].file.filename(), "b.json");
}

TEST_F(SceneChecks, AreLeftOffWithinASceneAndKeepWhatWasFound) {
  write("a.json", kScene);
  write("b.json", kGoodScene);
  write("c.json", kScene);
  WholeWorker worker;
  worker.goOn = [] { return true; };
  worker.get = []() -> WorkerProcess& { throw WorkerStopped(); };
  const std::vector<SceneFinding> findings = checkScenes(folder_.path(), worker, 1);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].status, Status::kFail);
}

}  // namespace
}  // namespace pathmark::checks
