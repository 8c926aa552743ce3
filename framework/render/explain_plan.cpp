#include "render/explain_plan.h"

#include "geometry/face_kind.h"
#include "intersect/simd.h"
#include "intersect/triangle_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace pathmark {

namespace {

std::string counted(std::size_t n, const char* one, const char* many) {
  return n == 1 ? fmt::format("1 {}", one) : fmt::format("{} {}", n, many);
}

std::size_t stepsFor(std::size_t primitives) { return (primitives + kLanes - 1) / kLanes; }

std::string lanes() { return fmt::format("this processor's vectors hold {} floats", kLanes); }

// How the flat loop holds the scene's triangles.
std::vector<TrianglePair> pairsOf(const FlatSceneView& scene) {
  std::vector<std::uint32_t> all(scene.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return pairTriangles(scene, all);
}

// "14 pairs and 3 singles"
std::string pairsAndSingles(const std::vector<TrianglePair>& pairs) {
  const auto singles = static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [](const TrianglePair& p) { return p.single; }));
  std::vector<std::string> parts;
  if (singles < pairs.size()) parts.push_back(counted(pairs.size() - singles, "pair", "pairs"));
  if (singles > 0) parts.push_back(counted(singles, "single", "singles"));
  return fmt::format("{}", fmt::join(parts, " and "));
}

PlanLine triangles(const Plan& plan, const FlatSceneView& scene) {
  switch (plan.triangles) {
    case TriangleTest::kFlatLoop: {
      const std::vector<TrianglePair> pairs = pairsOf(scene);
      return {"triangles",
              fmt::format("{} as {}, a flat loop of {}", scene.triangles.size(),
                          pairsAndSingles(pairs), counted(stepsFor(pairs.size()), "step", "steps")),
              fmt::format("{}; from {} pairs and singles on a hierarchy is faster", lanes(),
                          kFewestForHierarchy)};
    }
    case TriangleTest::kHierarchy:
      return {"triangles", fmt::format("{} in Embree's hierarchy", scene.triangles.size()),
              fmt::format("below {} pairs and single triangles a flat loop is faster",
                          kFewestForHierarchy)};
    case TriangleTest::kNone:
      break;
  }
  return {"triangles", "none: no triangle test", ""};
}

PlanLine spheres(const FlatSceneView& scene) {
  const std::size_t count = scene.spheres.size();
  if (count == 0) return {"spheres", "none: no sphere test", ""};
  return {"spheres",
          fmt::format("{}, a flat loop of {}", count, counted(stepsFor(count), "step", "steps")),
          lanes()};
}

PlanLine backs(const FlatSceneView& scene) {
  if (scene.triangles.empty()) return {"backs", "not asked for", "no triangle has one"};
  if (!scene.anyFrontOnly()) return {"backs", "not asked for", "every triangle has both sides"};
  const auto frontOnly = std::count_if(scene.triangles.begin(), scene.triangles.end(),
                                       [&](const FlatTriangle& t) { return scene.frontOnly(t); });
  return {"backs", "culled",
          fmt::format("rays pass through the backs of {} of {} triangles", frontOnly,
                      scene.triangles.size())};
}

// "10 of 32 triangles and 2 of 2 spheres", without a kind that the scene has none of.
std::string shares(const Plan& plan, const FlatSceneView& scene) {
  std::vector<std::string> parts;
  if (plan.triangles == TriangleTest::kHierarchy)
    parts.push_back("the hierarchy of all triangles");
  else if (!scene.triangles.empty())
    parts.push_back(fmt::format("{} of {}", plan.occludingTriangles.size(),
                                counted(scene.triangles.size(), "triangle", "triangles")));
  if (!scene.spheres.empty())
    parts.push_back(fmt::format("{} of {}", plan.occludingSpheres.size(),
                                counted(scene.spheres.size(), "sphere", "spheres")));
  return fmt::format("{}", fmt::join(parts, " and "));
}

PlanLine shadowRays(const Plan& plan, const FlatSceneView& scene) {
  if (scene.lights.empty()) return {"shadow rays", "none", "there is no light"};
  if (scene.maxBounces == 0) return {"shadow rays", "none", "paths end at the first surface"};
  const std::size_t triangles = plan.triangles == TriangleTest::kFlatLoop
                                    ? scene.triangles.size() - plan.occludingTriangles.size()
                                    : 0;
  const std::size_t spheres = scene.spheres.size() - plan.occludingSpheres.size();
  std::vector<std::string> bounding;
  if (triangles > 0) bounding.push_back(counted(triangles, "triangle", "triangles"));
  if (spheres > 0) bounding.push_back(counted(spheres, "sphere", "spheres"));
  const std::string tested = "tested against " + shares(plan, scene);
  if (!bounding.empty())
    return {"shadow rays", tested,
            fmt::format("{} bound{} the scene, and nothing lies beyond",
                        fmt::join(bounding, " and "), triangles + spheres == 1 ? "s" : "")};
  return {"shadow rays", tested,
          plan.triangles == TriangleTest::kHierarchy ? "one hierarchy serves all rays"
                                                     : "each may lie between two surfaces"};
}

