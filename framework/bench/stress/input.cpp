// Random numbers at the ends of [0,1), in every combination, for every function of the coursework:
// what comes back is finite, not negative, of unit length where it is a direction, and in range.
//
// The estimators draw their numbers themselves: whole pictures are made with a sampler that gives
// them nothing but such numbers.
#include "bench/stress/stress.h"
#include "bench/stress/words.h"
#include "render/radiance.h"
#include "sampling/corner_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pathmark::bench {

namespace {

using F = CourseworkFunction;

constexpr float kUnit = 1e-5f;  // that a direction's length may be off

bool isFinite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
bool isDirection(const vec3& v) { return isFinite(v) && std::abs(length(v) - 1.0f) < kUnit; }
bool isDensity(float pdf) { return std::isfinite(pdf) && pdf >= 0.0f; }

std::vector<vec2> cornerPairs() {
  std::vector<vec2> pairs;
  for (const float s : kCornerNumbers)
    for (const float t : kCornerNumbers) pairs.emplace_back(s, t);
  return pairs;
}

const std::vector<vec3>& normals() {
  static const std::vector<vec3> all{{0, 1, 0},
                                     {0, -1, 0},
                                     {1, 0, 0},
                                     {-1, 0, 0},
                                     {0, 0, 1},
                                     {0, 0, -1},
                                     normalize(vec3(1, 1, 1)),
                                     normalize(vec3(-1e-4f, 1e-4f, -1)),
                                     normalize(vec3(3, -2, 1))};
  return all;
}

class Input {
 public:
  explicit Input(Stress& stress) : stress_(stress), worker_(stress) {}

  double faults() const { return faults_; }
  StressWorker& worker() { return worker_; }

  // `judge` reads one answer and says whether it is one.
  template <class Judge>
  void ask(F function, const CallWords& object, const CallWords& inputs, Judge judge) {
    const auto words = worker_.call(function, object, inputs);
    AnswerWords answer(words);
    while (!answer.atEnd()) {
      ++calls_;
      if (!judge(answer)) ++wrong_;
    }
  }

  // Ends a function's row.
  void row(F function) { row(std::string(contractOf(function).name)); }
  void row(const std::string& name) {
    stress_.progress.show(name);
    stress_.row({name, calls_, wrong_});
    faults_ += wrong_;
    calls_ = wrong_ = 0.0;
  }

  void count(double calls, double wrong) {
    calls_ += calls;
    wrong_ += wrong;
  }

 private:
  Stress& stress_;
  StressWorker worker_;
  double calls_ = 0.0, wrong_ = 0.0, faults_ = 0.0;
};

CallWords mesh() {
  CallWords words;
  const std::vector<std::array<vec3, 3>> triangles{
      {vec3(-1, -1, 0), vec3(1, -1, 0), vec3(1, 1, 0)},
      {vec3(-1, -1, 0), vec3(1, 1, 0), vec3(-1, 1, 0)},
      {vec3(-1, 1, -1), vec3(1, 1, -1), vec3(0, 1, 1)},
      {vec3(-1, -1, 1), vec3(1, -1, 1), vec3(0, 1, 1)}};
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const auto& [a, b, c] = triangles[k];
    words.add(a, b, c, normalize(cross(b - a, c - a)), vec3(1.0f), vec3(k == 2 ? 3.0f : 0.0f));
  }
  return words;
}

constexpr std::uint32_t kSeedWords[] = {0u,         1u,          0x7fffffu,   0xffffffu,
                                        0x1000000u, 0x80000000u, 0xffffff80u, 0xffffffffu};

