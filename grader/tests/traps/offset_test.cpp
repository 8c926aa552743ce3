// Rays that leave a surface: with a fixed epsilon they meet it again in large scenes and step over
// what is near in small ones.
#include "intersect/flat_intersector.h"
#include "tests/support/edge_inputs.h"
#include "tests/support/expect.h"
#include "tests/support/test_scene.h"
#include "tests/support/uniforms.h"
#include "tests/traps/trap.h"

namespace pathmark {
namespace {

using namespace testing;

constexpr float kNaiveEpsilon = 1e-4f;

Ray naiveRay(const Hit& hit, const Vector& wi) { return {hit.p + kNaiveEpsilon * hit.n, wi}; }

// A floor that is askew to the axes, and a lamp or a plate above it.
struct Room {
  Point corner;
  Vector right, back, normal;

  Room(float scale, float shift)
      : corner(scale * shift * Vector(0.61f, -0.77f, 0.43f)),
        right(scale * Vector(2, 0.1f, 0.3f)),
        back(scale * Vector(0.2f, 0.3f, -2)),
        normal(normalize(cross(right, back))) {}

  Point floor(Uniforms& random) const {
    const float x = random.next();
    return corner + (0.1f + 0.8f * x) * right + (0.1f + 0.8f * random.next()) * back;
  }
  // The floor's parallelogram, this far above it, facing down.
  SceneBuilder& addCeiling(SceneBuilder& builder, const Surface& surface, float height) const {
    return builder.parallelogram(surface, corner + height * normal, back, right);
  }
};

const Surface kGrey{.kd = Colour(0.5f)}, kLamp{.emission = Colour(1.0f)};

// A direction above the floor, also close to it.
Vector upwards(const Room& room, Uniforms& random) {
  const glm::dvec3 u = glm::normalize(glm::dvec3(room.right)), n(room.normal);
  const double cosine = std::pow(10.0, random.between(-3.0, 0.0)),
               azimuth = random.between(0.0, 2.0 * kPiD);
  const glm::dvec3 v = glm::cross(n, u);
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return Vector(
      glm::normalize(cosine * n + sine * (std::cos(azimuth) * u + std::sin(azimuth) * v)));
}

// What a ray from above sees of the floor.
bool floorHit(const Room& room, const TestScene& scene, float height, Uniforms& random, Hit& hit) {
  const Point target = room.floor(random);
  const Point from = target + height * upwards(room, random);
  return scene.lit(1).intersect({from, normalize(target - from)}, hit) &&
         dot(hit.n, room.normal) > 0.9f;
}

TEST(Trap, RayOffALargeOrFarSurfaceDoesNotMeetItAgain) {
  for (const auto& [scale, shift] : {std::array{1e4f, 0.0f}, {1e3f, 10.0f}, {1.0f, 1e4f}}) {
    const Room room(scale, shift);
    SceneBuilder builder;
    builder.parallelogram(kGrey, room.corner, room.right, room.back);
    const TestScene scene(builder);
    Uniforms random(1601);
    int rays = 0, naive = 0, shipped = 0;
    for (int i = 0; i < 50000; ++i) {
      Hit hit, again;
      if (!floorHit(room, scene, scale, random, hit)) continue;
      ++rays;
      const Vector wi = upwards(room, random);
      naive += scene.lit(1).intersect(naiveRay(hit, wi), again) ? 1 : 0;
      shipped += scene.lit(1).intersect(hit.spawnRay(wi), again) ? 1 : 0;
    }
    ASSERT_GT(rays, 40000);
    SCOPED_TRACE(::testing::Message() << "scale " << scale << ", shift " << shift);
    expectTrap("share that meets its surface, scale " + std::to_string(scale), double(naive) / rays,
               double(shipped) / rays, 0.0);
  }
}

// The scene is 2e-3 large, and a plate lies over the floor at 2% of that.
TEST(Trap, RayOffASmallSurfaceMeetsWhatIsNear) {
  constexpr float kScale = 1e-3f, kHeight = 4e-5f;
  const Room room(kScale, 0.0f);
  SceneBuilder builder;
  builder.parallelogram(kGrey, room.corner, room.right, room.back);
  room.addCeiling(builder, kGrey, kHeight);
  const TestScene scene(builder);
  Uniforms random(1602);
  int rays = 0, naive = 0, shipped = 0;
  for (int i = 0; i < 10000; ++i) {
    Hit hit, again;
    if (!floorHit(room, scene, 0.5f * kHeight, random, hit)) continue;
    ++rays;
    naive += scene.lit(1).intersect(naiveRay(hit, hit.n), again) ? 0 : 1;
    shipped += scene.lit(1).intersect(hit.spawnRay(hit.n), again) ? 0 : 1;
  }
  ASSERT_GT(rays, 9000);
  expectTrap("share that steps over the plate", double(naive) / rays, double(shipped) / rays, 0.0);
}

TEST(Trap, ShadowRayEndsBeforeItsLight) {
  for (const auto& [scale, shift] : {std::array{1e4f, 0.0f}, {1.0f, 1e4f}}) {
    const Room room(scale, shift);
    SceneBuilder builder;
    builder.parallelogram(kGrey, room.corner, room.right, room.back);
    room.addCeiling(builder, kLamp, scale);
    const TestScene scene(builder);
    const FlatIntersector intersector(viewOf(scene.flat()));
    Uniforms random(1603);
    int rays = 0, naive = 0, shipped = 0;
    for (int i = 0; i < 50000; ++i) {
      Hit hit;
      if (!floorHit(room, scene, 0.5f * scale, random, hit)) continue;
      const float s = random.next();
      const LightSample y = scene.core().lights()[0].sample(hit.p, s, random.next());
      if (dot(normalize(y.p - hit.p), room.normal) < 1e-2f) continue;
      ++rays;
      const Point origin = hit.p + kNaiveEpsilon * hit.n;
      const float distance = length(y.p - origin);
      naive +=
          intersector.occluded(origin, (1.0f - kNaiveEpsilon / distance) * (y.p - origin)) ? 1 : 0;
      shipped += scene.lit(1).visible(hit, y) ? 0 : 1;
    }
    ASSERT_GT(rays, 30000);
    SCOPED_TRACE(::testing::Message() << "scale " << scale << ", shift " << shift);
    expectTrap("share of light that hides itself, scale " + std::to_string(scale),
               double(naive) / rays, double(shipped) / rays, 0.0);
  }
}

// A triangle of length 1 and this height, at random.
std::vector<Point> thinTriangle(double height, Uniforms& random) {
  const auto point = [&] {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    return glm::dvec3(x, y, random.between(-1, 1));
  };
  const glm::dvec3 a = point(), b = point(), c = a + 0.5 * (b - a) + height * point();
  return {Point(a), Point(b), Point(c)};
}

// Moeller & Trumbore.
bool naiveMeets(const Ray& ray, const std::vector<Point>& p) {
  const Vector e1 = p[1] - p[0], e2 = p[2] - p[0], q = cross(ray.direction, e2);
  const float determinant = dot(e1, q);
  if (determinant == 0.0f) return false;
  const Vector s = ray.origin - p[0], r = cross(s, e1);
  const float b1 = dot(s, q) / determinant, b2 = dot(ray.direction, r) / determinant;
  return b1 >= 0.0f && b2 >= 0.0f && b1 + b2 <= 1.0f && dot(e2, r) / determinant > 0.0f;
}

// One triangle, and as many out of sight as it takes for the other intersector.
class ThinTriangle : public ::testing::TestWithParam<int> {
 protected:
  TestScene scene(const std::vector<Point>& triangle) const {
    SceneBuilder builder;
    builder.polygon(kLamp, triangle);
    for (int k = 0; k < GetParam(); ++k)
      builder.parallelogram(kGrey, {50, 50, 50 + float(k)}, {1, 0, 0}, {0, 1, 0});
    return TestScene(builder);
  }
};

TEST_P(ThinTriangle, IsLeftAndLitAsAnyOther) {
  for (const double height : {1e-2, 1e-3, 1e-4, 1e-5}) {
    Uniforms random(1605);
    int left = 0, naive = 0, shipped = 0, lit = 0, hidden = 0;
    for (int k = 0; k < 500; ++k) {
      const std::vector<Point> p = thinTriangle(height, random);
      const TestScene thin = scene(p);
      const LitScene world = thin.lit(1);
      for (int i = 0; i < 50; ++i) {
        const float u = 0.05f + 0.4f * random.next(), v = 0.05f + 0.4f * random.next();
        const Point target = p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]);
        const Point from = target + randomUnit(random);

        // Towards the lamp, which must not hide itself.
        const LightSample y = world.lights()[0].sample(from, random.next(), random.next());
        Hit receiver;
        receiver.p = from;
        receiver.n = normalize(y.p - from);
        if (dot(receiver.n, y.n) < -1e-2f) {
          ++lit;
          hidden += world.visible(receiver, y) ? 0 : 1;
        }

        Hit hit, again;
        if (!world.intersect({from, normalize(target - from)}, hit) || hit.emission.x == 0.0f)
          continue;
        ++left;
        const Ray ray = hit.spawnRay(randomUnit(random));
        naive += naiveMeets(ray, p) ? 1 : 0;
        shipped += world.intersect(ray, again) && again.emission.x > 0.0f ? 1 : 0;
      }
    }
    ASSERT_GT(left, 20000);
    ASSERT_GT(lit, 5000);
    EXPECT_EQ(hidden, 0) << "height " << height;
    expectTrap("share that meets its surface, height " + std::to_string(height),
               double(naive) / left, double(shipped) / left, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Trap, ThinTriangle, ::testing::Values(0, 40));

// The distance of a hit point from its plane, relative to the bound that it comes with. Rays come
// from afar.
TEST(Trap, HitPointIsWithinItsErrorOfThePlane) {
  using LongVector = glm::vec<3, long double, glm::defaultp>;
  const Room room(1.0f, 0.0f);
  SceneBuilder builder;
  builder.polygon(kGrey, {room.corner, room.corner + room.right, room.corner + room.back});
  const TestScene scene(builder);
  const FlatIntersector intersector(viewOf(scene.flat()));
  const LongVector corner(room.corner), right = LongVector(room.corner + room.right) - corner,
                                        back = LongVector(room.corner + room.back) - corner;
  const LongVector n = glm::normalize(glm::cross(right, back));
  Uniforms random(1604);
  for (const float distance : {1e2f, 1e4f}) {
    Errors<Worst> errors;
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
      const Point target = room.floor(random), from = target + distance * upwards(room, random);
      const Ray ray{from, normalize(target - from)};
      PrimitiveHit primitive;
      Hit hit;
      if (!intersector.closest(ray, primitive) || !scene.lit(1).intersect(ray, hit)) continue;
      ++hits;
      const auto off = [&](const Point& p) {
        return double(std::abs(glm::dot(n, LongVector(p) - corner))) / double{hit.error};
      };
      errors.add(off(ray.origin + primitive.t * ray.direction), off(hit.p));
    }
    ASSERT_GT(hits, 5000);
    expectTrap("distance from the plane over its bound, rays of length " + std::to_string(distance),
               errors, 1.0);
  }
}

}  // namespace
}  // namespace pathmark
