// The paths that are recorded of the solutions are those of the picture, to the last bit.
#include "host/blob_file.h"
#include "host/coursework_builder.h"
#include "host/session.h"
#include "render/plan.h"
#include "solved/support/solutions.h"
#include "support/test_coursework_files.h"

#include <pathmark/types.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace pathmark::test {
namespace {

constexpr int kSide = 16;
constexpr std::uint64_t kRays = 64;

std::unique_ptr<WorkerProcess> start(const std::filesystem::path& program, const FlatScene& scene) {
  WorkerProcess::Options options;
  options.program = program;
  options.courseworkFolder = solutions().folder;
  auto worker = std::make_unique<WorkerProcess>(std::move(options));
  worker->loadScene(scene);
  return worker;
}

std::filesystem::path recordingWorker() {
  static const LinkedWorker linked = linkForRecording(buildCoursework(solutions().folder));
  EXPECT_EQ(linked.failure, "");
  return linked.worker;
}

FlatScene sceneOf(const std::filesystem::path& file) {
  SceneOverrides overrides;
  overrides.size = {kSide, kSide};
  return loadScene(file, overrides).flat;
}

RenderJob wholeImage(Estimator estimator) {
  RenderJob job;
  job.estimator = estimator;
  job.seed = 3;
  job.rays = job.raysPerPass = kRays;
  job.region = {0, 0, kSide, kSide};
  return job;
}

// The mean over the paths as the solution of part 1 forms it.
Colour meanOf(const RecordedPaths& recorded) {
  glm::dvec3 sum(0.0);
  for (const PathEvent& event : recorded.events)
    if (event.kind == PathEventKind::kRadiance)
      sum += glm::dvec3(vec3(event.a[0], event.a[1], event.a[2]));
  return sum / static_cast<double>(kRays);
}

void expectSamePaths(const FlatScene& scene, Estimator estimator = Estimator::kPath) {
  const auto onStatus = [](const RenderProgress&) { return true; };
  SharedFilm film(kSide, kSide);
  start(solutions().worker, scene)->render(wholeImage(estimator), film, onStatus);

  const auto worker = start(recordingWorker(), scene);
  SharedFilm same(kSide, kSide);
  worker->render(wholeImage(estimator), same, onStatus);
  for (std::size_t i = 0; i < film.pixels().size(); ++i)
    for (int c = 0; c < 3; ++c) ASSERT_EQ(film.pixels()[i].sum[c], same.pixels()[i].sum[c]) << i;

  double seen = 0.0;
  for (int row = 1; row < kSide; row += 3)
    for (int column = 0; column < kSide; column += 3) {
      RenderJob job = wholeImage(estimator);
      job.region = {column, row, 1, 1};
      SharedFilm recordedFilm(kSide, kSide);
      const RecordedPaths recorded = worker->recordPaths(job, recordedFilm, onStatus);
      ASSERT_EQ(recorded.counts.paths, kRays);
      const auto at = static_cast<std::size_t>(row * kSide + column);
      const Colour mean = meanOf(recorded);
      for (int c = 0; c < 3; ++c) {
        ASSERT_EQ(film.pixels()[at].sum[c], recordedFilm.pixels()[at].sum[c]);
        ASSERT_EQ(static_cast<float>(film.pixels()[at].sum[c] / static_cast<double>(kRays)),
                  mean[c])
            << "pixel " << column << " " << row;
        seen += film.pixels()[at].sum[c];
      }
    }
  EXPECT_GT(seen, 0.0) << "there is something to see";
}

TEST(RecordedImage, HasThePathsOfABoxOfQuads) {
  expectSamePaths(sceneOf(findScene("cornell_box")));
}

TEST(RecordedImage, HasThePathsOfSpheresUnderASphere) {
  expectSamePaths(sceneOf(findScene("cornell_spheres")));
}

TEST(RecordedImage, HasThePathsOfPhongMaterials) {
  expectSamePaths(sceneOf(findScene("cornell_phong")));
}

TEST(RecordedImage, HasThePathsOfManyLights) { expectSamePaths(sceneOf(findScene("many_lights"))); }

TEST(RecordedImage, HasThePathsOfAMeshInAHierarchy) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "meshes");
  std::filesystem::copy_file(shippedSceneFile("blob"), folder / "scene.json");
  ASSERT_GE(writeBlobFile(folder / "meshes/blob.obj", 4), kFewestForHierarchy);
  expectSamePaths(sceneOf(folder / "scene.json"));
}

TEST(RecordedImage, HasThePathsOfTheWarmUp) {
  expectSamePaths(sceneOf(findScene("cornell_box")), Estimator::kWarmUp);
}

}  // namespace
}  // namespace pathmark::test