void askWarmUp(Input& input) {
  const CallWords none;
  CallWords seeds;
  for (const std::uint32_t x : kSeedWords)
    for (const std::uint32_t y : kSeedWords) seeds.add(x, y);
  for (std::uint32_t k = 0; k < 100000; ++k) seeds.add(k * 2654435761u, k);
  input.ask(F::kGetRandomNumbers, none, seeds, [](AnswerWords& a) {
    const float x = a.number(), y = a.number();
    a.word();
    a.word();
    return x >= 0.0f && x < 1.0f && y >= 0.0f && y < 1.0f;
  });
  input.row(F::kGetRandomNumbers);

  CallWords pairs, pairsAndNormals;
  for (const vec2& u : cornerPairs()) {
    pairs.add(u.x, u.y);
    for (const vec3& n : normals()) pairsAndNormals.add(u.x, u.y, n);
  }
  input.ask(F::kSampleSphere, none, pairs, [](AnswerWords& a) { return isDirection(a.vector()); });
  input.row(F::kSampleSphere);
  std::size_t asked = 0;
  input.ask(F::kSampleHemisphere, none, pairsAndNormals, [&](AnswerWords& a) {
    const vec3 w = a.vector();
    return isDirection(w) && dot(w, normals()[asked++ % normals().size()]) >= -kUnit;
  });
  input.row(F::kSampleHemisphere);
}

// Rays through points of a triangle with such barycentric coordinates: at its edges either answer
// is right, but a hit has a distance, and inside there is one.
void askIntersection(Input& input) {
  CallWords single, several;
  std::vector<float> expected;
  for (const float size : {1e-3f, 1.0f, 1e3f})
    for (const vec2& st : cornerPairs()) {
      const vec3 a(-size, -size, 0), b(size, -size, 0), c(0, size, 0);
      const vec3 target = a + st.x * (b - a) + (1.0f - st.x) * st.y * (c - a);
      const vec3 from = target + size * vec3(0.3f, 0.4f, 2);
      const vec3 direction = normalize(target - from);
      expected.push_back(length(target - from));
      single.add(from, direction, a, b, c);
      if (size == 1.0f) several.add(from, direction);
    }
  std::size_t asked = 0;
  input.ask(F::kRayTriangleIntersection, CallWords(), single, [&](AnswerWords& a) {
    const bool hit = a.word() != 0;
    const float t = a.number(), distance = expected[asked++];
    return !hit || (t > 0.0f && std::abs(t - distance) < 1e-4f * distance);
  });
  input.row(F::kRayTriangleIntersection);
  input.ask(F::kRayMeshIntersection, mesh(), several, [](AnswerWords& a) {
    const bool hit = a.word() != 0;
    const float t = a.number();
    for (int k = 0; k < 18; ++k) a.word();
    return !hit || (t > 0.0f && std::isfinite(t));
  });
  input.row(F::kRayMeshIntersection);
}

void askWarmUpRadiance(Input& input) {
  CallWords direct, rays;
  for (const std::uint32_t x : kSeedWords)
    for (const std::uint32_t y : kSeedWords) {
      for (const vec3& point : {vec3(0, 0, 0), vec3(-1, -1, 0), vec3(1, 1, 0), vec3(0.5f, 0, 0)})
        direct.add(point, 0, x, y);
      for (const vec3& n : normals()) rays.add(vec3(0.25f, 0.25f, 0.5f), n, x, y);
    }
  const auto judge = [](AnswerWords& a) {
    const bool right = isRadiance(a.vector());
    a.word();
    a.word();
    return right;
  };
  input.ask(F::kComputeDirectIllumination, mesh(), direct, judge);
  input.row(F::kComputeDirectIllumination);
  input.ask(F::kGetRayRadiance, mesh(), rays, judge);
  input.row(F::kGetRayRadiance);
}