// Of the materials that some shape has.
PlanLine materials(const FlatSceneView& scene) {
  std::set<std::uint32_t> used;
  for (const FlatShape& shape : scene.shapes) used.insert(shape.material);
  const auto phong = static_cast<std::size_t>(std::count_if(used.begin(), used.end(), [&](auto m) {
    return scene.materials[m].kind == FlatMaterialKind::kPhong;
  }));
  const std::size_t lambertian = used.size() - phong;
  if (used.empty()) return {"materials", "none", "no shape has one"};
  if (phong == 0)
    return {"materials", fmt::format("{} Lambertian, no Phong", lambertian),
            "no Phong lobe is ever evaluated"};
  return {"materials", fmt::format("{} Lambertian, {} Phong", lambertian, phong), ""};
}

const char* nameOf(FaceKind kind) {
  switch (kind) {
    case FaceKind::kTriangle:
      return "triangle by TriangularSampling";
    case FaceKind::kParallelogram:
      return "parallelogram by RectangularSampling";
    case FaceKind::kPolygon:
      break;
  }
  return "polygon by PolygonSampling";
}

std::string kindOf(const FlatLight& light, const FlatSceneView& scene) {
  if (light.sphere != FlatLight::kNoSphere)
    return scene.spheres[light.sphere].inward != 0 ? "sphere, from inside, by Sphere::sample"
                                                   : "sphere by Sphere::sample";
  const bool bySolidAngle = scene.lightSampling == LightSampling::kBySolidAngle;
  bool rightAngled = false;
  std::set<FaceKind> kinds;
  for (const FlatFace& face : scene.faces.subspan(light.firstFace, light.faceCount)) {
    std::vector<Point> vertices;
    for (const Float3& v : scene.lightVertices.subspan(face.firstVertex, face.vertexCount))
      vertices.emplace_back(v[0], v[1], v[2]);
    const Polygon polygon(vertices, {}, {});
    kinds.insert(faceKind(polygon));
    rightAngled = isRectangle(polygon);
  }
  if (light.faceCount == 1) {
    if (bySolidAngle && *kinds.begin() == FaceKind::kTriangle)
      return "triangle by SphericalTriangleSampling";
    if (bySolidAngle && rightAngled) return "rectangle by SphericalRectangleSampling";
    return nameOf(*kinds.begin());
  }
  std::vector<std::string> names;
  for (const FaceKind kind : kinds) names.emplace_back(nameOf(kind));
  return fmt::format("one of {} faces, chosen by area: {}", light.faceCount,
                     fmt::join(names, " or "));
}

// Equal ones together, in the order in which the kinds first occur.
PlanLine lights(const FlatSceneView& scene) {
  if (scene.lights.empty()) return {"lights", "none", "no shape has an emission"};
  std::vector<std::pair<std::string, std::size_t>> kinds;
  for (const FlatLight& light : scene.lights) {
    const std::string kind = kindOf(light, scene);
    const auto known =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == kind; });
    if (known == kinds.end())
      kinds.emplace_back(kind, 1);
    else
      ++known->second;
  }
  std::vector<std::string> parts;
  for (const auto& [kind, number] : kinds) parts.push_back(fmt::format("{} x {}", number, kind));
  return {"lights", fmt::format("{}", fmt::join(parts, "; ")), ""};
}

PlanLine choiceOfLights(const FlatSceneView& scene) {
  if (scene.lights.empty()) return {"which light", "none", "there is none to choose"};
  if (scene.lights.size() == 1) return {"which light", "the one", ""};
  return {"which light", "as the coursework's directLighting chooses",
          "the solutions: all of few, one of many in proportion to what each can contribute"};
}

PlanLine paths(const FlatSceneView& scene) {
  if (scene.maxBounces == 0)
    return {"paths", "no bounce", "only light that comes straight from a light is asked for"};
  if (scene.maxBounces == 1) return {"paths", "no bounce rays", "only direct light is asked for"};
  return {"paths",
          fmt::format("direct light and at most {}",
                      counted(scene.maxBounces - 1, "bounce", "bounces")),
          "the coursework's roulette may end them earlier"};
}

}  // namespace

std::vector<PlanLine> explainPlan(const Plan& plan, const FlatSceneView& scene) {
  std::vector<PlanLine> lines{triangles(plan, scene),  spheres(scene),   backs(scene),
                              shadowRays(plan, scene), materials(scene), lights(scene),
                              choiceOfLights(scene),   paths(scene)};
  if (plan.cameraRaysTogether)
    lines.insert(lines.begin() + 3, {"camera rays", "those of a pixel in packets",
                                     "they go nearly the same way through a hierarchy"});
  if (scene.triangles.empty() && scene.spheres.empty())
    lines.push_back({"picture", "black", "there is no shape: every ray leaves the scene"});
  else if (scene.lights.empty())
    lines.push_back({"picture", "black", "there is no light to see by"});
  return lines;
}

}  // namespace pathmark
