// Paths of the solutions, and of solutions with a mistake.
#include "host/session.h"
#include "preview/paths/path_recording.h"
#include "preview/paths/path_text.h"
#include "solved/support/solutions.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace pathmark::preview {
namespace {

constexpr int kSide = 16;

LoadedScene load(const std::string& name) {
  SceneOverrides overrides;
  overrides.size = {kSide, kSide};
  return loadScene(findScene(name), overrides);
}

PathRequest requestFor(const std::string& scene, const std::filesystem::path& coursework) {
  auto previewed = std::make_shared<PreviewScene>();
  previewed->loaded = load(scene);
  auto state = std::make_shared<CourseworkState>();
  state->build = std::make_shared<CourseworkBuild>(buildCoursework(coursework));
  state->number = 1;
  EXPECT_EQ(state->build->failure(), "");
  PathRequest request;
  request.camera = previewed->loaded.flat.camera;
  request.scene = previewed;
  request.coursework = state;
  return request;
}

bool wanted() { return true; }

// Asks for some pixels of the picture.
template <class Look>
void record(PathRequest request, const Look& look) {
  PathRecording recording;
  for (request.row = 1; request.row < kSide; request.row += 4)
    for (request.column = 0; request.column < kSide; request.column += 3) {
      const PathAnswer answer = recording.record(request, wanted);
      ASSERT_EQ(answer.failure, "");
      ASSERT_EQ(answer.paths.size(), request.rays);
      EXPECT_EQ(answer.remark, "");
      look(answer);
    }
}

// With an expression they are the paths of the filtered picture, and say what was left out.
TEST(SolvedPathsOfAnExpression, AddUpToThePictureAndTellWhatIsLeftOut) {
  PathRequest request = requestFor("cornell_phong", test::solutions().folder);
  RenderOptions options;
  options.raysPerPixel = 64;
  options.paths = PathExpression("LDE|LSSE");
  const LoadedScene& scene = request.scene->loaded;
  request.automaton = settingsFor(scene, options).automaton;
  const Image image = renderScene(test::solutions(), scene, options).rendered.image;
  int leftOut = 0, shadowRaysLeftOut = 0, visible = 0;
  record(request, [&](const PathAnswer& answer) {
    const auto pixel = image.pixel(answer.request.column, answer.request.row);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(answer.mean[c], pixel[static_cast<std::size_t>(c)]);
    for (const PathAccount& account : answer.accounts) {
      EXPECT_TRUE(account.fits);
      for (const std::string& remark : account.remarks) ADD_FAILURE() << remark;
    }
    for (const TracedPath& path : answer.paths) {
      leftOut += path.leftOut ? 1 : 0;
      if (path.leftOut) {
        EXPECT_EQ(endOf(path), "other paths");
      }
      for (const PathVertex& vertex : path.vertices)
        for (const ShadowRay& ray : vertex.shadowRays) {
          shadowRaysLeftOut += ray.visibility == Visibility::kLeftOut ? 1 : 0;
          visible += ray.visibility == Visibility::kVisible ? 1 : 0;
        }
    }
  });
  EXPECT_GT(leftOut, 0);
  EXPECT_GT(shadowRaysLeftOut, 0);
  EXPECT_GT(visible, 0);
}

class SolvedPaths : public testing::TestWithParam<const char*> {};

TEST_P(SolvedPaths, AddUpToWhatTheyReturnAndTheMeanIsThePixel) {
  const PathRequest request = requestFor(GetParam(), test::solutions().folder);
  RenderOptions options;
  options.raysPerPixel = 64;
  const Image image = renderScene(test::solutions(), request.scene->loaded, options).rendered.image;
  std::size_t vertices = 0, shadowRays = 0, own = 0;
  record(request, [&](const PathAnswer& answer) {
    const auto pixel = image.pixel(answer.request.column, answer.request.row);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(answer.mean[c], pixel[static_cast<std::size_t>(c)]);
      EXPECT_EQ(answer.pixel[c], pixel[static_cast<std::size_t>(c)]);
    }
    for (const PathAccount& account : answer.accounts) {
      EXPECT_TRUE(account.fits);
      for (const std::string& remark : account.remarks) ADD_FAILURE() << remark;
      vertices += account.vertices.size();
      for (const VertexAccount& v : account.vertices) {
        shadowRays += v.shadowRays.size();
        own += v.own ? 1 : 0;
      }
    }
  });
  EXPECT_GT(vertices, 0u);
  EXPECT_GT(shadowRays, 0u);
  EXPECT_EQ(own, vertices);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SolvedPaths,
                         testing::Values("cornell_box", "cornell_spheres", "cornell_phong",
                                         "veach_plates", "many_lights", "ucl_sphere"));

class SolvedMisPaths : public testing::TestWithParam<const char*> {};