void askCamera(Input& input) {
  constexpr int kWidth = 640, kHeight = 480;
  const vec3 eye(1, 2, 3), topLeft(-0.4f, 0.3f, -1), right(0.8f / kWidth, 0, 0),
      down(0, -0.6f / kHeight, 0);
  CallWords object, inputs;
  object.add(eye, topLeft, right, down, kWidth, kHeight);
  std::vector<vec2> low, high;
  for (const auto& [i, j] :
       {std::pair{0, 0}, {kWidth - 1, 0}, {0, kHeight - 1}, {kWidth - 1, kHeight - 1}, {313, 217}})
    for (const int n : {1, 2, 8, 1000})
      for (const int k : {0, n / 2, n - 1})
        for (const vec2& st : cornerPairs()) {
          inputs.add(i, j, k, n - 1 - k, n, st.x, st.y);
          const auto fn = static_cast<float>(n);
          low.emplace_back(static_cast<float>(i) + static_cast<float>(k) / fn,
                           static_cast<float>(j) + static_cast<float>(n - 1 - k) / fn);
          high.push_back(low.back() + vec2(1.0f / fn));
        }
  // The film's places are as exact as floats of 640: a few 2^-24 of that.
  constexpr float kRounding = 640.0f * 0x1p-22f;
  std::size_t asked = 0;
  input.ask(F::kStratifiedRandomRay, object, inputs, [&](AnswerWords& a) {
    const vec3 origin = a.vector(), d = a.vector();
    const glm::dvec3 onFilm = glm::dvec3(d) / -static_cast<double>(d.z) - glm::dvec3(topLeft);
    const vec2 place(onFilm.x / static_cast<double>(right.x),
                     onFilm.y / static_cast<double>(down.y));
    const vec2 from = low[asked] - kRounding, to = high[asked] + kRounding;
    ++asked;
    return origin == eye && isDirection(d) && place.x >= from.x && place.y >= from.y &&
           place.x <= to.x && place.y <= to.y;
  });
  input.row(F::kStratifiedRandomRay);
}

void askPolygons(Input& input) {
  const std::vector<vec3> concave{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 3, 0}, {3, 1, 0}, {0, 1, 0}};
  CallWords pairs;
  for (const vec2& u : cornerPairs()) pairs.add(u.x, u.y);
  const auto ask = [&](F function, const std::vector<vec3>& vertices,
                       const std::vector<std::array<int, 3>>& triangles) {
    for (const float scale : {1e-6f, 1.0f, 1e6f})
      for (const vec3& at : {vec3(0.0f), scale * vec3(50, -20, 30)}) {
        CallWords object;
        object.add(static_cast<int>(vertices.size()), static_cast<int>(triangles.size()),
                   vec3(0, 0, 1));
        vec3 low(std::numeric_limits<float>::max()), high(-low);
        for (const vec3& v : vertices) {
          const vec3 moved = at + scale * v;
          object.add(moved);
          low = min(low, moved);
          high = max(high, moved);
        }
        for (const auto& t : triangles) object.add(t[0], t[1], t[2]);
        const float rounding = 0x1p-22f * std::max(length(low), length(high));
        input.ask(function, object, pairs, [&](AnswerWords& a) {
          const LightSample y = a.lightSample();
          bool within = isFinite(y.p);
          for (int c = 0; c < 3; ++c)
            within = within && y.p[c] >= low[c] - rounding && y.p[c] <= high[c] + rounding;
          return within && isDirection(y.n) && isDensity(y.pdf) && y.pdf > 0.0f;
        });
      }
    input.row(function);
  };
  ask(F::kTriangularSampling, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  ask(F::kRectangularSampling, {{0, 0, 0}, {100, 0, 0}, {100, 0.01f, 0}, {0, 0.01f, 0}},
      {{0, 1, 2}, {0, 2, 3}});
  ask(F::kPolygonSampling, concave, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 5}});
}

