#include "render/scene_core.h"

#include "math/rounding.h"

#include <array>

namespace pathmark {

namespace {

vec3 toVec3(const Float3& a) { return {a[0], a[1], a[2]}; }

std::unique_ptr<BRDF> makeMaterial(const FlatMaterial& m) {
  if (m.kind == FlatMaterialKind::kPhong)
    return std::make_unique<phongBRDF>(toVec3(m.kd), toVec3(m.ks), m.exponent);
  return std::make_unique<lambertianBRDF>(toVec3(m.kd));
}

// Of each face whether it is a light's only one.
std::vector<bool> facesAlone(const FlatSceneView& view) {
  std::vector<bool> alone(view.faces.size(), false);
  for (const FlatLight& light : view.lights)
    if (light.sphere == FlatLight::kNoSphere && light.faceCount == 1) alone[light.firstFace] = true;
  return alone;
}

// Of each light the shape that it is; beyond all shapes where there is none. A sphere says it
// itself. Lights with faces stand in the order of their shapes.
std::vector<std::size_t> shapesOfLights(const FlatSceneView& view) {
  std::vector<bool> hasTriangles(view.shapes.size(), false);
  for (const FlatTriangle& t : view.triangles) hasTriangles[t.shape] = true;
  std::vector<std::size_t> shapes;
  std::size_t next = 0;
  for (const FlatLight& light : view.lights) {
    if (light.sphere != FlatLight::kNoSphere) {
      shapes.push_back(view.spheres[light.sphere].shape);
      continue;
    }
    while (next < view.shapes.size() &&
           !(hasTriangles[next] && view.shapes[next].emission == light.emission))
      ++next;
    shapes.push_back(next);
    if (next < view.shapes.size()) ++next;
  }
  return shapes;
}

}  // namespace

SimpleCamera makeCamera(const FlatCamera& c) {
  return {toVec3(c.eye),       toVec3(c.topLeft),         toVec3(c.pixelRight),
          toVec3(c.pixelDown), static_cast<int>(c.width), static_cast<int>(c.height)};
}

SceneCore::SceneCore(const FlatSceneView& view, ShadowOrigins origins, Skips skips)
    : view_(view),
      camera_(makeCamera(view.camera)),
      maxBounces_(static_cast<int>(view.maxBounces)),
      intersector_(view, planFor(view, origins, skips)) {
  for (const FlatMaterial& m : view.materials) {
    materials_.push_back(makeMaterial(m));
    lobes_.push_back(std::make_unique<MaterialLobes>(m));
  }
  for (const FlatShape& s : view.shapes)
    surfaces_.push_back({materials_[s.material].get(), toVec3(s.emission), nullptr});
  buildLights();
}

void SceneCore::buildLights() {
  for (const Float3& v : view_.lightVertices) lightVertices_.push_back(toVec3(v));
  const std::vector<bool> alone = facesAlone(view_);
  const bool bySolidAngle = view_.lightSampling == LightSampling::kBySolidAngle;
  for (const FlatFace& f : view_.faces) {
    const std::span<const Point> vertices(lightVertices_.data() + f.firstVertex, f.vertexCount);
    faces_.emplace_back(
        Polygon(vertices, view_.lightTriangles.subspan(f.firstTriangle, f.triangleCount),
                toVec3(f.normal)),
        f.cumulativeArea, bySolidAngle && alone[faces_.size()]);
  }
  for (const FlatLight& l : view_.lights) {
    if (l.sphere == FlatLight::kNoSphere) {
      const std::span<const Light::Face> faces =
          std::span(faces_).subspan(l.firstFace, l.faceCount);
      lights_.emplace_back(faces, toVec3(l.emission));
      lightReach_.add(faces);
    } else {
      const FlatSphere& s = view_.spheres[l.sphere];
      const Sphere sphere(toVec3(s.centre), s.radius);
      lights_.emplace_back(sphere, s.inward != 0, view_.shapes[s.shape].frontOnly != 0,
                           toVec3(l.emission));
      lightReach_.add(sphere);
    }
  }
  const std::vector<std::size_t> shapes = shapesOfLights(view_);
  for (std::size_t i = 0; i < lights_.size(); ++i)
    if (shapes[i] < surfaces_.size()) surfaces_[shapes[i]].light = &lights_[i];
}

bool SceneCore::intersect(const Ray& ray, Hit& hit) const {
  PrimitiveHit primitive;
  if (!intersector_.closest(ray, primitive)) return false;
  meet(ray, primitive, hit);
  return true;
}

std::uint32_t SceneCore::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  std::array<PrimitiveHit, kMostInPacket> primitives;
  const std::uint32_t met = intersector_.closest(rays, primitives);
  for (std::size_t i = 0; i < rays.size(); ++i)
    if ((met >> i & 1u) != 0) meet(rays[i], primitives[i], hits[i]);
  return met;
}

