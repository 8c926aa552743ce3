// Values that are no radiance: which function was the first to return one.
#include "host/invalid_origin.h"
#include "support/path_event.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"

#include <pathmark/types.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace pathmark::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(FirstInvalid, IsOfThePathThatReturnedIt) {
  FlatScene scene;
  scene.materials.push_back({FlatMaterialKind::kPhong, {}, {}, 10.0f});
  const std::vector<PathEvent> paths{
      event(PathEventKind::kPath),
      event(PathEventKind::kReflection, vec3(1.0f), vec3(1.0f), vec3(1.0f), kNan),
      event(PathEventKind::kRadiance, vec3(1.0f)),
      event(PathEventKind::kPath),
      event(PathEventKind::kHit),
      event(PathEventKind::kPdf, vec3(1.0f), vec3(1.0f), vec3(0.0f), kNan),
      event(PathEventKind::kRadiance, vec3(kNan)),
  };
  EXPECT_EQ(firstInvalid(paths, scene, Estimator::kPath),
            "In that pixel the first was returned by phongBRDF::pdf (part 4): the density NaN.");
  EXPECT_EQ(firstInvalid(std::span(paths).first(3), scene, Estimator::kPath), "");
}

// Its direction is not to be used then.
TEST(FirstInvalid, IsNotASampleOfDensity0) {
  const std::vector<PathEvent> path{
      event(PathEventKind::kPath),
      event(PathEventKind::kReflection, vec3(1.0f), vec3(kNan), vec3(1.0f), 0.0f),
      event(PathEventKind::kRadiance, vec3(kNan)),
  };
  EXPECT_EQ(firstInvalid(path, {}, Estimator::kPath),
            "In that pixel the first was returned by LitScene::tracePath (part 5): the radiance "
            "(NaN, NaN, NaN).");
}

class InvalidOrigin : public testing::Test {
 protected:
  InvalidOrigin() {
    coursework_.setTracePath(
        "Hit hit;\nif (!intersect(ray, hit)) return Colour(0.0f);\n"
        "return directLighting(hit, -ray.direction, sampler);");
    setDirectLighting("return hit.brdf->brdf(wo, hit.n, hit.n);");
  }

  void setDirectLighting(const std::string& body) {
    coursework_.setFile(
        "part2_lights.cpp",
        "LightSample Polygon::TriangularSampling(float, float) const { return {}; }\n"
        "LightSample Polygon::RectangularSampling(float s, float) const {\n"
        "  return {p(0), normal(), std::sqrt(s - 2.0f)};\n}\n"
        "LightSample Polygon::PolygonSampling(float, float) const { return {}; }\n"
        "LightSample Sphere::sample(const Point&, float, float) const { return {}; }\n"
        "float Sphere::pdf(const Point&, const Point&, const Vector&) const { return 1.0f; }\n"
        "Colour LitScene::directLighting(const Hit& hit, const Vector& wo,\n"
        "                                Sampler& sampler) const {\n"
        "(void)hit; (void)wo; (void)sampler;\n" +
            body + "\n}");
  }

  void setLambertianBrdf(const std::string& body) {
    coursework_.setFile(
        "part3_lambertian.cpp",
        "Colour lambertianBRDF::brdf(const Vector& wo, const Vector& wi,\n"
        "                            const Vector& n) const {\n"
        "(void)wo; (void)wi; (void)n;\n" +
            body +
            "\n}\n"
            "float lambertianBRDF::pdf(const Vector&, const Vector&, const Vector&) const {\n"
            "  return 1.0f;\n}\n"
            "DirectionSample lambertianBRDF::reflection(const Vector&, const Vector& n, float,\n"
            "                                           float, float) const {\n"
            "  return {n, 1.0f};\n}");
  }

  void expectSaid(const std::string& words, const std::vector<std::string>& more = {}) {
    std::vector<std::string> command{PATHMARK_PROGRAM, "render",   "cornell_box",
                                     "--with",         folder(),   "--size",
                                     "16x16",          "--output", (output_ / "a.png").string()};
    command.insert(command.end(), more.begin(), more.end());
    expectSays(run(command), 1, words);
  }

