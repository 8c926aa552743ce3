// What a render promises whatever the coursework is.
#include "host/render_loop.h"
#include "host/session.h"
#include "host/stub_report.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace pathmark::test {
namespace {

RenderedImage render(WorkerProcess& worker, std::uint64_t rays, std::uint32_t threads,
                     std::uint64_t seed) {
  RenderSettings settings;
  settings.width = 37;
  settings.height = 21;
  settings.raysPerPixel = rays;
  settings.threads = threads;
  settings.seed = seed;
  return renderImage(worker, settings, [](const RenderStatus&) { return true; });
}

TEST(Render, ImageHasTheSameBitsForAnyNumberOfThreads) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(37, 21));
  const RenderedImage one = render(*worker, 150, 1, 5);
  EXPECT_EQ(one.raysPerPixel, 150.0);
  for (const std::uint32_t threads : {2u, 3u, 8u, 64u})
    EXPECT_EQ(render(*worker, 150, threads, 5).image.rgb, one.image.rgb) << threads;
}

TEST(Render, SeedsGiveDifferentImagesAndTheSameSeedTheSame) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(37, 21));
  EXPECT_EQ(render(*worker, 4, 2, 1).image.rgb, render(*worker, 4, 2, 1).image.rgb);
  EXPECT_NE(render(*worker, 4, 2, 1).image.rgb, render(*worker, 4, 2, 2).image.rgb);
}

// The pass sees its rays as 0 ... P-1, and each ray of the pixel has numbers of its own.
TEST(Render, PassesContinueTheNumbersOfAPixel) {
  TestCoursework coursework;
  coursework.setFile("part1_stratified.cpp",
                     "Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float,\n"
                     "                                      float) const { return {}; }\n"
                     "Colour LitScene::renderPixel(int, int, const SimpleCamera&, int n,\n"
                     "                             Sampler& sampler) const {\n"
                     "  sampler.startRay(0);\n"
                     "  return Colour(sampler.next1D(), static_cast<float>(n), 0.0f);\n}");
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(37, 21));
  const Image one = render(*worker, 64, 1, 0).image, two = render(*worker, 128, 1, 0).image;
  EXPECT_NE(one.rgb[0], two.rgb[0]);
  EXPECT_EQ(one.rgb[1], 64.0f);
  const Image rest = render(*worker, 100, 1, 0).image;
  EXPECT_FLOAT_EQ(rest.rgb[1], (64.0f * 64.0f + 36.0f * 36.0f) / 100.0f);
}

TEST(Render, WithoutASceneOrWithAFilmOfAnotherSizeIsRefused) {
  TestCoursework coursework;
  EXPECT_THROW(render(*coursework.start(), 4, 2, 0), WorkerError);
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(370, 210));
  EXPECT_THROW(render(*worker, 4, 2, 0), WorkerError);
}

TEST(Render, EverySamplerHasItsOwnNumbersAndTheSameForAnyNumberOfThreads) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(37, 21));
  RenderSettings settings;
  settings.width = 37;
  settings.height = 21;
  settings.raysPerPixel = 100;
  std::set<std::vector<float>> images;
  for (std::size_t kind = 0; kind < kSamplerNames.size(); ++kind) {
    settings.sampler = static_cast<SamplerKind>(kind);
    const auto all = [](const RenderStatus&) { return true; };
    settings.threads = 1;
    const std::vector<float> one = renderImage(*worker, settings, all).image.rgb;
    settings.threads = 5;
    EXPECT_EQ(renderImage(*worker, settings, all).image.rgb, one) << kSamplerNames[kind];
    images.insert(one);
  }
  EXPECT_EQ(images.size(), kSamplerNames.size());
}

TEST(Render, CancellingKeepsWhatThereIs) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(37, 21));
  RenderSettings settings;
  settings.width = 37;
  settings.height = 21;
  settings.raysPerPixel = 1000000000;
  settings.threads = 2;
  const RenderedImage image = renderImage(
      *worker, settings, [](const RenderStatus& status) { return status.seconds < 0.5; });
  EXPECT_FALSE(image.complete);
  EXPECT_GT(image.raysPerPixel, 64.0);
  EXPECT_LT(image.raysPerPixel, 1e9);
  EXPECT_NEAR(image.image.rgb[0], 0.5f, 0.2f);
  EXPECT_EQ(render(*worker, 4, 2, 1).raysPerPixel, 4.0) << "the worker can go on";
}