void SceneCore::meet(const Ray& ray, const PrimitiveHit& primitive, Hit& hit) const {
  const Surface& surface =
      primitive.isSphere ? meetSphere(ray, primitive, hit) : meetTriangle(ray, primitive, hit);
  hit.brdf = surface.brdf;
  hit.emission = surface.emission;
  hit.light = surface.light;
}

const SceneCore::Surface& SceneCore::meetSphere(const Ray& ray, const PrimitiveHit& primitive,
                                                Hit& hit) const {
  const FlatSphere& sphere = view_.spheres[primitive.index];
  const Point centre = toVec3(sphere.centre);
  const Vector outward = normalize((ray.origin - centre) + primitive.t * ray.direction);
  hit.p = centre + sphere.radius * outward;
  hit.n = sphere.inward != 0 ? -outward : outward;
  hit.error = offsetForMagnitude(largestComponent(centre) + sphere.radius);
  return surfaces_[sphere.shape];
}

// The rounding error of origin + t * direction grows with the distance of the origin. What of it
// leads off the triangle's plane is taken back, so that the error of p that matters to rays that
// start there is that of nearby coordinates.
const SceneCore::Surface& SceneCore::meetTriangle(const Ray& ray, const PrimitiveHit& primitive,
                                                  Hit& hit) const {
  const FlatTriangle& triangle = view_.triangles[primitive.index];
  const Point corner = toVec3(view_.vertices[triangle.vertex[0]]);
  const Vector n = toVec3(triangle.normal);
  const Point p = ray.origin + primitive.t * ray.direction;
  hit.p = p - dot(p - corner, n) * n;
  hit.n = n;
  hit.error = offsetForMagnitude(std::max(largestComponent(hit.p), largestComponent(corner)));
  return surfaces_[triangle.shape];
}

bool SceneCore::visible(const Hit& from, const LightSample& to) const {
  const Vector toLight = to.p - from.p;
  const Ray start = from.spawnRay(toLight);
  const float magnitude = std::max(lightReach_.magnitudeAt(to.p), largestComponent(toLight));
  const Point end = to.p + offsetForMagnitude(magnitude) * to.n;
  return !intersector_.occluded(start.origin, end - start.origin);
}

// Materials are few.
const MaterialLobes& SceneCore::lobesOf(const BRDF& material) const {
  std::size_t i = 0;
  while (materials_[i].get() != &material) ++i;
  return *lobes_[i];
}

std::vector<Triangle> SceneCore::warmUpTriangles() const {
  std::vector<Triangle> triangles;
  triangles.reserve(view_.triangles.size());
  for (const FlatTriangle& t : view_.triangles) {
    const FlatShape& shape = view_.shapes[t.shape];
    const std::array<Float3, 3> corners = view_.corners(t);
    triangles.push_back({{toVec3(corners[0]), toVec3(corners[1]), toVec3(corners[2])},
                         toVec3(t.normal),
                         toVec3(view_.materials[shape.material].kd),
                         toVec3(shape.emission)});
  }
  return triangles;
}

}  // namespace pathmark