void askSpheres(Input& input) {
  struct Case {
    vec3 centre;
    float radius;
    vec3 from;
  };
  std::vector<Case> cases;
  for (const float radius : {1e-6f, 1.0f, 1e6f})
    for (const float distance : {0.0f, 1e-3f, 0.5f, 0.999999f, 1.0f, 1.000001f, 1.001f, 2.0f, 1e3f})
      for (const vec3& n : normals())
        for (const vec3& centre : {vec3(0.0f), radius * vec3(3, -4, 5)})
          cases.push_back({centre, radius, centre + distance * radius * n});
  CallWords samples, densities;
  for (const Case& c : cases)
    for (const vec2& st : cornerPairs()) samples.add(c.centre, c.radius, c.from, st.x, st.y);
  std::size_t asked = 0;
  input.ask(F::kSphereSample, CallWords(), samples, [&](AnswerWords& a) {
    const LightSample y = a.lightSample();
    const Case& c = cases[asked++ / cornerPairs().size()];
    if (!isDensity(y.pdf)) return false;
    if (y.pdf == 0.0f) return true;
    densities.add(c.centre, c.radius, c.from, y.p, y.n);
    const float rounding = 0x1p-21f * (length(c.centre) + c.radius);
    return isDirection(y.n) && isFinite(y.p) &&
           length(y.p - (c.centre + c.radius * y.n)) <= rounding + kUnit * c.radius;
  });
  input.row(F::kSphereSample);
  input.ask(F::kSpherePdf, CallWords(), densities,
            [](AnswerWords& a) { return isDensity(a.number()); });
  input.row(F::kSpherePdf);
}

std::vector<vec3> outgoing(const vec3& n) {
  const vec3 across =
      normalize(std::abs(n.x) < 0.6f ? cross(n, vec3(1, 0, 0)) : cross(n, vec3(0, 1, 0)));
  std::vector<vec3> all;
  for (const float cosine : {1.0f, 0.7f, 0.1f, 1e-3f, 1e-6f})
    all.push_back(normalize(cosine * n + std::sqrt((1.0f - cosine) * (1.0f + cosine)) * across));
  return all;
}

void askMaterials(Input& input, const std::vector<CallWords>& objects, F reflection, F pdf,
                  F brdf) {
  struct Question {
    vec3 wo, n;
  };
  std::vector<Question> questions;
  CallWords inputs;
  for (const vec3& n : normals())
    for (const vec3& wo : outgoing(n))
      for (const vec2& st : cornerPairs())
        for (const float u : kCornerNumbers) {
          inputs.add(wo, n, st.x, st.y, u);
          questions.push_back({wo, n});
        }
  std::vector<CallWords> pairs(objects.size());
  std::vector<std::vector<double>> cosineByDensity(objects.size());
  for (std::size_t k = 0; k < objects.size(); ++k) {
    std::size_t asked = 0;
    input.ask(reflection, objects[k], inputs, [&](AnswerWords& a) {
      const vec3 wi = a.vector();
      const float density = a.number();
      const Question& q = questions[asked++];
      if (density == 0.0f) return true;
      pairs[k].add(q.wo, wi, q.n);
      // In double: densities may be denormal numbers, which render threads flush to 0.
      cosineByDensity[k].push_back(static_cast<double>(dot(wi, q.n)) /
                                   static_cast<double>(density));
      return isDirection(wi) && isDensity(density);
    });
  }
  input.row(reflection);
  for (std::size_t k = 0; k < objects.size(); ++k)
    input.ask(pdf, objects[k], pairs[k], [](AnswerWords& a) { return isDensity(a.number()); });
  input.row(pdf);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    std::size_t asked = 0;
    input.ask(brdf, objects[k], pairs[k], [&](AnswerWords& a) {
      const vec3 f = a.vector();
      const double weight = static_cast<double>(f.x) * cosineByDensity[k][asked++];
      return isRadiance(f) && std::isfinite(weight);
    });
  }
  input.row(brdf);
}

void askAllMaterials(Input& input) {
  std::vector<CallWords> lambertian, phong;
  for (const float kd : {0.0f, 0.5f, 1.0f}) lambertian.push_back(CallWords().add(vec3(kd)));
  for (const float exponent : {0.0f, 0.5f, 1.0f, 10.0f, 1e3f, 1e6f})
    for (const auto& [kd, ks] : {std::pair{0.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 0.0f}, {0.5f, 0.5f}})
      phong.push_back(CallWords().add(vec3(kd), vec3(ks), exponent));
  askMaterials(input, lambertian, F::kLambertianReflection, F::kLambertianPdf, F::kLambertianBrdf);
  askMaterials(input, phong, F::kPhongReflection, F::kPhongPdf, F::kPhongBrdf);
}

