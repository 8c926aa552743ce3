// What a filter hands to whoever traces a path: surfaces, their lobes and emission, and lights.
#include "render/path_filter.h"

#include "light_paths/language.h"
#include "support/random_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace pathmark::test {
namespace {

constexpr Float3 kKd{0.3f, 0.2f, 0.1f}, kKs{0.1f, 0.2f, 0.6f};

// Two plates that face each other, the lower one with both lobes, the upper one diffuse; both
// shine.
class FilteredPlates : public testing::Test {
 protected:
  FilteredPlates() {
    plates_.materials.assign(2, {});
    plates_.materials[0] = {FlatMaterialKind::kPhong, kKd, kKs, 10.0f};
    plates_.materials[1] = {FlatMaterialKind::kLambertian, {0.5f, 0.5f, 0.5f}, {}, 0.0f};
    plates_.shapes.assign(2, {});
    plates_.shapes[1].material = 1;
    for (FlatShape& shape : plates_.shapes) shape.emission = {1.0f, 2.0f, 3.0f};
    plates_.addQuad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}, 0);
    plates_.addQuad({-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}, 1);
    core_ = std::make_unique<SceneCore>(plates_.view(), ShadowOrigins::kAnywhere);
    scene_ = std::make_unique<LitScene>(*core_, 8);
  }
  ~FilteredPlates() override { filterPathsOfThisThread(nullptr); }

  void letThrough(const char* expression) {
    filterPathsOfThisThread(nullptr);
    automaton_ = automatonFor(PathExpression(expression));
    filter_ = std::make_unique<PathFilter>(*core_, automaton_, kEye, 7);
    filter_->startPixel(0, 0, 0);
    filterPathsOfThisThread(filter_.get());
  }

  // The surface below, or above, as met from `from`.
  std::optional<Hit> meet(const Point& from, float up) {
    Hit hit;
    if (!scene_->intersect({from, {0, up, 0}}, hit)) return std::nullopt;
    return hit;
  }
  std::optional<Hit> meetFromEye() { return meet(kEye, -1.0f); }
  // On from a surface, and a bit to the side, to the other plate.
  std::optional<Hit> meetFrom(const Hit& hit) {
    Hit next;
    if (!scene_->intersect(hit.spawnRay(normalize(Vector(0.02f, hit.n.y, 0.0f))), next))
      return std::nullopt;
    return next;
  }
  bool lightAt(const Hit& hit) const {
    return scene_->visible(hit, {hit.p + 0.5f * hit.n, -hit.n, 1.0f});
  }
  static bool shines(const Hit& hit) { return hit.emission != Colour(0.0f); }
  static const phongBRDF& phong(const Hit& hit) {
    return dynamic_cast<const phongBRDF&>(*hit.brdf);
  }

  static constexpr Point kEye{0.0f, 0.5f, 0.0f};
  ShapeScene plates_;
  std::unique_ptr<SceneCore> core_;
  std::unique_ptr<LitScene> scene_;
  PathAutomaton automaton_;
  std::unique_ptr<PathFilter> filter_;
};

TEST_F(FilteredPlates, WithoutAFilterAreAsTheyAre) {
  const Hit hit = *meetFromEye();
  EXPECT_EQ(hit.brdf, &core_->material(0));
  EXPECT_TRUE(shines(hit));
  EXPECT_TRUE(lightAt(hit));
}

TEST_F(FilteredPlates, WithAllLightAreAsTheyAre) {
  letThrough("L.*E");
  std::optional<Hit> hit = meetFromEye();
  for (std::size_t k = 0; k < 20; ++k) {
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->brdf, &core_->material(k % 2));
    EXPECT_TRUE(shines(*hit));
    EXPECT_TRUE(lightAt(*hit));
    hit = meetFrom(*hit);
  }
}

TEST_F(FilteredPlates, ShineOnlyWhereTheLightMayBe) {
  letThrough("LD?E");
  const Hit first = *meetFromEye();
  EXPECT_TRUE(shines(first));
  EXPECT_TRUE(lightAt(first));
  const Hit second = *meetFrom(first);
  EXPECT_TRUE(shines(second));
  EXPECT_FALSE(lightAt(second));
  EXPECT_FALSE(meetFrom(second));

  letThrough("LDDE");
  const Hit dark = *meetFromEye();
  EXPECT_FALSE(shines(dark));
  EXPECT_FALSE(lightAt(dark));
  const Hit lit = *meetFrom(dark);
  EXPECT_FALSE(shines(lit));
  EXPECT_TRUE(lightAt(lit));
  // Whoever looks for lights by rays finds them here.
  EXPECT_TRUE(shines(*meetFrom(lit)));
}

