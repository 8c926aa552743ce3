#include "worker/call_table.h"

#include "sampling/pcg_sampler.h"

#include <pathmark/coursework.h>

#include <bit>

namespace pathmark {

namespace {

class Words {
 public:
  explicit Words(std::span<const std::uint32_t> words) : words_(words) {}

  std::uint32_t word() { return words_[at_++]; }
  int integer() { return static_cast<int>(word()); }
  float number() { return std::bit_cast<float>(word()); }
  vec2 pair() {
    const float x = number();
    return {x, number()};
  }
  vec3 vector() {
    const float x = number(), y = number();
    return {x, y, number()};
  }
  uvec2 seed2() {
    const std::uint32_t x = word();
    return {x, word()};
  }
  std::uint64_t seed() {
    const std::uint64_t low = word();
    return low | (static_cast<std::uint64_t>(word()) << 32);
  }
  Ray ray() {
    const Point origin = vector();
    return {origin, vector()};
  }
  std::size_t left() const { return words_.size() - at_; }

 private:
  std::span<const std::uint32_t> words_;
  std::size_t at_ = 0;
};

class Output {
 public:
  explicit Output(std::vector<std::uint32_t>& words) : words_(words) {}

  Output& operator<<(std::uint32_t word) { return words_.push_back(word), *this; }
  Output& operator<<(float number) { return *this << std::bit_cast<std::uint32_t>(number); }
  Output& operator<<(bool flag) { return *this << static_cast<std::uint32_t>(flag ? 1 : 0); }
  Output& operator<<(const vec2& v) { return *this << v.x << v.y; }
  Output& operator<<(const uvec2& v) { return *this << v.x << v.y; }
  Output& operator<<(const vec3& v) { return *this << v.x << v.y << v.z; }
  Output& operator<<(const Ray& r) { return *this << r.origin << r.direction; }
  Output& operator<<(const LightSample& s) { return *this << s.p << s.n << s.pdf; }
  Output& operator<<(const DirectionSample& s) { return *this << s.wi << s.pdf; }
  Output& operator<<(const Triangle& t) {
    for (const vec3& p : t.positions) *this << p;
    return *this << t.normal << t.colour << t.emission;
  }

 private:
  std::vector<std::uint32_t>& words_;
};

constexpr std::size_t kTriangleWords = 18;

bool readMesh(Words words, std::vector<Triangle>& triangles) {
  if (words.left() % kTriangleWords != 0) return false;
  while (words.left() > 0) {
    Triangle t;
    for (vec3& p : t.positions) p = words.vector();
    t.normal = words.vector();
    t.colour = words.vector();
    t.emission = words.vector();
    triangles.push_back(t);
  }
  return true;
}

struct PolygonObject {
  std::vector<Point> vertices;
  std::vector<Polygon::TriangleIndices> triangles;
  Vector normal{0.0f};