void askRoulette(Input& input) {
  input.worker().load(loadScene(shippedSceneFile("furnace")).flat);
  CallWords inputs;
  std::vector<float> largest;
  for (const float x : {0.0f, std::numeric_limits<float>::denorm_min(), 1e-30f, 1e-3f, 0.5f, 1.0f})
    for (const vec3& throughput : {vec3(x), vec3(x, 0, 0), vec3(0, 0, x)})
      for (const int depth : {1, 2, 4, 5, 100, 1000})
        for (const float u : kCornerNumbers) {
          inputs.add(throughput, depth, u);
          largest.push_back(x);
        }
  std::size_t asked = 0;
  input.ask(F::kRussianRoulette, CallWords(), inputs, [&](AnswerWords& a) {
    const bool survives = a.word() != 0;
    const float weight = a.number(), x = largest[asked++];
    if (!std::isfinite(weight) || weight < 0.0f) return false;
    return survives ? x > 0.0f && weight >= 1.0f : true;
  });
  input.row(F::kRussianRoulette);
}

// Of bonus part 8: densities of a light and of a BRDF, from none to one of a mirror.
void askHeuristic(Input& input) {
  CallWords inputs;
  for (const float a :
       {0.0f, 0x1p-140f, 1e-30f, 1.0f, 1e30f, std::numeric_limits<float>::infinity()})
    for (const float b :
         {0.0f, 0x1p-140f, 1e-30f, 1.0f, 1e30f, std::numeric_limits<float>::infinity()})
      inputs.add(a, b);
  input.ask(F::kPowerHeuristic, CallWords(), inputs, [](AnswerWords& a) {
    const float weight = a.number();
    return std::isfinite(weight) && weight >= 0.0f && weight <= 1.0f;
  });
  input.row(F::kPowerHeuristic);
}

void renderScenes(Input& input, bool quick, Estimator estimator, LightSampling lights,
                  const std::string& row) {
  for (const std::string& name : shippedSceneNames()) {
    if (name == "blob") continue;  // its functions are those of the others, and its mesh is large
    SceneOverrides overrides;
    overrides.size = {32, 32};
    LoadedScene scene = loadScene(shippedSceneFile(name), overrides);
    scene.flat.lightSampling = lights;
    RenderOptions options;
    options.raysPerPixel = quick ? 64 : 1024;
    options.sampler = SamplerKind::kCorners;
    options.estimator = estimator;
    const RenderSettings settings = settingsFor(scene, options);
    input.worker().load(scene.flat);
    const RenderedImage image = input.worker().render(settings);
    input.count(static_cast<double>(settings.pixels() * options.raysPerPixel),
                static_cast<double>(image.invalid.count()));
  }
  input.row(row);
}

}  // namespace

void stressInput(Stress& stress) {
  stress.begin({.key = "input",
                .title =
                    "Input: s, t, u of 0, a denormal number, 2^-24, 1/2 and 1 - 2^-24 in every "
                    "combination",
                .columns = {{"function", "function"},
                            {"calls", "calls", 0},
                            {"wrong", "answers that are none", 0}},
                .rows = {}});
  Input input(stress);
  askWarmUp(input);
  askIntersection(input);
  askWarmUpRadiance(input);
  askCamera(input);
  askPolygons(input);
  askSpheres(input);
  askAllMaterials(input);
  askRoulette(input);
  askHeuristic(input);
  renderScenes(input, stress.quick, Estimator::kPath, LightSampling::kByArea,
               "renderPixel and what it calls, in pictures");
  renderScenes(input, stress.quick, Estimator::kMis, LightSampling::kBySolidAngle,
               "the same with tracePathMIS, lights by the solid angle");
  stress.addFaults("input", "answers to such numbers that are none", input.faults());
  stress.progress.advance(20.0);
}

}  // namespace pathmark::bench
