#include "render/scene_core.h"

#include "math/rounding.h"

namespace pathmark {

namespace {

vec3 toVec3(const Float3& a) { return {a[0], a[1], a[2]}; }

SimpleCamera makeCamera(const FlatCamera& c) {
  return {toVec3(c.eye),       toVec3(c.topLeft),         toVec3(c.pixelRight),
          toVec3(c.pixelDown), static_cast<int>(c.width), static_cast<int>(c.height)};
}

std::unique_ptr<BRDF> makeMaterial(const FlatMaterial& m) {
  if (m.kind == FlatMaterialKind::kPhong)
    return std::make_unique<phongBRDF>(toVec3(m.kd), toVec3(m.ks), m.exponent);
  return std::make_unique<lambertianBRDF>(toVec3(m.kd));
}

}  // namespace

SceneCore::SceneCore(const FlatSceneView& view)
    : view_(view),
      camera_(makeCamera(view.camera)),
      maxBounces_(static_cast<int>(view.maxBounces)),
      intersector_(view) {
  for (const FlatMaterial& m : view.materials) materials_.push_back(makeMaterial(m));
  buildLights();
}

void SceneCore::buildLights() {
  float magnitude = 0.0f;
  for (const Float3& v : view_.lightVertices) {
    lightVertices_.push_back(toVec3(v));
    magnitude = std::max(magnitude, largestComponent(lightVertices_.back()));
  }
  for (const FlatFace& f : view_.faces) {
    const std::span<const Point> vertices(lightVertices_.data() + f.firstVertex, f.vertexCount);
    faces_.push_back(
        {Polygon(vertices, view_.lightTriangles.subspan(f.firstTriangle, f.triangleCount),
                 toVec3(f.normal)),
         f.cumulativeArea});
  }
  for (const FlatLight& l : view_.lights) {
    if (l.sphere == FlatLight::kNoSphere) {
      lights_.emplace_back(std::span(faces_).subspan(l.firstFace, l.faceCount), toVec3(l.emission));
    } else {
      const FlatSphere& s = view_.spheres[l.sphere];
      const Sphere sphere(toVec3(s.centre), s.radius);
      lights_.emplace_back(sphere, s.inward != 0, toVec3(l.emission));
      magnitude = std::max(magnitude, largestComponent(sphere.centre()) + s.radius);
    }
  }
  lightMagnitude_ = magnitude;
}

bool SceneCore::intersect(const Ray& ray, Hit& hit) const {
  PrimitiveHit primitive;
  if (!intersector_.closest(ray, primitive)) return false;
  const FlatShape* shape = nullptr;
  if (primitive.isSphere) {
    const FlatSphere& sphere = view_.spheres[primitive.index];
    const Point centre = toVec3(sphere.centre);
    const Vector outward = normalize((ray.origin - centre) + primitive.t * ray.direction);
    hit.p = centre + sphere.radius * outward;
    hit.n = sphere.inward != 0 ? -outward : outward;
    hit.error = offsetForMagnitude(largestComponent(centre) + sphere.radius);
    shape = &view_.shapes[sphere.shape];
  } else {
    const FlatTriangle& triangle = view_.triangles[primitive.index];
    const Vector b = primitive.barycentric;
    const std::array<Float3, 3> corners = view_.corners(triangle);
    const Point p0 = b.x * toVec3(corners[0]), p1 = b.y * toVec3(corners[1]),
                p2 = b.z * toVec3(corners[2]);
    hit.p = p0 + p1 + p2;
    hit.n = toVec3(triangle.normal);
    hit.error = offsetForMagnitude(largestComponent(glm::abs(p0) + glm::abs(p1) + glm::abs(p2)));
    shape = &view_.shapes[triangle.shape];
  }
  hit.brdf = materials_[shape->material].get();
  hit.emission = toVec3(shape->emission);
  return true;
}

bool SceneCore::visible(const Hit& from, const LightSample& to) const {
  const Vector toLight = to.p - from.p;
  const Ray start = from.spawnRay(toLight);
  const float magnitude = std::max(lightMagnitude_, largestComponent(toLight));
  const Point end = to.p + offsetForMagnitude(magnitude) * to.n;
  return !intersector_.occluded(start.origin, end - start.origin);
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
