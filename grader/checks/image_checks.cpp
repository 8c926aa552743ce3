// What is asked of the whole coursework: its pictures.
//
// First what must hold bit for bit with the same random numbers, then closed forms and what leaves
// a picture as it is, last the reference pictures of the shipped scenes.
#include "checks/all_checks.h"
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/image_features.h"
#include "checks/image_noise.h"
#include "checks/scene_family.h"
#include "checks/small_render.h"
#include "host/reference.h"
#include "host/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

// The smallest errors of a picture's mean that are found. Those of a furnace have hardly any noise.
constexpr double kDeltaOfFurnace = 0.005, kDeltaOfSum = 0.04, kDeltaOfReference = 0.02;

std::string pixelInWords(const RenderedFilm& film, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(film.width);
  return fmt::format("the pixel in column {} and row {} of {} x {}", pixel % width + 1,
                     pixel / width + 1, film.width, film.height);
}

// Whether the pictures have the same bits, channel c of `b` being factor[c] times that of `a`.
// Fills `finding` if not.
bool sameBits(const RenderedFilm& a, const RenderedFilm& b, const Colour& factor,
              const std::string& where, Finding& finding) {
  for (std::size_t p = 0; p < a.pixels.size(); ++p)
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = double{factor[static_cast<int>(c)]} * a.pixels[p].sum[c];
      if (b.pixels[p].sum[c] == expected) continue;
      finding.status = Status::kFail;
      finding.where = fmt::format("{}, {}", where, pixelInWords(a, p));
      finding.expected = fmt::format("{} = {:.9g}", kChannels[c], expected / a.pixels[p].rays);
      finding.got = fmt::format("{} = {:.9g}", kChannels[c], b.pixels[p].sum[c] / b.pixels[p].rays);
      return false;
    }
  return true;
}

Finding everyPixelIsValid(CheckRun& run) {
  Finding finding;
  for (const char* name : {"cornell_box", "ucl_sphere", "ucl_triangle", "cornell_phong",
                           "polygon_light", "many_lights", "veach_plates"}) {
    SmallRender render(run, loadSmall(name).flat, name);
    for (std::uint64_t k = 0; k < 4 && !render.invalid(); ++k) render.render(k);
    finding.calls += render.rays();
    if (render.invalid()) return *render.invalid();
  }
  return finding;
}

Finding threadsChangeNothing(CheckRun& run) {
  SmallRender render(run, randomRoom(run.seed), "a room made for this check");
  Finding finding;
  for (std::uint64_t k = 0; k < 4; ++k) {
    const RenderedFilm one = render.render(k, 1), again = render.render(k, 1),
                       three = render.render(k, 3);
    finding.calls = render.rays();
    if (!sameBits(one, again, Colour(1.0f), "the same picture, made twice by one thread",
                  finding)) {
      finding.cause =
          "something is kept from one call to the next: a static or global variable, or random "
          "numbers that are not the sampler's";
      break;
    }
    if (!sameBits(one, three, Colour(1.0f), "made by three threads instead of one", finding)) {
      finding.cause =
          "threads share a static or global variable, or random numbers are not the sampler's";
      break;
    }
  }
  return finding;
}

Finding twiceTheEmission(CheckRun& run) {
  Finding finding;
  const FlatScene room = randomRoom(run.seed);
  std::vector<RenderedFilm> once;
  SmallRender render(run, room, "a room made for this check");
  for (std::uint64_t k = 0; k < 8; ++k) once.push_back(render.render(k));
  SmallRender brighter(run, scaledEmission(room, Colour(2.0f)), "a room made for this check");
  for (std::uint64_t k = 0; k < 8; ++k)
    if (!sameBits(once[k], brighter.render(k), Colour(2.0f),
                  "a room made for this check, with twice its emission", finding))
      break;
  finding.calls = render.rays() + brighter.rays();
  return finding;
}

