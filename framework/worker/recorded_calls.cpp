// The calls between the framework and the coursework, in a worker that records. The linker's option
// --wrap leads each call of a function in recorded.symbols to what is named "__wrap_" and its name,
// and calls of "__real_" and its name to the function itself. A call of a member function is one
// that is given its object first.
#include "worker/path_recorder.h"

#include <pathmark/lit_scene.h>
#include <pathmark/warmup.h>

namespace pathmark {

// clang-format off
bool intersectItself(const LitScene* scene, const Ray& ray, Hit& hit)
    asm("__real__ZNK8pathmark8LitScene9intersectERKNS_3RayERNS_3HitE");
bool intersectRecorded(const LitScene* scene, const Ray& ray, Hit& hit)
    asm("__wrap__ZNK8pathmark8LitScene9intersectERKNS_3RayERNS_3HitE");

bool visibleItself(const LitScene* scene, const Hit& from, const LightSample& to)
    asm("__real__ZNK8pathmark8LitScene7visibleERKNS_3HitERKNS_11LightSampleE");
bool visibleRecorded(const LitScene* scene, const Hit& from, const LightSample& to)
    asm("__wrap__ZNK8pathmark8LitScene7visibleERKNS_3HitERKNS_11LightSampleE");

LightSample sampleItself(const Light* light, const Point& from, float s, float t)
    asm("__real__ZNK8pathmark5Light6sampleERKN3glm3vecILi3EfLNS1_9qualifierE0EEEff");
LightSample sampleRecorded(const Light* light, const Point& from, float s, float t)
    asm("__wrap__ZNK8pathmark5Light6sampleERKN3glm3vecILi3EfLNS1_9qualifierE0EEEff");

float lightPdfItself(const Light* light, const Point& from, const Hit& at)
    asm("__real__ZNK8pathmark5Light3pdfERKN3glm3vecILi3EfLNS1_9qualifierE0EEERKNS_3HitE");
float lightPdfRecorded(const Light* light, const Point& from, const Hit& at)
    asm("__wrap__ZNK8pathmark5Light3pdfERKN3glm3vecILi3EfLNS1_9qualifierE0EEERKNS_3HitE");

Colour tracePathItself(const LitScene* scene, const Ray& ray, Sampler& sampler)
    asm("__real__ZNK8pathmark8LitScene9tracePathERKNS_3RayERNS_7SamplerE");
Colour tracePathRecorded(const LitScene* scene, const Ray& ray, Sampler& sampler)
    asm("__wrap__ZNK8pathmark8LitScene9tracePathERKNS_3RayERNS_7SamplerE");

Colour tracePathMisItself(const LitScene* scene, const Ray& ray, Sampler& sampler)
    asm("__real__ZNK8pathmark8LitScene12tracePathMISERKNS_3RayERNS_7SamplerE");
Colour tracePathMisRecorded(const LitScene* scene, const Ray& ray, Sampler& sampler)
    asm("__wrap__ZNK8pathmark8LitScene12tracePathMISERKNS_3RayERNS_7SamplerE");

Colour directLightingItself(const LitScene* scene, const Hit& hit, const Vector& wo,
                            Sampler& sampler)
    asm("__real__ZNK8pathmark8LitScene14directLightingERKNS_3HitERKN3glm3vecILi3EfLNS4_9qualifierE0"
        "EEERNS_7SamplerE");
Colour directLightingRecorded(const LitScene* scene, const Hit& hit, const Vector& wo,
                              Sampler& sampler)
    asm("__wrap__ZNK8pathmark8LitScene14directLightingERKNS_3HitERKN3glm3vecILi3EfLNS4_9qualifierE0"
        "EEERNS_7SamplerE");

Roulette rouletteItself(const LitScene* scene, const Colour& throughput, int depth, float u)
    asm("__real__ZNK8pathmark8LitScene15RussianRouletteERKN3glm3vecILi3EfLNS1_9qualifierE0EEEif");
Roulette rouletteRecorded(const LitScene* scene, const Colour& throughput, int depth, float u)
    asm("__wrap__ZNK8pathmark8LitScene15RussianRouletteERKN3glm3vecILi3EfLNS1_9qualifierE0EEEif");

vec3 getRayRadianceItself(vec3 origin, vec3 direction, const Mesh& mesh, uvec2& seed)
    asm("__real__ZN8pathmark16get_ray_radianceEN3glm3vecILi3EfLNS0_9qualifierE0EEES3_RKNS_4MeshERNS1"
        "_ILi2EjLS2_0EEE");
vec3 getRayRadianceRecorded(vec3 origin, vec3 direction, const Mesh& mesh, uvec2& seed)
    asm("__wrap__ZN8pathmark16get_ray_radianceEN3glm3vecILi3EfLNS0_9qualifierE0EEES3_RKNS_4MeshERNS1"
        "_ILi2EjLS2_0EEE");

Ray spawnRayItself(const vec3& point, const Triangle& triangle, const vec3& direction)
    asm("__real__ZN8pathmark9spawn_rayERKN3glm3vecILi3EfLNS0_9qualifierE0EEERKNS_8TriangleES5_");
Ray spawnRayRecorded(const vec3& point, const Triangle& triangle, const vec3& direction)
    asm("__wrap__ZN8pathmark9spawn_rayERKN3glm3vecILi3EfLNS0_9qualifierE0EEERKNS_8TriangleES5_");
// clang-format on

bool intersectRecorded(const LitScene* scene, const Ray& ray, Hit& hit) {
  const bool met = intersectItself(scene, ray, hit);
  if (PathRecorder* recorder = PathRecorder::ofThisThread()) {
    if (met)
      recorder->meet(ray, hit);
    else
      recorder->miss(ray);
  }
  return met;
}

bool visibleRecorded(const LitScene* scene, const Hit& from, const LightSample& to) {
  const bool visible = visibleItself(scene, from, to);
  if (PathRecorder* recorder = PathRecorder::ofThisThread()) recorder->shadowRay(from, to, visible);
  return visible;
}

LightSample sampleRecorded(const Light* light, const Point& from, float s, float t) {
  const LightSample sample = sampleItself(light, from, s, t);
  if (PathRecorder* recorder = PathRecorder::ofThisThread()) {
    PathEvent event = pathEvent(PathEventKind::kLightSample, sample.p, sample.n, light->emission());
    event.x = sample.pdf;
    recorder->add(event);
  }
  return sample;
}

float lightPdfRecorded(const Light* light, const Point& from, const Hit& at) {
  const float pdf = lightPdfItself(light, from, at);
  if (PathRecorder* recorder = PathRecorder::ofThisThread()) {
    PathEvent event = pathEvent(PathEventKind::kLightPdf, from, at.p);
    event.x = pdf;
    recorder->add(event);
  }
  return pdf;
}

Colour tracePathRecorded(const LitScene* scene, const Ray& ray, Sampler& sampler) {
  PathRecorder* recorder = PathRecorder::ofThisThread();
  if (recorder) recorder->beginPath(ray);
  const Colour radiance = tracePathItself(scene, ray, sampler);
  if (recorder) recorder->endPath(radiance);
  return radiance;
}

Colour tracePathMisRecorded(const LitScene* scene, const Ray& ray, Sampler& sampler) {
  PathRecorder* recorder = PathRecorder::ofThisThread();
  if (recorder) recorder->beginPath(ray);
  const Colour radiance = tracePathMisItself(scene, ray, sampler);
  if (recorder) recorder->endPath(radiance);
  return radiance;
}

Colour directLightingRecorded(const LitScene* scene, const Hit& hit, const Vector& wo,
                              Sampler& sampler) {
  PathRecorder* recorder = PathRecorder::ofThisThread();
  if (recorder) recorder->add(pathEvent(PathEventKind::kDirectBegin, hit.p, wo));
  const Colour radiance = directLightingItself(scene, hit, wo, sampler);
  if (recorder) recorder->add(pathEvent(PathEventKind::kDirectEnd, radiance));
  return radiance;
}

Roulette rouletteRecorded(const LitScene* scene, const Colour& throughput, int depth, float u) {
  const Roulette roulette = rouletteItself(scene, throughput, depth, u);
  if (PathRecorder* recorder = PathRecorder::ofThisThread()) {
    PathEvent event = pathEvent(PathEventKind::kRoulette, throughput);
    event.integer = depth;
    event.flag = roulette.survives ? 1 : 0;
    event.x = u;
    event.y = roulette.weight;
    recorder->add(event);
  }
  return roulette;
}

vec3 getRayRadianceRecorded(vec3 origin, vec3 direction, const Mesh& mesh, uvec2& seed) {
  PathRecorder* recorder = PathRecorder::ofThisThread();
  if (recorder) recorder->beginPath({origin, direction});
  const vec3 radiance = getRayRadianceItself(origin, direction, mesh, seed);
  if (recorder) {
    recorder->meetLast({origin, direction});
    recorder->endPath(radiance);
  }
  return radiance;
}

Ray spawnRayRecorded(const vec3& point, const Triangle& triangle, const vec3& direction) {
  const Ray ray = spawnRayItself(point, triangle, direction);
  if (PathRecorder* recorder = PathRecorder::ofThisThread()) recorder->leave(point, triangle, ray);
  return ray;
}

}  // namespace pathmark
