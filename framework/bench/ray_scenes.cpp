#include "bench/ray_scenes.h"

#include "bench/quick_random.h"
#include "host/session.h"
#include "math/rounding.h"
#include "scene/blob_mesh.h"
#include "scene/load_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pathmark::bench {

namespace {

Float3 toFloat3(const Vector& v) { return {v.x, v.y, v.z}; }
Vector toVector(const Float3& a) { return {a[0], a[1], a[2]}; }

FlatScene withOneShape() {
  FlatScene scene;
  scene.materials.resize(1);
  scene.shapes.resize(1);
  return scene;
}

void addTriangle(FlatScene& scene, const Point& a, const Point& b, const Point& c) {
  scene.addTriangle({toFloat3(a), toFloat3(b), toFloat3(c)},
                    toFloat3(normalize(cross(b - a, c - a))), 0);
}

// A parallelepiped around a centre by its half axes, with twelve triangles that show outwards if
// the axes are right-handed. Ends when the scene has `most` triangles.
void addBox(FlatScene& scene, const Point& centre, const Vector (&axis)[3], std::size_t most) {
  for (int k = 0; k < 3; ++k) {
    for (const float side : {1.0f, -1.0f}) {
      const Point middle = centre + side * axis[k];
      const Vector u = side * axis[(k + 1) % 3], v = axis[(k + 2) % 3];
      if (scene.triangles.size() < most)
        addTriangle(scene, middle - u - v, middle + u - v, middle + u + v);
      if (scene.triangles.size() < most)
        addTriangle(scene, middle - u - v, middle + u + v, middle - u + v);
    }
  }
}

Lamp lampBelow(float ceiling) {
  return {{-0.25f, ceiling, -0.25f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.5f}};
}

RayScene withOffset(FlatScene flat, const Lamp& lamp) {
  float magnitude = 0.0f;
  for (const Float3& v : flat.vertices)
    magnitude = std::max(magnitude, largestComponent(toVector(v)));
  for (const FlatSphere& s : flat.spheres)
    magnitude = std::max(magnitude, largestComponent(toVector(s.centre)) + s.radius);
  return {std::move(flat), lamp, offsetForMagnitude(magnitude), {}};
}

// Points of a cube of this half edge.
Point randomPoint(QuickRandom& random, float halfEdge) {
  const float x = random.next(), y = random.next(), z = random.next();
  return halfEdge * (2.0f * Vector(x, y, z) - 1.0f);
}

}  // namespace

RayScene boxRoom(std::size_t triangles) {
  FlatScene scene = withOneShape();
  addBox(scene, Point(0.0f), {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, triangles);
  const double boxes = std::ceil((static_cast<double>(triangles) - 12.0) / 12.0);
  const float size = 0.4f / std::cbrt(static_cast<float>(std::max(boxes, 1.0)));
  QuickRandom random(triangles);
  while (scene.triangles.size() < triangles) {
    const Point centre = randomPoint(random, 0.95f - size);
    const float angle = 2.0f * kPi * random.next(), c = std::cos(angle), s = std::sin(angle);
    const float x = size * (0.5f + 0.5f * random.next()), y = size * (0.5f + 0.5f * random.next()),
                z = size * (0.5f + 0.5f * random.next());
    addBox(scene, centre, {{x * c, 0, -x * s}, {0, y, 0}, {z * s, 0, z * c}}, triangles);
  }
  return withOffset(std::move(scene), lampBelow(0.99f));
}

RayScene sphereRoom(std::size_t spheres) {
  FlatScene scene = withOneShape();
  scene.spheres.push_back({{0.0f, 0.0f, 0.0f}, 1.0f, 0, 1});
  const float size = 0.3f / std::cbrt(static_cast<float>(spheres));
  QuickRandom random(spheres);
  while (scene.spheres.size() < spheres) {
    const Point centre = randomPoint(random, 0.5f);
    scene.spheres.push_back({toFloat3(centre), size * (0.5f + 0.5f * random.next()), 0, 0});
  }
  return withOffset(std::move(scene), lampBelow(0.9f));
}

RayScene blobOnFloor(int subdivisions) {
  constexpr float kUnit = 1.0f / 256.0f;
  const BlobMesh mesh = makeBlobMesh(subdivisions);
  const Lamp lamp{kUnit * Vector(-100, 399, -100), kUnit * Vector(200, 0, 0),
                  kUnit * Vector(0, 0, 200)};
  FlatScene flat = withOneShape();
  for (const auto& v : mesh.vertices)
    flat.vertices.push_back({kUnit * v[0], kUnit * v[1], kUnit * v[2]});
  for (const auto& t : mesh.triangles) {
    const Point a = toVector(flat.vertices[t[0]]), b = toVector(flat.vertices[t[1]]),
                c = toVector(flat.vertices[t[2]]);
    flat.triangles.push_back({t, 0, toFloat3(normalize(cross(b - a, c - a)))});
  }
  const auto quad = [&](float y, float halfEdge, float up) {
    const Point p[] = {{-halfEdge, y, up * halfEdge},
                       {halfEdge, y, up * halfEdge},
                       {halfEdge, y, -up * halfEdge},
                       {-halfEdge, y, -up * halfEdge}};
    addTriangle(flat, kUnit * p[0], kUnit * p[1], kUnit * p[2]);
    addTriangle(flat, kUnit * p[0], kUnit * p[2], kUnit * p[3]);
  };
  quad(0.0f, 500.0f, 1.0f);
  quad(400.0f, 100.0f, -1.0f);
  return withOffset(std::move(flat), lamp);
}

RayScene cornellBox() {
  FlatScene scene = loadScene(shippedSceneFile("cornell_box")).flat;
  const std::vector<Float3>& light = scene.lightVertices;
  const Point corner = toVector(light.at(0));
  const Lamp lamp{corner, toVector(light.at(1)) - corner, toVector(light.at(3)) - corner};
  return withOffset(std::move(scene), lamp);
}

RayScene asSeen(FlatScene flat) {
  RayScene scene = withOffset(std::move(flat), {});
  scene.camera = scene.flat.camera;
  return scene;
}

}  // namespace pathmark::bench