// Where all surfaces are grey the colour is the lamp's.
Finding colourIsTheLamps(CheckRun& run) {
  FlatScene room = withoutLight(randomRoom(run.seed), 1);
  for (FlatMaterial& material : room.materials) {
    material.kd.fill(material.kd[0]);
    material.ks.fill(material.ks[0]);
  }
  const Float3 emission{1.0f, 2.0f, 4.0f};
  for (FlatShape& shape : room.shapes)
    if (shape.emission == room.lights[0].emission) shape.emission = emission;
  room.lights[0].emission = emission;
  SmallRender render(run, room, "a grey room");
  Finding finding;
  for (std::uint64_t k = 0; k < 8; ++k) {
    const RenderedFilm film = render.render(k);
    RenderedFilm red = film;  // the red channel in all three
    for (FilmPixel& pixel : red.pixels) std::fill_n(pixel.sum, 3, pixel.sum[0]);
    if (!sameBits(red, film, {emission[0], emission[1], emission[2]},
                  "a grey room whose lamp emits (1, 2, 4)", finding)) {
      finding.cause = "the channels are mixed with each other somewhere";
      break;
    }
  }
  finding.calls = render.rays();
  return finding;
}

Finding blackStaysBlack(CheckRun& run) {
  FlatScene room = randomRoom(run.seed);
  Finding finding;
  std::vector<RenderedFilm> first;
  for (const float exponent : {1.0f, 300.0f}) {
    room.materials.back() = {FlatMaterialKind::kPhong, {}, {}, exponent};
    SmallRender render(run, room, "a room with a black ball");
    for (std::uint64_t k = 0; k < 4 && finding.passed(); ++k) {
      const RenderedFilm film = render.render(k);
      if (first.size() < 4)
        first.push_back(film);
      else
        sameBits(first[k], film, Colour(1.0f),
                 "a room with a Phong ball of Kd = Ks = 0, its exponent 300 instead of 1", finding);
      if (render.invalid()) return *render.invalid();
    }
    finding.calls += render.rays();
  }
  return finding;
}

Finding furnacesAreEven(CheckRun& run) {
  const Furnace furnace = randomFurnace(run.seed);
  SmallRender render(run, furnace.scene, "a furnace made for this check", 2);
  PlainImage even{render.width(), render.height(), {}};
  for (int p = 0; p < even.width * even.height; ++p)
    for (int c = 0; c < 3; ++c) even.rgb.push_back(furnace.radiance(c));
  const ImageFeatures features(even);
  const FeatureTarget target{features.of(even), {}, kDeltaOfFurnace};
  Finding finding = judgeFeatures(
      run, features, target, render.replicatesOf(features),
      fmt::format("a furnace of {} spheres: all emit {} and have Kd = {}, maxBounces = {}",
                  furnace.scene.spheres.size(), text(furnace.emission), text(furnace.kd),
                  furnace.scene.maxBounces));
  if (render.invalid()) return *render.invalid();
  finding.calls = render.rays();
  return finding;
}

// `factors`: of the scenes' features in a sum that must be 0. Their pictures do not share random
// numbers.
Finding judgeSum(CheckRun& run, const std::vector<FlatScene>& scenes,
                 const std::vector<double>& factors, const std::string& where) {
  constexpr std::uint64_t kPilots = 64, kRays = 2;
  const char* name = "a room made for this check";
  SmallRender pilot(run, scenes[0], name, kRays);
  const ImageFeatures features(pilot.mean(0, kPilots));
  const FeatureTarget target{std::vector<double>(features.count(), 0.0), {}, kDeltaOfSum};
  std::optional<Finding> invalid = pilot.invalid();
  std::uint64_t rays = pilot.rays(), next = kPilots;
  const auto sums = [&](std::uint64_t, std::uint64_t count) {
    std::vector<std::vector<double>> all(count, target.expected);
    for (std::size_t s = 0; s < scenes.size() && !invalid; ++s) {
      SmallRender render(run, scenes[s], name, kRays);
      const auto replicates = render.replicates(features, next, count);
      next += count;
      rays += render.rays();
      invalid = render.invalid();
      for (std::size_t r = 0; r < replicates.size(); ++r)
        for (std::size_t k = 0; k < features.count(); ++k)
          all[r][k] += factors[s] * replicates[r][k];
    }
    return all;
  };
  Finding finding = judgeFeatures(run, features, target, sums, where);
  if (invalid) return *invalid;
  finding.calls = rays;
  return finding;
}

Finding movedSceneIsTheSame(CheckRun& run) {
  const FlatScene room = randomRoom(run.seed);
  return judgeSum(run, {room, moved(room, run.seed)}, {1.0, -1.0},
                  "a room, minus the same room turned, scaled and shifted with its camera");
}

Finding lightsAdd(CheckRun& run) {
  const FlatScene room = randomRoom(run.seed);
  return judgeSum(run, {room, withoutLight(room, 0), withoutLight(room, 1)}, {1.0, -1.0, -1.0},
                  "a room with two lamps, minus the same room with either lamp");
}

