// What a change of a file may change: nothing that it reaches is left out.
#include "variants/reach.h"

#include "host/build_config.h"
#include "support/test_coursework_files.h"
#include "variants/definitions.h"
#include "variants/variant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;
using F = CourseworkFunction;
using Functions = std::vector<F>;

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  return text.replace(text.find(from), from.size(), to);
}

const std::string kFile = R"(// Lights
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

constexpr float kHalf = 0.5f;  // of a "square" {

float half(float x) { return kHalf * x; }

/* } */
float rootOf(float x) {
  if (x > 1'0.0f) { return '}'; }
  return std::sqrt(x);
}

}  // namespace

LightSample Polygon::TriangularSampling(float s, float t) const {
  return {p(0) + half(s) * p(1), normal_, t};
}

LightSample Polygon::RectangularSampling(float s, float t) const {
  return {p(0) + rootOf(s) * p(1), normal_, t};
}

float Sphere::pdf(const Point& from, const Point& p, const Vector& n) const { return 1.0f; }

LightSample Sphere::sample(const Point& from, float s, float t) const {
  return {from, from, pdf(from, from, from)};
}

Colour LitScene::directLighting(const Hit& hit, const Vector& wo, Sampler& sampler) const {
  return Colour(0.0f);
}

}  // namespace pathmark
)";

Functions after(std::string_view from, std::string_view to) {
  return functionsThatMayDiffer(2, kFile, replaced(kFile, from, to));
}

const Functions kAll{F::kTriangularSampling, F::kRectangularSampling, F::kPolygonSampling,
                     F::kSphereSample,       F::kSpherePdf,           F::kDirectLighting};

TEST(Reach, OfAFunctionIsItselfAndWhatTakesAScene) {
  EXPECT_EQ(after("half(s) * p(1)", "half(s) * p(2)"),
            (Functions{F::kTriangularSampling, F::kDirectLighting}));
  EXPECT_EQ(after("Colour(0.0f)", "Colour(1.0f)"), Functions{F::kDirectLighting});
}

TEST(Reach, OfAConstantGoesThroughThoseThatMentionIt) {
  EXPECT_EQ(after("0.5f", "0.25f"), (Functions{F::kTriangularSampling, F::kDirectLighting}));
}

TEST(Reach, OfATwinIncludesTheOther) {
  EXPECT_EQ(after("return 1.0f", "return 2.0f"),
            (Functions{F::kSphereSample, F::kSpherePdf, F::kDirectLighting}));
}

TEST(Reach, OfWordsThatAreNotCodeIsNothing) {
  EXPECT_EQ(after("// Lights", "// Lamps"), Functions{});
  EXPECT_EQ(after("/* } */", "\n"), Functions{});
  EXPECT_EQ(after("x > 1'0.0f", "x   >\n1'0.0f"), Functions{});
}

TEST(Reach, OfWhatHasNoNameIsEverything) {
  EXPECT_EQ(after("namespace {\n", "namespace {\nstruct Cone { float a; };\n"), kAll);
  EXPECT_EQ(after("namespace {\n", "namespace {\n#define x y\n"), kAll);
  EXPECT_EQ(after("namespace {\n", "namespace {\nusing Number = double;\n"), kAll);
  EXPECT_EQ(after("}  // namespace\n", "\n"), kAll) << "braces that do not match";
}

TEST(Reach, OfAFunctionThatIsNewOrGoneIsFound) {
  const std::string other = "float half(double x) { return kHalf * float(x); }\n";
  EXPECT_EQ(after("/* } */", other), (Functions{F::kTriangularSampling, F::kDirectLighting}));
  EXPECT_EQ(functionsThatMayDiffer(2, replaced(kFile, "/* } */", other), kFile),
            (Functions{F::kTriangularSampling, F::kDirectLighting}));
}

TEST(Reach, OfEveryMistakeIncludesTheFunctionThatItIsIn) {
  const fs::path solutions = fs::path(build::kProjectFolder) / "solutions";
  const TemporaryFolder scratch;
  for (const Variant& variant : allVariants()) {
    SCOPED_TRACE(variant.name);
    const fs::path folder = scratch.path() / variant.name;
    applyVariant(variant, folder);
    const Functions reached = functionsThatMayDifferIn(variant.part, solutions, folder);
    EXPECT_FALSE(reached.empty());
    if (!variant.wrong) continue;
    EXPECT_TRUE(std::any_of(reached.begin(), reached.end(),
                            [&](F f) { return contractOf(f).name == variant.function; }));
  }
}

TEST(Definitions, OfTheSolutionsAreAllFound) {
  for (const PartContract& part : parts()) {
    std::ifstream in(fs::path(build::kProjectFolder) / "solutions" / part.file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto definitions = definitionsOf(text);
    ASSERT_TRUE(definitions) << part.file;
    for (const FunctionContract& f : contract()) {
      if (f.part != part.part) continue;
      EXPECT_TRUE(std::any_of(definitions->begin(), definitions->end(), [&](const Definition& d) {
        return d.name == f.name;
      })) << f.name;
    }
  }
}

}  // namespace
}  // namespace pathmark::test