TEST_F(FilteredPlates, ReflectByTheOnlyLobeThatIsAskedFor) {
  for (int k = 0; k < 50; ++k) {
    letThrough("LDE");
    const Hit diffuse = *meetFromEye();
    EXPECT_EQ(phong(diffuse).Kd, Colour(0.3f, 0.2f, 0.1f));
    EXPECT_EQ(phong(diffuse).Ks, Colour(0.0f));
    letThrough("L.*SE");
    const Hit specular = *meetFromEye();
    EXPECT_EQ(phong(specular).Kd, Colour(0.0f));
    EXPECT_EQ(phong(specular).Ks, Colour(0.1f, 0.2f, 0.6f));
    EXPECT_EQ(phong(specular).exponent, 10.0f);
  }
}

// Kd and Ks have the means 0.2 and 0.3.
TEST_F(FilteredPlates, ReflectInTheMeanAsTheyAre) {
  letThrough("LDE|LSSE");
  glm::dvec3 kd(0.0), ks(0.0);
  constexpr int kHits = 40000;
  int diffuse = 0;
  for (int k = 0; k < kHits; ++k) {
    const Hit hit = *meetFromEye();
    kd += glm::dvec3(phong(hit).Kd);
    ks += glm::dvec3(phong(hit).Ks);
    const bool isDiffuse = phong(hit).Ks == Colour(0.0f);
    EXPECT_EQ(lightAt(hit), isDiffuse);
    diffuse += isDiffuse ? 1 : 0;
  }
  // Six standard deviations of a binomial count: a false alarm in 5e8.
  constexpr double kShare = 0.4;
  EXPECT_NEAR(diffuse, kHits * kShare, 6.0 * std::sqrt(kHits * kShare * (1.0 - kShare)));
  const double rate = static_cast<double>(diffuse) / kHits;
  for (int c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(c);
    EXPECT_NEAR(kd[c] / kHits, static_cast<double>(kKd[i]) / kShare * rate, 1e-5);
    EXPECT_NEAR(ks[c] / kHits, static_cast<double>(kKs[i]) / (1.0 - kShare) * (1.0 - rate), 1e-5);
  }
}

TEST_F(FilteredPlates, ChooseTheSameLobesAgainForTheSamePixelAndSeed) {
  const auto lobes = [&](int column, std::uint64_t raysBefore) {
    letThrough("LDE|LSSE");
    filter_->startPixel(column, 3, raysBefore);
    std::string text;
    for (int k = 0; k < 64; ++k) text += phong(*meetFromEye()).Ks == Colour(0.0f) ? 'D' : 'S';
    return text;
  };
  EXPECT_EQ(lobes(2, 64), lobes(2, 64));
  EXPECT_NE(lobes(2, 64), lobes(3, 64));
  EXPECT_NE(lobes(2, 64), lobes(2, 128));
}

// A ray goes on from where it starts, in whatever order rays are traced.
TEST_F(FilteredPlates, AreToldApartAlsoByPathsThatBranch) {
  letThrough("LDDE");
  const Hit first = *meetFromEye();
  const Hit a = *meetFrom(first);
  EXPECT_TRUE(meetFrom(a));
  EXPECT_TRUE(meetFrom(a));
  Hit b;
  ASSERT_TRUE(scene_->intersect(first.spawnRay(normalize(Vector(0.3f, 1.0f, 0.2f))), b));
  EXPECT_TRUE(lightAt(b));
  EXPECT_FALSE(lightAt(first));
  EXPECT_TRUE(lightAt(a));
  // A ray from the eye begins anew, and asks for two surfaces again.
  const Hit anew = *meetFromEye();
  EXPECT_FALSE(lightAt(anew));
  EXPECT_TRUE(lightAt(*meetFrom(anew)));
}

TEST_F(FilteredPlates, AreNotEvenMetIfNoPathIsOfTheScene) {
  automaton_ = automatonFor(PathExpression("LS+DE"), {.diffuse = true, .specular = false});
  filter_ = std::make_unique<PathFilter>(*core_, automaton_, kEye, 7);
  filterPathsOfThisThread(filter_.get());
  EXPECT_FALSE(meetFromEye());
}

TEST_F(FilteredPlates, AreNotFilteredInOtherThreads) {
  letThrough("LDDE");
  std::jthread([this] { EXPECT_TRUE(shines(*meetFromEye())); });
}

}  // namespace
}  // namespace pathmark::test
