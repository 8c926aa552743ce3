#include "worker/contract.h"

#include <algorithm>
#include <stdexcept>

namespace pathmark {

namespace {

using F = CourseworkFunction;

constexpr std::array kFunctions{
    FunctionContract{F::kRayTriangleIntersection, 0, "0.1", "ray_triangle_intersection", 15, 2,
                     false},
    FunctionContract{F::kRayMeshIntersection, 0, "0.2", "ray_mesh_intersection", 6, 20, false},
    FunctionContract{F::kGetRandomNumbers, 0, "0.3", "get_random_numbers", 2, 4, false},
    FunctionContract{F::kSampleSphere, 0, "0.4", "sample_sphere", 2, 3, false},
    FunctionContract{F::kSampleHemisphere, 0, "0.5", "sample_hemisphere", 5, 3, false},
    FunctionContract{F::kComputeDirectIllumination, 0, "0.6", "compute_direct_illumination", 6, 5,
                     false},
    FunctionContract{F::kGetRayRadiance, 0, "0.7", "get_ray_radiance", 8, 5, false},
    FunctionContract{F::kStratifiedRandomRay, 1, "1.1", "SimpleCamera::StratifiedRandomRay", 7, 6,
                     false},
    FunctionContract{F::kRenderPixel, 1, "1.2", "LitScene::renderPixel", 5, 3, true},
    FunctionContract{F::kTriangularSampling, 2, "2.1", "Polygon::TriangularSampling", 2, 7, false},
    FunctionContract{F::kRectangularSampling, 2, "2.2", "Polygon::RectangularSampling", 2, 7,
                     false},
    FunctionContract{F::kPolygonSampling, 2, "2.3", "Polygon::PolygonSampling", 2, 7, false},
    FunctionContract{F::kSphereSample, 2, "2.4", "Sphere::sample", 9, 7, false},
    FunctionContract{F::kSpherePdf, 2, "2.5", "Sphere::pdf", 13, 1, false},
    FunctionContract{F::kDirectLighting, 2, "2.6", "LitScene::directLighting", 13, 3, true},
    FunctionContract{F::kLambertianBrdf, 3, "3.1", "lambertianBRDF::brdf", 9, 3, false},
    FunctionContract{F::kLambertianPdf, 3, "3.2", "lambertianBRDF::pdf", 9, 1, false},
    FunctionContract{F::kLambertianReflection, 3, "3.3", "lambertianBRDF::reflection", 9, 4, false},
    FunctionContract{F::kPhongBrdf, 4, "4.1", "phongBRDF::brdf", 9, 3, false},
    FunctionContract{F::kPhongPdf, 4, "4.2", "phongBRDF::pdf", 9, 1, false},
    FunctionContract{F::kPhongReflection, 4, "4.3", "phongBRDF::reflection", 9, 4, false},
    FunctionContract{F::kTracePath, 5, "5.1", "LitScene::tracePath", 8, 3, true},
    FunctionContract{F::kRussianRoulette, 6, "6.1", "LitScene::RussianRoulette", 5, 2, true},
    FunctionContract{F::kPowerHeuristic, 8, "8.1", "powerHeuristic", 2, 1, false},
    FunctionContract{F::kSolidAnglePdf, 8, "8.2", "solidAnglePdf", 10, 1, false},
    FunctionContract{F::kTracePathMis, 8, "8.3", "LitScene::tracePathMIS", 8, 3, true},
    FunctionContract{F::kSphericalTriangleSampling, 9, "9.1", "Polygon::SphericalTriangleSampling",
                     5, 7, false},
    FunctionContract{F::kSphericalTrianglePdf, 9, "9.2", "Polygon::SphericalTrianglePdf", 6, 1,
                     false},
    FunctionContract{F::kSphericalRectangleSampling, 9, "9.3",
                     "Polygon::SphericalRectangleSampling", 5, 7, false},
    FunctionContract{F::kSphericalRectanglePdf, 9, "9.4", "Polygon::SphericalRectanglePdf", 6, 1,
                     false},
};

constexpr bool tableIsInOrder() {
  for (std::size_t i = 0; i < kFunctions.size(); ++i)
    if (static_cast<std::size_t>(kFunctions[i].function) != i) return false;
  return true;
}
static_assert(tableIsInOrder());

constexpr std::array kParts{
    PartContract{0, "part0_warmup.cpp", "Warm-up: a path tracer for a triangle mesh"},
    PartContract{1, "part1_stratified.cpp", "Stratified camera rays"},
    PartContract{2, "part2_lights.cpp", "Area lights and direct light"},
    PartContract{3, "part3_lambertian.cpp", "The Lambertian BRDF"},
    PartContract{4, "part4_phong.cpp", "The modified Phong BRDF"},
    PartContract{5, "part5_path.cpp", "The path tracer"},
    PartContract{6, "part6_roulette.cpp", "Russian roulette"},
    PartContract{8, "part8_mis.cpp", "Multiple importance sampling", true},
    PartContract{9, "part9_solid_angle.cpp", "Lights by the solid angle that they fill", true},
};

}  // namespace

std::span<const FunctionContract> contract() { return kFunctions; }
std::span<const PartContract> parts() { return kParts; }

std::size_t placeOfPart(int number) {
  const auto part = std::find_if(kParts.begin(), kParts.end(),
                                 [number](const PartContract& p) { return p.part == number; });
  if (part == kParts.end()) throw std::out_of_range("no part of functions has this number");
  return static_cast<std::size_t>(part - kParts.begin());
}

}  // namespace pathmark