// The reference's pixels, brought to the small picture's.
struct SmallReference {
  PlainImage image, variances;
};

SmallReference shrunk(const Image& image, int factor) {
  const int width = image.width / factor, height = image.height / factor;
  const auto size = static_cast<std::size_t>(3 * width * height);
  SmallReference result{{width, height, std::vector<double>(size)},
                        {width, height, std::vector<double>(size)}};
  const double share = 1.0 / (factor * factor);
  for (int j = 0; j < image.height; ++j)
    for (int i = 0; i < image.width; ++i)
      for (int c = 0; c < 3; ++c) {
        const auto from = static_cast<std::size_t>(3 * (j * image.width + i) + c),
                   to = static_cast<std::size_t>(3 * (j / factor * width + i / factor) + c);
        result.image.rgb[to] += share * double{image.rgb[from]};
        if (!image.variance.empty())
          result.variances.rgb[to] += share * share * double{image.variance[from]};
      }
  return result;
}

Finding likeItsReference(CheckRun& run, const std::string& name, double delta = kDeltaOfReference) {
  const std::optional<ImageFile> file = readReference(loadScene(shippedSceneFile(name)));
  Finding finding;
  if (!file) {
    finding.status = Status::kBlocked;
    finding.cause = fmt::format("a reference image that is missing: ./pathmark reference {}", name);
    return finding;
  }
  const SmallScene small = loadSmall(name);
  SmallRender render(run, small.flat, name, 8);
  const SmallReference reference = shrunk(file->image, small.shrink);
  const ImageFeatures features(reference.image);
  const FeatureTarget target{features.of(reference.image), features.errors(reference.variances),
                             delta};
  finding = judgeFeatures(run, features, target, render.replicatesOf(features),
                          fmt::format("{} in {} x {} pixels, against scenes/references/{}.exr",
                                      name, render.width(), render.height(), name));
  if (render.invalid()) return *render.invalid();
  finding.calls = render.rays();
  return finding;
}

Finding cornellBox(CheckRun& run) { return likeItsReference(run, "cornell_box"); }
Finding cornellPhong(CheckRun& run) { return likeItsReference(run, "cornell_phong"); }
Finding uclSphere(CheckRun& run) { return likeItsReference(run, "ucl_sphere"); }
Finding polygonLight(CheckRun& run) {
  return likeItsReference(run, "polygon_light", 4.0 * kDeltaOfReference);
}

Check picture(std::string_view name, std::string_view statement, double delta,
              Finding (*test)(CheckRun&)) {
  return {name, F::kRenderPixel, statement, delta, test, {}, true};
}

}  // namespace

std::span<const Check> imageChecks() {
  static const std::vector<Check> kChecks{
      picture("valid", "every pixel of the shipped scenes is finite and not negative", 0.0,
              everyPixelIsValid),
      picture("repeatable", "the same seed makes the same picture, with any number of threads", 0.0,
              threadsChangeNothing),
      picture("twice-the-emission",
              "twice the emission makes a picture twice as bright, bit for bit", 0.0,
              twiceTheEmission),
      picture("colour", "where all surfaces are grey, every pixel has the colour of the lamp", 0.0,
              colourIsTheLamps),
      picture("black", "of a black material the other parameters change nothing", 0.0,
              blackStaysBlack),
      picture("furnace", "a furnace is equally bright everywhere, and as bright as its series says",
              kDeltaOfFurnace, furnacesAreEven),
      picture("moved", "a scene that is turned, scaled and shifted gives the same picture",
              kDeltaOfSum, movedSceneIsTheSame),
      picture("two-lamps", "two lamps give the sum of what each of them gives", kDeltaOfSum,
              lightsAdd),
      picture("cornell_box", "cornell_box is like its reference", kDeltaOfReference, cornellBox),
      picture("ucl_sphere", "ucl_sphere is like its reference", kDeltaOfReference, uclSphere),
      picture("polygon_light", "polygon_light is like its reference", 4.0 * kDeltaOfReference,
              polygonLight),
      picture("cornell_phong", "cornell_phong is like its reference", kDeltaOfReference,
              cornellPhong),
      picture("noise", "how much noise is left is not judged, but said", 0.0,
              noiseIsThatOfTheReference),
  };
  return kChecks;
}

}  // namespace pathmark::checks