  bool read(Words words) {
    if (words.left() < 5) return false;
    const std::size_t vertexCount = words.word(), triangleCount = words.word();
    normal = words.vector();
    if (words.left() != 3 * vertexCount + 3 * triangleCount || vertexCount < 3) return false;
    for (std::size_t i = 0; i < vertexCount; ++i) vertices.push_back(words.vector());
    for (std::size_t i = 0; i < triangleCount; ++i) {
      const unsigned a = words.word(), b = words.word(), c = words.word();
      if (a >= vertexCount || b >= vertexCount || c >= vertexCount) return false;
      triangles.push_back({a, b, c});
    }
    return true;
  }
};

using F = CourseworkFunction;

bool isWarmUpWithMesh(F f) {
  return f == F::kRayMeshIntersection || f == F::kComputeDirectIllumination ||
         f == F::kGetRayRadiance;
}

template <class Call>
void forEachCall(const CallBatch& batch, Call call) {
  const std::size_t stride = contractOf(batch.function).inputWords;
  for (std::uint64_t i = 0; i < batch.count; ++i)
    call(Words(batch.inputs.subspan(i * stride, stride)));
}

bool callWarmUp(const CallBatch& batch, Output out) {
  std::vector<Triangle> triangles;
  if (isWarmUpWithMesh(batch.function) && !readMesh(Words(batch.object), triangles)) return false;
  const Mesh mesh{triangles};
  bool valid = true;
  forEachCall(batch, [&](Words in) {
    float t = 0.0f;
    Triangle triangle{};
    switch (batch.function) {
      case F::kRayTriangleIntersection: {
        const Ray ray = in.ray();
        for (vec3& p : triangle.positions) p = in.vector();
        triangle.normal = normalize(cross(triangle.positions[1] - triangle.positions[0],
                                          triangle.positions[2] - triangle.positions[0]));
        const bool hit = ray_triangle_intersection(t, ray, triangle);
        out << hit << t;
        break;
      }
      case F::kRayMeshIntersection: {
        const bool hit = ray_mesh_intersection(t, triangle, in.ray(), mesh);
        out << hit << t << triangle;
        break;
      }
      case F::kGetRandomNumbers: {
        uvec2 seed = in.seed2();
        const vec2 numbers = get_random_numbers(seed);
        out << numbers << seed;
        break;
      }
      case F::kSampleSphere:
        out << sample_sphere(in.pair());
        break;
      case F::kSampleHemisphere: {
        const vec2 u = in.pair();
        out << sample_hemisphere(u, in.vector());
        break;
      }
      case F::kComputeDirectIllumination: {
        const vec3 point = in.vector();
        const std::uint32_t index = in.word();
        uvec2 seed = in.seed2();
        if (index >= triangles.size()) {
          valid = false;
          return;
        }
        const vec3 radiance = compute_direct_illumination(point, triangles[index], mesh, seed);
        out << radiance << seed;
        break;
      }
      default: {
        const Ray ray = in.ray();
        uvec2 seed = in.seed2();
        const vec3 radiance = get_ray_radiance(ray.origin, ray.direction, mesh, seed);
        out << radiance << seed;
      }
    }
  });
  return valid;
}

bool callCamera(const CallBatch& batch, Output out) {
  Words words(batch.object);
  if (words.left() != 14) return false;
  const Point eye = words.vector();
  const Vector topLeft = words.vector(), right = words.vector(), down = words.vector();
  const int width = words.integer();
  const SimpleCamera camera(eye, topLeft, right, down, width, words.integer());
  forEachCall(batch, [&](Words in) {
    const int i = in.integer(), j = in.integer(), k = in.integer(), l = in.integer();
    const int n = in.integer();
    const vec2 st = in.pair();
    out << camera.StratifiedRandomRay(i, j, k, l, n, st.x, st.y);
  });
  return true;
}

bool needsFourVertices(F f) {
  return f == F::kRectangularSampling || f == F::kSphericalRectangleSampling ||
         f == F::kSphericalRectanglePdf;
}

// The functions of part 9, which know the point that is lit.
void callPolygonFrom(const Polygon& polygon, const CallBatch& batch, Output out) {
  forEachCall(batch, [&](Words in) {
    const Point from = in.vector();
    switch (batch.function) {
      case F::kSphericalTriangleSampling: {
        const vec2 st = in.pair();
        out << polygon.SphericalTriangleSampling(from, st.x, st.y);
        break;
      }
      case F::kSphericalRectangleSampling: {
        const vec2 st = in.pair();
        out << polygon.SphericalRectangleSampling(from, st.x, st.y);
        break;
      }
      case F::kSphericalTrianglePdf:
        out << polygon.SphericalTrianglePdf(from, in.vector());
        break;
      default:
        out << polygon.SphericalRectanglePdf(from, in.vector());
    }
  });
}

void callWeights(const CallBatch& batch, Output out) {
  forEachCall(batch, [&](Words in) {
    if (batch.function == F::kPowerHeuristic) {
      const float a = in.number();
      out << powerHeuristic(a, in.number());
      return;
    }
    const Point from = in.vector();
    LightSample y;
    y.p = in.vector();
    y.n = in.vector();
    y.pdf = in.number();
    out << solidAnglePdf(from, y);
  });
}

bool callPolygon(const CallBatch& batch, Output out) {
  PolygonObject object;
  if (!object.read(Words(batch.object))) return false;
  if (needsFourVertices(batch.function) && object.vertices.size() < 4) return false;
  const Polygon polygon(object.vertices, object.triangles, object.normal);
  if (contractOf(batch.function).part == 9) return callPolygonFrom(polygon, batch, out), true;
  forEachCall(batch, [&](Words in) {
    const vec2 st = in.pair();
    out << (batch.function == F::kTriangularSampling    ? polygon.TriangularSampling(st.x, st.y)
            : batch.function == F::kRectangularSampling ? polygon.RectangularSampling(st.x, st.y)
                                                        : polygon.PolygonSampling(st.x, st.y));
  });
  return true;
}

bool callSphere(const CallBatch& batch, Output out) {
  forEachCall(batch, [&](Words in) {
    const Point centre = in.vector();
    const Sphere sphere(centre, in.number());
    const Point from = in.vector();
    if (batch.function == F::kSphereSample) {
      const vec2 st = in.pair();
      out << sphere.sample(from, st.x, st.y);
    } else {
      const Point p = in.vector();
      out << sphere.pdf(from, p, in.vector());
    }
  });
  return true;
}

enum class BrdfCall { kValue, kPdf, kReflection };

void callBrdf(const BRDF& brdf, BrdfCall what, const CallBatch& batch, Output out) {
  forEachCall(batch, [&](Words in) {
    const Vector wo = in.vector(), second = in.vector();
    if (what == BrdfCall::kReflection) {
      const vec2 st = in.pair();
      out << brdf.reflection(wo, second, st.x, st.y, in.number());
    } else if (what == BrdfCall::kPdf) {
      out << brdf.pdf(wo, second, in.vector());
    } else {
      out << brdf.brdf(wo, second, in.vector());
    }
  });
}

BrdfCall brdfCall(F f) {
  if (f == F::kLambertianBrdf || f == F::kPhongBrdf) return BrdfCall::kValue;
  return f == F::kLambertianPdf || f == F::kPhongPdf ? BrdfCall::kPdf : BrdfCall::kReflection;
}

bool callMaterial(const CallBatch& batch, Output out) {
  const bool phong = contractOf(batch.function).part == 4;
  Words words(batch.object);
  if (words.left() != (phong ? 7u : 3u)) return false;
  const Colour kd = words.vector();
  if (!phong) {
    callBrdf(lambertianBRDF(kd), brdfCall(batch.function), batch, out);
    return true;
  }
  const Colour ks = words.vector();
  callBrdf(phongBRDF(kd, ks, words.number()), brdfCall(batch.function), batch, out);
  return true;
}

bool callScene(const CallBatch& batch, const SceneCore& core, Output out) {
  const LitScene scene(core, core.maxBounces());
  bool valid = true;
  forEachCall(batch, [&](Words in) {
    switch (batch.function) {
      case F::kRenderPixel: {
        const int i = in.integer(), j = in.integer(), rays = in.integer();
        PcgSampler sampler(in.seed());
        sampler.startPixel(i, j, 0);
        out << scene.renderPixel(i, j, core.camera(), rays, sampler);
        break;
      }
      case F::kDirectLighting: {
        Hit hit;
        hit.p = in.vector();
        hit.n = in.vector();
        hit.error = in.number();
        const std::uint32_t material = in.word();
        const Vector wo = in.vector();
        PcgSampler sampler(in.seed());
        sampler.startPixel(0, 0, 0);
        if (material >= core.materialCount()) {
          valid = false;
          return;
        }
        hit.brdf = &core.material(material);
        out << scene.directLighting(hit, wo, sampler);
        break;
      }
      case F::kTracePath: {
        const Ray ray = in.ray();
        PcgSampler sampler(in.seed());
        sampler.startPixel(0, 0, 0);
        out << scene.tracePath(ray, sampler);
        break;
      }
      case F::kTracePathMis: {
        const Ray ray = in.ray();
        PcgSampler sampler(in.seed());
        sampler.startPixel(0, 0, 0);
        out << scene.tracePathMIS(ray, sampler);
        break;
      }
      default: {
        const Colour throughput = in.vector();
        const int depth = in.integer();
        const Roulette roulette = scene.RussianRoulette(throughput, depth, in.number());
        out << roulette.survives << roulette.weight;
      }
    }
  });
  return valid;
}

bool dispatch(const CallBatch& batch, const SceneCore* scene, Output out) {
  const FunctionContract& c = contractOf(batch.function);
  if (c.needsScene) return scene != nullptr && callScene(batch, *scene, out);
  switch (c.part) {
    case 0:
      return callWarmUp(batch, out);
    case 1:
      return callCamera(batch, out);
    case 2:
      return batch.function == F::kSphereSample || batch.function == F::kSpherePdf
                 ? callSphere(batch, out)
                 : callPolygon(batch, out);
    case 8:
      return callWeights(batch, out), true;
    case 9:
      return callPolygon(batch, out);
    default:
      return callMaterial(batch, out);
  }
}

}  // namespace

std::vector<std::uint32_t> callCoursework(const CallBatch& batch, const SceneCore* scene) {
  std::vector<std::uint32_t> words;
  words.reserve(batch.count * contractOf(batch.function).outputWords);
  if (!dispatch(batch, scene, Output(words))) words.clear();
  return words;
}

}  // namespace pathmark