// A part of the image is the same part of the whole image, and nothing else is touched.
TEST(Render, RegionsHaveTheBitsOfTheWholeImage) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(37, 21));
  const std::vector<float> whole = render(*worker, 4, 1, 0).image.rgb;
  for (const PixelRegion region :
       {PixelRegion{5, 3, 20, 7}, PixelRegion{30, 15, 100, 100}, PixelRegion{-4, -9, 6, 12},
        PixelRegion{50, 50, 9, 9}, PixelRegion{3, 3, -1, 5}}) {
    SharedFilm film(37, 21);
    RenderJob job;
    job.threads = 3;
    job.rays = 4;
    job.raysPerPass = 4;
    job.region = region;
    worker->render(job, film, [](const RenderProgress&) { return true; });
    for (int j = 0; j < 21; ++j)
      for (int i = 0; i < 37; ++i) {
        const bool inside = i >= region.left && i < region.left + region.width && j >= region.top &&
                            j < region.top + region.height;
        const auto at = static_cast<std::size_t>(j * 37 + i);
        const FilmPixel& pixel = film.pixels()[at];
        ASSERT_EQ(pixel.rays, inside ? 4.0 : 0.0) << i << " " << j;
        if (inside) {
          ASSERT_EQ(static_cast<float>(pixel.sum[1] / 4.0), whole[3 * at + 1]);
        }
      }
  }
}

TEST(Render, WarmUpUsesPartZeroOnly) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(8, 8));
  RenderSettings settings;
  settings.width = settings.height = 8;
  settings.estimator = Estimator::kWarmUp;
  const RenderedImage image =
      renderImage(*worker, settings, [](const RenderStatus&) { return true; });
  for (const float value : image.image.rgb) EXPECT_EQ(value, 0.75f);
}

TEST(Render, MisRendersWithTracePathMis) {
  TestCoursework coursework;
  const auto worker = coursework.start();
  worker->loadScene(emptyScene(8, 8));
  RenderSettings settings;
  settings.width = settings.height = 8;
  settings.raysPerPixel = 3;
  settings.estimator = Estimator::kMis;
  const RenderedImage image =
      renderImage(*worker, settings, [](const RenderStatus&) { return true; });
  for (const float value : image.image.rgb) EXPECT_EQ(value, 0.25f);
}

TEST(Render, SplitPathsAreTracePathsWithNumbersOfTheirOwn) {
  TestCoursework coursework;
  coursework.setTracePath(
      "Hit hit;\nif (!intersect(ray, hit)) return Colour(-1.0f);\n"
      "return Colour(0.5f + 0.5f * sampler.next1D(), lights().empty() ? 0.0f : 1.0f, "
      "hit.emission.r);");
  const auto worker = coursework.start();
  SceneOverrides overrides;
  overrides.size = {8, 8};
  worker->loadScene(loadScene(findScene("empty_furnace"), overrides).flat);
  RenderSettings settings;
  settings.width = settings.height = 8;
  settings.raysPerPixel = 2;
  settings.estimator = Estimator::kSplit;
  settings.sharing.pathsPerRay = 4;
  const auto goOn = [](const RenderStatus&) { return true; };
  const RenderedImage split = renderImage(*worker, settings, goOn);
  settings.sharing.directLight = 1;
  const RenderedImage sharing = renderImage(*worker, settings, goOn);
  std::set<float> numbers;
  for (std::size_t k = 0; k < split.image.rgb.size(); k += 3) {
    numbers.insert(split.image.rgb[k]);
    EXPECT_EQ(split.image.rgb[k + 1], 1.0f);
    EXPECT_EQ(split.image.rgb[k + 2], 0.5f);
    // The path with the direct light and the mean of those that do not see it.
    EXPECT_GE(sharing.image.rgb[k], 1.0f);
    EXPECT_EQ(sharing.image.rgb[k + 1], 1.0f);
    EXPECT_EQ(sharing.image.rgb[k + 2], 0.5f);
  }
  EXPECT_EQ(numbers.size(), 64u);
}

TEST(Render, UnwrittenFunctionsAreKnownByTheirMarkerNotTheirValue) {
  TestCoursework coursework;
  coursework.setFile("part6_roulette.cpp",
                     "Roulette LitScene::RussianRoulette(const Colour&, int, float) const {\n"
                     "  PATHMARK_UNIMPLEMENTED(\"part6_roulette.cpp\", "
                     "\"LitScene::RussianRoulette\");\n  return {true, 1.0f};\n}");
  const StubReport report = makeStubReport(coursework.start()->stubs());
  ASSERT_EQ(report.unwritten.size(), 1u);
  EXPECT_EQ(report.unwritten[0].function, CourseworkFunction::kRussianRoulette);
}

TEST(Render, FullyWrittenCourseworkHasNoMarkers) {
  TestCoursework coursework;
  EXPECT_TRUE(makeStubReport(coursework.start()->stubs()).unwritten.empty());
}

}  // namespace
}  // namespace pathmark::test