TEST_P(SolvedMisPaths, AddUpByTheirWeightsAndTheMeanIsThePixel) {
  PathRequest request = requestFor(GetParam(), test::solutions().folder);
  request.made = pictureOfPart(8);
  RenderOptions options;
  options.raysPerPixel = 64;
  options.estimator = Estimator::kMis;
  const Image image = renderScene(test::solutions(), request.scene->loaded, options).rendered.image;
  std::size_t sampled = 0, met = 0;
  record(request, [&](const PathAnswer& answer) {
    const auto pixel = image.pixel(answer.request.column, answer.request.row);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(answer.mean[c], pixel[static_cast<std::size_t>(c)]);
    for (const PathAccount& account : answer.accounts) {
      EXPECT_TRUE(account.known && account.fits);
      for (const std::string& remark : account.remarks) ADD_FAILURE() << remark;
      for (std::size_t k = 0; k < account.vertices.size(); ++k) {
        const VertexAccount& v = account.vertices[k];
        sampled += v.found && *v.found != Colour(0.0f) ? 1 : 0;
        met += k > 0 && v.emissionWeight ? 1 : 0;
      }
    }
  });
  EXPECT_GT(sampled, 0u);
  EXPECT_GT(met, 0u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SolvedMisPaths,
                         testing::Values("cornell_box", "cornell_spheres", "cornell_phong",
                                         "ucl_sphere"));

// With many lights one is chosen, and what the weights are only the coursework knows.
TEST(SolvedMisPathsOfManyLights, AreNotJudged) {
  PathRequest request = requestFor("many_lights", test::solutions().folder);
  request.made = pictureOfPart(8);
  std::size_t unknown = 0;
  record(request, [&](const PathAnswer& answer) {
    for (const PathAccount& account : answer.accounts) {
      unknown += account.known ? 0 : 1;
      for (const std::string& remark : account.remarks) ADD_FAILURE() << remark;
    }
  });
  EXPECT_GT(unknown, 0u);
}

TEST(SolvedWarmUp, AddsUpToWhatItReturns) {
  PathRequest request = requestFor("cornell_box", test::solutions().folder);
  request.made = pictureOfPart(0);
  std::size_t bounces = 0;
  record(request, [&](const PathAnswer& answer) {
    for (std::size_t i = 0; i < answer.paths.size(); ++i) {
      EXPECT_TRUE(answer.accounts[i].fits);
      for (const std::string& remark : answer.accounts[i].remarks) ADD_FAILURE() << remark;
      for (const PathVertex& vertex : answer.paths[i].vertices) bounces += vertex.next ? 1 : 0;
    }
  });
  EXPECT_GT(bounces, 0u);
}

// The solutions with something replaced.
class Mistake {
 public:
  Mistake(const std::string& file, const std::string& right, const std::string& wrong) {
    for (const auto& entry : std::filesystem::directory_iterator(test::solutions().folder))
      if (entry.is_regular_file())
        std::filesystem::copy_file(entry.path(), folder_ / entry.path().filename().string());
    std::ifstream in(folder_ / file);
    std::string code(std::istreambuf_iterator<char>(in), {});
    const std::size_t at = code.find(right);
    if (at == std::string::npos) throw std::runtime_error(file + " has no " + right);
    std::ofstream(folder_ / file) << code.replace(at, right.size(), wrong);
  }

  // How many paths have a remark with these words, of the pixels' paths with two vertices or more.
  void expectRemark(const std::string& words) const {
    std::size_t with = 0, remarkable = 0;
    record(requestFor("cornell_box", folder_.path()), [&](const PathAnswer& answer) {
      for (const PathAccount& account : answer.accounts) {
        remarkable += account.vertices.size() > 2 ? 1 : 0;
        with += std::any_of(account.remarks.begin(), account.remarks.end(),
                            [&](const std::string& r) { return r.find(words) != r.npos; })
                    ? 1
                    : 0;
      }
    });
    EXPECT_GT(remarkable, 0u);
    EXPECT_GE(2 * with, remarkable) << words;
  }

 private:
  test::TemporaryFolder folder_;
};

TEST(PathWithAMistake, ThatLosesTheCosineShowsIt) {
  Mistake("part5_path.cpp", "dot(hit.n, next.wi) / next.pdf", "1.0f / next.pdf")
      .expectRemark("Is the cosine missing?");
}

TEST(PathWithAMistake, ThatLosesTheDensityShowsIt) {
  Mistake("part5_path.cpp", "dot(hit.n, next.wi) / next.pdf", "dot(hit.n, next.wi)")
      .expectRemark("Is the division by the density missing?");
}

TEST(PathWithAMistake, ThatDoesNotMultiplyTheThroughputUpShowsIt) {
  Mistake("part5_path.cpp", "throughput * directLighting(", "directLighting(")
      .expectRemark("Direct light has not been multiplied by the throughput.");
}

TEST(PathWithAMistake, OfACosineAtTheLightShowsIt) {
  Mistake("part2_lights.cpp", "(cosX * cosY /", "(cosX /")
      .expectRemark("but Le f G V / pdf of its shadow rays adds up to");
}

}  // namespace
}  // namespace pathmark::preview
