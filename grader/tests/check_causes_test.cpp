// What pathmark check says of mistakes that many make: found, and not taken for others.
#include "support/coursework_copy.h"
#include "support/run_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWarmUp = "part0_warmup.cpp";
constexpr const char* kStratified = "part1_stratified.cpp";
constexpr const char* kLights = "part2_lights.cpp";
constexpr const char* kLambertian = "part3_lambertian.cpp";
constexpr const char* kPhong = "part4_phong.cpp";
constexpr const char* kPath = "part5_path.cpp";
constexpr const char* kRoulette = "part6_roulette.cpp";
constexpr const char* kMis = "part8_mis.cpp";

class CheckCauses : public ::testing::Test {
 protected:
  // What is said of the solutions with changes, whatever is wrapped put into one line.
  std::string said(const std::string& check) {
    const ProcessResult result =
        run({PATHMARK_PROGRAM, "check", check, "--with", copy_.with()}, fs::path(PATHMARK_ROOT));
    EXPECT_EQ(result.exitCode, 1) << result.output;
    std::string line;
    for (const char c : result.output) {
      const bool isSpace = c == '\n' || c == ' ';
      if (!isSpace || !line.ends_with(' ')) line += isSpace ? ' ' : c;
    }
    return line;
  }

  void expectSaid(const std::string& check, const std::string& words) {
    const std::string all = said(check);
    EXPECT_NE(all.find(words), std::string::npos) << all;
  }

  void expectUnsaid(const std::string& check, const std::string& words) {
    const std::string all = said(check);
    EXPECT_EQ(all.find(words), std::string::npos) << all;
  }

  CourseworkCopy copy_;
};

TEST_F(CheckCauses, DirectLightWithoutBouncesIsFoundInBothPathTracers) {
  copy_.replace(kPath, "if (depth == maxBounces()) break;", "");
  copy_.replace(kPath, "depth + 1 == maxBounces()", "depth + 1 >= maxBounces()");
  copy_.replace(kMis, "if (depth == maxBounces()) break;",
                "if (depth > 0 && depth >= maxBounces()) break;");
  expectSaid("5.1/emission", "hit 1 gets direct light also where no bounce is allowed");
  expectSaid("8.3/emission", "hit 1 gets direct light also where no bounce is allowed");
}

TEST_F(CheckCauses, ANumberOfTheDirectionUsedAgainIsFound) {
  for (const char* again : {"st.x", "st.y"}) {
    SCOPED_TRACE(again);
    const CourseworkCopy before;
    fs::copy_file(before.file(kPath), copy_.file(kPath), fs::copy_options::overwrite_existing);
    copy_.replace(kPath, "st.x, st.y, sampler.next1D())",
                  "st.x, st.y, " + std::string(again) + ")");
    expectSaid("5.1/bounces", "again as u");
  }
}

TEST_F(CheckCauses, TheLastRayOfPart8IsNotToldToEndAsThatOfPart5) {
  copy_.replace(kMis, "    const vec2 st = sampler.next2D();\n    const DirectionSample",
                "    if (depth + 1 == maxBounces()) break;\n"
                "    const vec2 st = sampler.next2D();\n    const DirectionSample");
  expectSaid("8.3/furnace", "the half of that hit's direct light that the next ray finds is lost");
}

TEST_F(CheckCauses, ExchangedDensitiesOfAWeightAreNotTakenForMissingLight) {
  copy_.replace(kMis,
                "powerHeuristic(density, fromBefore.probability(*hit.light) * "
                "solidAnglePdf(before, y))",
                "powerHeuristic(fromBefore.probability(*hit.light) * solidAnglePdf(before, y), "
                "density)");
  expectSaid("8.3/furnace", "has its densities exchanged");
}

TEST_F(CheckCauses, OnlyTheFirstEmissionMayComeOfAThroughputWithoutAFirstValue) {
  copy_.replace(kPath, "throughput(1.0f)", "throughput(0.0f)");
  expectSaid("5.1/furnace", "or the throughput does not begin with 1");
}

TEST_F(CheckCauses, AGeneratorOfOnesOwnIsNotTakenForACopyOfTheSeed) {
  copy_.replace(kWarmUp, "get_random_numbers(uvec2& seed) {",
                "get_random_numbers(uvec2& seed) {\n"
                "  static unsigned calls = 0;\n"
                "  if (++calls > 0) return vec2(float(calls % 97) / 97.0f, float(calls % 89) / "
                "89.0f);\n");
  expectSaid("0.3/seed", "not from another generator");
  expectUnsaid("0.3/seed", "a copy of it");
}

TEST_F(CheckCauses, ARouletteThatIsNotWrittenIsSaidToEndNoPath) {
  copy_.replace(
      kRoulette, "LitScene::RussianRoulette(const Colour& throughput, int depth, float u) const {",
      "LitScene::RussianRoulette(const Colour& throughput, int depth, float u) const {\n"
      "  if (throughput != Colour(0.0f) && depth >= 0 && u >= 0.0f) return {true, 1.0f};");
  expectSaid("6.1/ends", "no path ever ends");
}

