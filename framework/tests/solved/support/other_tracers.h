// Path tracers that are right and go about it in other ways than the solutions' do.
//
//   kDirectLightLast   asks for the direct light of a hit after all that comes further along
//   kBranching         follows two paths from each of the first hits
//   kLightsByChance    has no direct light: its paths find the lights themselves
//   solutionsWith      the solutions with one of them
#pragma once

#include "host/build_config.h"
#include "host/coursework_builder.h"
#include "host/session.h"
#include "support/test_coursework_files.h"
#include "support/test_images.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace pathmark::test {

inline constexpr const char* kDirectLightLast = R"(
static Colour reflected(const LitScene& scene, const Hit& hit, const Vector& wo, Sampler& sampler,
                        int depth) {
  Colour indirect(0.0f);
  if (depth < scene.maxBounces()) {
    const vec2 st = sampler.next2D();
    const DirectionSample next = hit.brdf->reflection(wo, hit.n, st.x, st.y, sampler.next1D());
    Hit nextHit;
    if (next.pdf > 0.0f && scene.intersect(hit.spawnRay(next.wi), nextHit))
      indirect = hit.brdf->brdf(wo, next.wi, hit.n) * (dot(hit.n, next.wi) / next.pdf) *
                 reflected(scene, nextHit, -next.wi, sampler, depth + 1);
  }
  return indirect + scene.directLighting(hit, wo, sampler);
}
Colour LitScene::tracePath(const Ray& ray, Sampler& sampler) const {
  Hit hit;
  if (!intersect(ray, hit)) return Colour(0.0f);
  const Colour back = reflected(*this, hit, -ray.direction, sampler, 1);
  return back + hit.emitted(-ray.direction);
})";

inline constexpr const char* kBranching = R"(
static Colour reflected(const LitScene& scene, const Hit& hit, const Vector& wo, Sampler& sampler,
                        int depth) {
  Colour radiance = scene.directLighting(hit, wo, sampler);
  if (depth == scene.maxBounces()) return radiance;
  const int branches = depth < 3 ? 2 : 1;
  Hit hits[2];
  bool met[2];
  Vector directions[2];
  Colour factors[2];
  for (int k = 0; k < branches; ++k) {
    const vec2 st = sampler.next2D();
    const DirectionSample next = hit.brdf->reflection(wo, hit.n, st.x, st.y, sampler.next1D());
    directions[k] = next.wi;
    met[k] = next.pdf > 0.0f && scene.intersect(hit.spawnRay(next.wi), hits[k]);
    if (met[k])
      factors[k] = hit.brdf->brdf(wo, next.wi, hit.n) *
                   (dot(hit.n, next.wi) / (next.pdf * static_cast<float>(branches)));
  }
  for (int k = 0; k < branches; ++k)
    if (met[k])
      radiance += factors[k] * reflected(scene, hits[k], -directions[k], sampler, depth + 1);
  return radiance;
}
Colour LitScene::tracePath(const Ray& ray, Sampler& sampler) const {
  Hit hit;
  if (!intersect(ray, hit)) return Colour(0.0f);
  return hit.emitted(-ray.direction) + reflected(*this, hit, -ray.direction, sampler, 1);
})";

inline constexpr const char* kLightsByChance = R"(
Colour LitScene::tracePath(const Ray& cameraRay, Sampler& sampler) const {
  Colour radiance(0.0f), throughput(1.0f);
  Ray ray = cameraRay;
  Hit hit;
  for (int depth = 0; intersect(ray, hit); ++depth) {
    const Vector wo = -ray.direction;
    radiance += throughput * hit.emitted(wo);
    if (depth == maxBounces()) break;
    const vec2 st = sampler.next2D();
    const DirectionSample next = hit.brdf->reflection(wo, hit.n, st.x, st.y, sampler.next1D());
    if (next.pdf == 0.0f) break;
    throughput *= hit.brdf->brdf(wo, next.wi, hit.n) * (dot(hit.n, next.wi) / next.pdf);
    ray = hit.spawnRay(next.wi);
  }
  return radiance;
})";

// Compiled in the folder.
inline Coursework solutionsWith(const std::string& tracePath, const std::filesystem::path& folder) {
  const std::filesystem::path project{build::kProjectFolder};
  for (const PartContract& part : parts())
    std::filesystem::copy_file(project / "solutions" / part.file, folder / part.file,
                               std::filesystem::copy_options::overwrite_existing);
  writeText(folder / "part5_path.cpp",
            "#include <pathmark/coursework.h>\nnamespace pathmark {\n" + tracePath + "\n}\n");
  const CourseworkBuild built = buildCoursework(folder);
  EXPECT_FALSE(built.worker.empty()) << built.failure();
  return {"other", built.folder, built.worker};
}

}  // namespace pathmark::test
