#include "marking/marking_scenes.h"

#include "checks/points.h"
#include "checks/scene_family.h"
#include "host/session.h"
#include "sampling/mix.h"
#include "scene/load_scene.h"

#include <cmath>

namespace pathmark::marking {

namespace {

constexpr int kPixels = 96;  // along each side

// Never brighter than it was, so that Kd + Ks stays below 1.
void darken(Float3& reflectance, checks::Random& random) {
  for (float& channel : reflectance) channel *= static_cast<float>(random.between(0.75, 1.0));
}

void vary(MarkingScene& scene, std::uint64_t seed) {
  checks::Random random(seed);
  FlatScene& flat = scene.flat;
  Colour factor;
  for (int c = 0; c < 3; ++c) factor[c] = static_cast<float>(random.between(0.6, 1.6));
  flat = checks::scaledEmission(std::move(flat), factor);
  scene.exposure *= 3.0 / (double{factor.x} + double{factor.y} + double{factor.z});
  for (FlatMaterial& material : flat.materials) {
    darken(material.kd, random);
    darken(material.ks, random);
    material.exponent *= static_cast<float>(std::exp2(random.between(-0.5, 0.5)));
  }
  FlatCamera& camera = flat.camera;
  const auto right = static_cast<float>(random.between(-4.0, 4.0)),
             down = static_cast<float>(random.between(-4.0, 4.0));
  for (std::size_t axis = 0; axis < 3; ++axis)
    camera.topLeft[axis] += right * camera.pixelRight[axis] + down * camera.pixelDown[axis];
  flat = checks::moved(std::move(flat), mix(seed + kGolden));
}

MarkingScene sceneLike(const std::string& name, std::uint64_t seed,
                       Estimator estimator = Estimator::kPath) {
  const LoadedScene loaded = loadScene(shippedSceneFile(name), {.size = {{kPixels, kPixels}}});
  MarkingScene scene{"a scene like " + name, loaded.flat, estimator, loaded.exposure};
  std::uint64_t hash = mix(seed + kGolden);
  for (const char c : name) hash = mix(hash + static_cast<unsigned char>(c));
  vary(scene, hash);
  return scene;
}

}  // namespace

std::vector<MarkingScene> scenesOfPart(int part, std::uint64_t seed) {
  switch (part) {
    case 0:
      return {sceneLike("cornell_box", seed, Estimator::kWarmUp)};
    case 2: {
      std::vector<MarkingScene> scenes;
      for (const char* name : {"ucl_rectangle", "ucl_triangle", "polygon_light", "ucl_sphere"})
        scenes.push_back(sceneLike(name, seed));
      return scenes;
    }
    case 4:
      return {sceneLike("cornell_phong", seed)};
    case 8:
      return {sceneLike("veach_plates", seed, Estimator::kMis),
              sceneLike("cornell_phong", seed, Estimator::kMis)};
    case 9: {
      std::vector<MarkingScene> scenes{sceneLike("ucl_rectangle", seed),
                                       sceneLike("ucl_triangle", seed)};
      for (MarkingScene& scene : scenes) scene.flat.lightSampling = LightSampling::kBySolidAngle;
      return scenes;
    }
    default:
      return {sceneLike("cornell_box", seed)};
  }
}

std::vector<MarkingScene> scenesOfWhole(std::uint64_t seed) {
  return {sceneLike("cornell_box", seed), sceneLike("cornell_phong", seed)};
}

}  // namespace pathmark::marking