  std::string folder() const { return coursework_.folder().string(); }

  TestCoursework coursework_;
  TemporaryFolder output_;
};

TEST_F(InvalidOrigin, NamesTheBrdfThatReturnedNaN) {
  setLambertianBrdf("return Colour(0.5f, wo.x < 0.05f ? 0.5f : std::sqrt(-wo.x), 0.5f);");
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--rays-per-pixel", "100"},
                                             {"--rays-per-pixel", "32", "--replicates", "4"},
                                             {"--rays-per-pixel", "64", "--target-error", "50%"}})
    expectSaid(
        "In that pixel the first was returned by lambertianBRDF::brdf (part 3): the value (0.5, "
        "NaN, 0.5).",
        more);
}

// One in ten thousand rays, as from a square root of a little less than 0.
TEST_F(InvalidOrigin, FindsTheRayAmongManyPasses) {
  coursework_.setTracePath(
      "Hit hit;\nif (!intersect(ray, hit)) return Colour(0.0f);\n"
      "if (sampler.next1D() > 1e-4f) return Colour(0.5f);\n"
      "return hit.brdf->brdf(-ray.direction, hit.n, hit.n);");
  setLambertianBrdf("return Colour(1.0f / (wo.x - wo.x));");
  expectSaid("first was returned by lambertianBRDF::brdf (part 3)", {"--rays-per-pixel", "512"});
}

TEST_F(InvalidOrigin, NamesTheBrdfThatReturnedANegativeValue) {
  setLambertianBrdf("return Colour(-0.5f);");
  expectSaid("lambertianBRDF::brdf (part 3): the value (-0.5, -0.5, -0.5).");
}

TEST_F(InvalidOrigin, BlamesTheCallerForADirectionThatIsNone) {
  setDirectLighting("return hit.brdf->brdf(wo, normalize(Vector(0.0f)), hit.n);");
  setLambertianBrdf("return Colour(wi.x);");
  expectSaid(
      "the first was passed by LitScene::directLighting (part 2) to lambertianBRDF::brdf (part 3)");
}

TEST_F(InvalidOrigin, NamesTheFunctionThatSamplesTheLight) {
  setDirectLighting("return Colour(1.0f / lights()[0].sample(hit.p, sampler.next1D(), 0.5f).pdf);");
  expectSaid("Polygon::RectangularSampling (part 2): the density");
}

TEST_F(InvalidOrigin, NamesThePathItself) {
  coursework_.setTracePath("(void)sampler; return Colour(std::sqrt(-2.0f + ray.direction.x));");
  expectSaid("LitScene::tracePath (part 5): the radiance (");
}

TEST_F(InvalidOrigin, NamesRenderPixelWherePathsAreRight) {
  coursework_.setFile("part1_stratified.cpp", R"(
Ray SimpleCamera::StratifiedRandomRay(int, int, int, int, int, float, float) const { return {}; }
Colour LitScene::renderPixel(int, int, const SimpleCamera&, int n, Sampler& sampler) const {
  sampler.startRay(0);
  return tracePath(Ray{}, sampler) / static_cast<float>(n - n);
})");
  coursework_.setTracePath("(void)ray; (void)sampler; return Colour(0.5f);");
  expectSaid("LitScene::renderPixel (part 1): no path has returned one.");
}

TEST_F(InvalidOrigin, OfPart8NamesItsPath) {
  coursework_.setFile("part8_mis.cpp", R"(
float powerHeuristic(float, float) { return 1.0f; }
float solidAnglePdf(const Point&, const LightSample&) { return 1.0f; }
Colour LitScene::tracePathMIS(const Ray& ray, Sampler&) const {
  return Colour(std::sqrt(-2.0f + ray.direction.x));
})");
  expectSaid("LitScene::tracePathMIS (part 8): the radiance (", {"--mis"});
}

}  // namespace
}  // namespace pathmark::test
