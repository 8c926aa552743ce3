#include "checks/scene_family.h"

#include "checks/points.h"

#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

constexpr int kPixels = 32;

Colour randomColour(Random& random, double low, double high) {
  const double r = random.between(low, high), g = random.between(low, high);
  return Colour(r, g, random.between(low, high));
}

}  // namespace

FlatScene randomRoom(std::uint64_t seed) {
  Random random(seed);
  const auto matt = [&] { return Surface{.kd = randomColour(random, 0.2, 0.8)}; };
  const Vector x(4, 0, 0), y(0, 3, 0), z(0, 0, 4);
  const Point corner(-2, 0, -2);
  SceneBuilder builder;
  builder.parallelogram(matt(), corner, z, x);
  builder.parallelogram(matt(), corner, x, y);
  builder.parallelogram(matt(), corner, y, z);
  const Point lamp(random.between(-1.2, 0.2), random.between(2.4, 2.8), random.between(-1.2, 0.0));
  builder.parallelogram({.kd = Colour(0.2f), .emission = randomColour(random, 4, 10)}, lamp,
                        {random.between(0.6, 1.0), random.between(-0.1, 0.1), 0},
                        {0, random.between(-0.1, 0.1), random.between(0.6, 1.0)});
  builder.sphere({.kd = Colour(0.3f), .emission = randomColour(random, 6, 12)},
                 {random.between(0.9, 1.4), random.between(1.4, 2.0), random.between(-0.6, 0.4)},
                 static_cast<float>(random.between(0.15, 0.25)));
  const auto ball = [&](double side, const Surface& surface) {
    const auto radius = static_cast<float>(random.between(0.5, 0.7));
    builder.sphere(surface, {side, radius, random.between(-0.8, 0.6)}, radius);
  };
  ball(-0.8, matt());
  ball(0.8, {.kd = randomColour(random, 0.1, 0.4),
             .ks = randomColour(random, 0.2, 0.5),
             .exponent = static_cast<float>(random.between(2.0, 12.0))});
  builder.camera({random.between(-0.5, 1.0), random.between(1.2, 1.8), 6.0}, {0.0f, 1.1f, 0.0f},
                 random.between(0.5, 0.65), kPixels, kPixels);
  return builder.maxBounces(8).flat();
}

double Furnace::radiance(int channel) const {
  const double e = double{emission[channel]}, rho = double{kd[channel]};
  return e * (1.0 - std::pow(rho, scene.maxBounces + 1.0)) / (1.0 - rho);
}

Furnace randomFurnace(std::uint64_t seed) {
  Random random(seed);
  Furnace furnace;
  furnace.emission = randomColour(random, 0.5, 2.0);
  furnace.kd = randomColour(random, 0.1, 0.5);
  const Surface surface{.kd = furnace.kd, .emission = furnace.emission};
  SceneBuilder builder;
  builder.sphere(surface, Point(0), static_cast<float>(random.between(4.0, 5.0)), true);
  // None touches another, or the eye.
  builder.sphere(surface, {-1.2, random.between(-0.5, 0.5), -0.5},
                 static_cast<float>(random.between(0.5, 1.0)));
  builder.sphere(surface, {1.2, random.between(-0.5, 0.5), random.between(-0.8, 0.8)},
                 static_cast<float>(random.between(0.3, 1.0)));
  builder.camera({random.between(-0.5, 0.5), random.between(-0.5, 0.5), 3.2}, Point(0), 0.8,
                 kPixels, kPixels);
  furnace.scene = builder.maxBounces(random.below(4) + 2).flat();
  return furnace;
}

FlatScene scaledEmission(FlatScene scene, const Colour& factor) {
  const auto scale = [&](Float3& emission) {
    for (std::size_t c = 0; c < 3; ++c) emission[c] *= factor[static_cast<int>(c)];
  };
  for (FlatShape& shape : scene.shapes) scale(shape.emission);
  for (FlatLight& light : scene.lights) scale(light.emission);
  return scene;
}

FlatScene withoutLight(FlatScene scene, std::size_t light) {
  const Float3 emission = scene.lights.at(light).emission;
  for (FlatShape& shape : scene.shapes)
    if (shape.emission == emission) shape.emission = Float3{};
  scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(light));
  return scene;
}

FlatScene moved(FlatScene scene, std::uint64_t seed) {
  Random random(seed);
  const DoubleFrame frame(glm::dvec3(random.direction()));
  const double scale = std::exp2(random.between(-1.5, 1.5));
  const glm::dvec3 shift(random.between(-3, 3), random.between(-3, 3), random.between(-3, 3));
  const auto turned = [&](const Float3& v, double factor) {
    const glm::dvec3 w =
        factor * (double{v[0]} * frame.u + double{v[1]} * frame.n + double{v[2]} * -frame.v);
    return w;
  };
  const auto store = [](const glm::dvec3& w) {
    return Float3{static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
  };
  const auto direction = [&](Float3& v) { v = store(glm::normalize(turned(v, 1.0))); };
  const auto vector = [&](Float3& v) { v = store(turned(v, scale)); };
  const auto point = [&](Float3& v) { v = store(turned(v, scale) + shift); };
  for (Float3& v : scene.vertices) point(v);
  for (Float3& v : scene.lightVertices) point(v);
  for (FlatTriangle& triangle : scene.triangles) direction(triangle.normal);
  for (FlatFace& face : scene.faces) direction(face.normal);
  for (FlatSphere& sphere : scene.spheres) {
    point(sphere.centre);
    sphere.radius *= static_cast<float>(scale);
  }
  point(scene.camera.eye);
  vector(scene.camera.topLeft);
  vector(scene.camera.pixelRight);
  vector(scene.camera.pixelDown);
  return scene;
}

}  // namespace pathmark::checks
