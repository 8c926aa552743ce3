#include "scene/read_scene.h"

#include "scene/json_object.h"
#include "scene/json_text.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace pathmark {
namespace {

CameraDescription readCamera(const json& value, const Place& place) {
  const Object object(value, place, "a camera");
  object.allowOnly({"eye", "target", "up", "fieldOfView"});
  CameraDescription camera;
  object.required("eye", camera.eye);
  object.required("target", camera.target);
  object.optional("up", camera.up);
  object.required("fieldOfView", camera.fieldOfView);
  return camera;
}

MaterialDescription readMaterial(const std::string& name, const json& value, const Place& place) {
  static constexpr std::array<std::pair<std::string_view, MaterialKind>, 2> kKinds{
      {{"lambertian", MaterialKind::kLambertian}, {"phong", MaterialKind::kPhong}}};
  MaterialDescription material;
  material.name = name;
  Object(value, place, "a material").requiredChoice("type", kKinds, material.kind);
  if (material.kind == MaterialKind::kLambertian) {
    const Object object(value, place, "a lambertian material");
    object.allowOnly({"type", "Kd"});
    object.required("Kd", material.kd);
  } else {
    const Object object(value, place, "a phong material");
    object.allowOnly({"type", "Kd", "Ks", "exponent"});
    object.required("Kd", material.kd);
    object.required("Ks", material.ks);
    object.required("exponent", material.exponent);
  }
  return material;
}

std::size_t findMaterial(const std::string& name, const Place& place,
                         const std::vector<MaterialDescription>& materials) {
  // Sorted by name, as the library's objects are.
  const auto found = std::lower_bound(
      materials.begin(), materials.end(), name,
      [](const MaterialDescription& m, const std::string& wanted) { return m.name < wanted; });
  if (found == materials.end() || found->name != name) {
    std::vector<std::string_view> names;
    names.reserve(materials.size());
    for (const MaterialDescription& m : materials) names.push_back(m.name);
    place.refuse(fmt::format("found {}, but /materials has no material of this name.{}",
                             inQuotes(name), didYouMean(name, names)));
  }
  return static_cast<std::size_t>(found - materials.begin());
}

std::vector<glm::dvec3> readVertices(const json& value, const Place& place) {
  if (!value.is_array()) {
    place.refuse(describe(value), "this must be an array of points [x, y, z]");
  }
  std::vector<glm::dvec3> vertices;
  vertices.reserve(value.size());
  for (const json& entry : value)
    vertices.push_back(readVector(entry, Place(place, vertices.size())));
  return vertices;
}

TransformDescription readTransform(const json& value, const Place& place) {
  const Object object(value, place, "a transform");
  object.allowOnly({"scale", "rotate", "translate"});
  TransformDescription transform;
  object.optional("scale", [&](const json& v, const Place& p) {
    transform.scale = v.is_number() ? glm::dvec3(readNumber(v, p)) : readVector(v, p);
  });
  object.optional("rotate", [&](const json& v, const Place& p) {
    const Object rotate(v, p, "a rotation");
    rotate.allowOnly({"axis", "angle"});
    rotate.required("axis", transform.axis);
    rotate.required("angle", transform.angle);
  });
  object.optional("translate", transform.translate);
  return transform;
}

constexpr std::array<std::pair<std::string_view, ShapeKind>, 7> kShapeKinds{
    {{"triangle", ShapeKind::kTriangle},
     {"quad", ShapeKind::kQuad},
     {"rectangle", ShapeKind::kRectangle},
     {"polygon", ShapeKind::kPolygon},
     {"sphere", ShapeKind::kSphere},
     {"box", ShapeKind::kBox},
     {"mesh", ShapeKind::kMesh}}};

// What belongs to shapes of one kind only.
void readOwnKeys(const json& value, const Place& place, ShapeDescription& shape) {
  const auto transform = [&](const json& v, const Place& p) {
    shape.transform = readTransform(v, p);
  };
  switch (shape.kind) {
    case ShapeKind::kSphere: {
      const Object sphere(value, place, "a sphere");
      sphere.allowOnly(
          {"type", "name", "material", "emission", "frontOnly", "centre", "radius", "inward"});
      sphere.required("centre", shape.centre);
      sphere.required("radius", shape.radius);
      sphere.optional("inward", shape.inward);
      break;
    }
    case ShapeKind::kBox: {
      const Object box(value, place, "a box");
      box.allowOnly({"type", "name", "material", "emission", "frontOnly", "low", "high",
                     "transform", "inward"});
      box.required("low", shape.low);
      box.required("high", shape.high);
      box.optional("transform", transform);
      box.optional("inward", shape.inward);
      break;
    }
    case ShapeKind::kMesh: {
      const Object mesh(value, place, "a mesh");
      mesh.allowOnly(
          {"type", "name", "material", "emission", "frontOnly", "file", "madeBy", "transform"});
      mesh.required("file", [&](const json& v, const Place& p) { shape.file = readWord(v, p); });
      mesh.optional("madeBy", shape.madeBy);
      mesh.optional("transform", transform);
      break;
    }
    default: {
      const std::string_view name = kShapeKinds[static_cast<std::size_t>(shape.kind)].first;
      const Object flat(value, place, fmt::format("a {}", name));
      flat.allowOnly({"type", "name", "material", "emission", "frontOnly", "vertices"});
      flat.required("vertices",
                    [&](const json& v, const Place& p) { shape.vertices = readVertices(v, p); });
    }
  }
}

ShapeDescription readShape(const json& value, const Place& place,
                           const std::vector<MaterialDescription>& materials) {
  ShapeDescription shape;
  const Object object(value, place, "a shape");
  object.requiredChoice("type", kShapeKinds, shape.kind);
  readOwnKeys(value, place, shape);
  object.required("material", [&](const json& v, const Place& p) {
    shape.material = findMaterial(readWord(v, p), p, materials);
  });
  object.optional("emission", shape.emission);
  object.optional("frontOnly", shape.frontOnly);
  object.optional("name", shape.name);
  return shape;
}

SceneDescription readParts(const json& value, const Place& top) {
  const Object object(value, top, "a scene");
  object.allowOnly({"$schema", "caption", "camera", "size", "maxBounces", "raysPerPixel",
                    "exposure", "materials", "shapes"});
  SceneDescription scene;
  object.optional("$schema", [](const json& v, const Place& p) { readWord(v, p); });
  object.optional("caption", scene.caption);
  object.required("camera",
                  [&](const json& v, const Place& p) { scene.camera = readCamera(v, p); });
  object.optional("size", [&](const json& v, const Place& p) {
    if (!v.is_array() || v.size() != 2) p.refuse(describe(v), "this must be [width, height]");
    for (std::size_t i = 0; i < 2; ++i) scene.size[i] = readNumber(v[i], Place(p, i));
  });
  object.optional("maxBounces", scene.maxBounces);
  object.optional("raysPerPixel", scene.raysPerPixel);
  object.optional("exposure", scene.exposure);
  object.optional("materials", [&](const json& v, const Place& p) {
    if (!v.is_object()) p.refuse(describe(v), "this must be an object of named materials");
    for (const auto& m : v.items()) {
      scene.materials.push_back(readMaterial(m.key(), m.value(), Place(p, m.key())));
    }
  });
  object.required("shapes", [&](const json& v, const Place& p) {
    if (!v.is_array()) p.refuse(describe(v), "this must be an array of shapes");
    for (const json& s : v) {
      scene.shapes.push_back(readShape(s, Place(p, scene.shapes.size()), scene.materials));
    }
  });
  return scene;
}

}  // namespace

SceneDescription readScene(const SceneSource& source) {
  checkSyntax(source);
  const Place top(source);
  const json value = json::parse(source.text.begin(), source.text.end(), nullptr, true, true);
  return readParts(value, top);
}

}  // namespace pathmark