TEST_F(CheckCauses, DirectionsInTheLocalFrameAreSaidToBeBelowTheSurface) {
  copy_.replace(kLambertian, "Frame(n).toWorld({onDisc.x, std::sqrt(t), onDisc.y})",
                "{onDisc.x, std::sqrt(t), onDisc.y}");
  expectSaid("3.3/samples", "of the directions are below the surface");
}

TEST_F(CheckCauses, RandomNumbersOfReflectionsOwnAreNamed) {
  copy_.replace(kLambertian, "const vec2 onDisc",
                "static float own = 0.0f;\n  own = own > 0.9f ? 0.0f : own + 0.013f;\n"
                "  s = own;\n  const vec2 onDisc");
  expectSaid("3.3/valid", "without random numbers of its own");
}

TEST_F(CheckCauses, AMeanThatMustVanishIsExpectedToBeZero) {
  copy_.replace(kPhong, "onUnitCircle(s)", "onUnitCircle(u + 0.0f * s)");
  expectSaid("4.3/samples", "component in the plane of incidence = 0 ");
}

TEST_F(CheckCauses, TheEmissionOfTheSurfaceItselfIsNoDirectLight) {
  copy_.replace(kLights, "  return radiance;\n", "  return radiance + hit.emitted(wo);\n");
  expectSaid("2.6/lights", "the emission of the surface itself is added");
}

TEST_F(CheckCauses, AFirstLightThatIsLeftOutIsNamedWithOneLightAndWithSeveral) {
  copy_.replace(kLights, "kFew = 2", "kFew = 64");
  copy_.replace(kLights, "  for (const Light& light : lights())\n    radiance +=",
                "  for (const Light& light : lights().subspan(lights().empty() ? 0 : 1))\n"
                "    radiance +=");
  expectSaid("2.6/rectangle", "or the first light is left out");
  expectSaid("2.6/lights", "likely the first light is left out");
}

TEST_F(CheckCauses, AMeanOverTheLightsMayBeAChoiceWithoutItsProbability) {
  copy_.replace(kLights, "kFew = 2", "kFew = 64");
  copy_.replace(kLights, "  return radiance;\n",
                "  return lights().empty() ? radiance : radiance / float(lights().size());\n");
  expectSaid("2.6/lights",
             "the sum over the lights is divided by their number, or the probability of choosing "
             "one is not divided out");
}

TEST_F(CheckCauses, AFilmPointWithItsAxesSwappedOrAnIntegerDivisionIsNamed) {
  const CourseworkCopy before;
  copy_.replace(kStratified, "x * pixelRight() + y * pixelDown()",
                "y * pixelRight() + x * pixelDown()");
  expectSaid("1.1/film-point", "x and y are swapped");
  fs::copy_file(before.file(kStratified), copy_.file(kStratified),
                fs::copy_options::overwrite_existing);
  copy_.replace(kStratified, "(static_cast<float>(k) + s) / strata",
                "static_cast<float>(k / n) + s / strata");
  expectSaid("1.1/film-point", "likely k / n is divided as integers");
}

TEST_F(CheckCauses, JitterThatIsLeftOutIsNamed) {
  copy_.replace(kStratified, "m / n, n, jitter.x, jitter.y)", "m / n, n, 0.5f, 0.5f)");
  expectSaid("1.2/even", "goes through the middle of its stratum");
}

TEST_F(CheckCauses, TheSineOfARootIsNamedByTheLengthOfTheDirection) {
  copy_.replace(kLambertian, "std::sqrt(1.0f - t) * onUnitCircle(s)",
                "std::sin(std::sqrt(1.0f - t)) * onUnitCircle(s)");
  expectSaid("3.3/valid", "the sine is taken of sqrt(1 - t)");
}

TEST_F(CheckCauses, ASpecularLobeAroundTheNormalIsNotTakenForAnUnusedNumber) {
  copy_.replace(kPhong, "diffuse ? n : normalize(mirror(wo, n))", "n");
  expectSaid("4.3/samples", "the specular lobe is drawn around n");
  expectUnsaid("4.3/samples", "u changes nothing");
}

TEST_F(CheckCauses, ALogarithmNextToNinetyDegreesIsNamed) {
  copy_.replace(kPhong, "if (oneMinusCos >= 1.0f) return 0.0f;",
                "if (dot(a, b) <= 0.0f) return 0.0f;");
  expectSaid("4.3/valid", "NaN: a logarithm or power of a negative number; near 90 degrees");
}

TEST_F(CheckCauses, ASumThatIsKeptMayHaveNoFirstValue) {
  copy_.replace(kStratified, "glm::dvec3 sum(0.0)", "thread_local glm::dvec3 sum(0.0)");
  expectSaid("1.2/again", "or one without a first value");
}

}  // namespace
}  // namespace pathmark::test
