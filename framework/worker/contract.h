// The contract as a table: every function that a student writes, with its part, its file, and how
// a call of it is laid out in words of four bytes.
//
//   CourseworkFunction   the functions, in the order of the handouts
//   contract()           their table;  parts(), partNumbered(n)  files and titles of the parts
//   isBonus(f)           whether a function is more than the coursework asks for
//
// A call's words are floats, or integers where noted. Vectors are three words, a seed is two
// (low, high). Words of the `object` are the same for all calls of a request.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace pathmark {

enum class CourseworkFunction : std::uint32_t {
  kRayTriangleIntersection,     // ray 6, corners 9                    -> hit (int), t
  kRayMeshIntersection,         // mesh | ray 6                        -> hit (int), t, triangle 18
  kGetRandomNumbers,            // seed 2 (int)                        -> numbers 2, seed 2 (int)
  kSampleSphere,                // u 2                                 -> direction 3
  kSampleHemisphere,            // u 2, n 3                            -> direction 3
  kComputeDirectIllumination,   // mesh | point 3, triangle (int), seed 2 (int) -> 3, seed 2 (int)
  kGetRayRadiance,              // mesh | ray 6, seed 2 (int)          -> 3, seed 2 (int)
  kStratifiedRandomRay,         // camera 14 | i j k l n (int), s t    -> ray 6
  kRenderPixel,                 // i j rays (int), seed 2              -> 3
  kTriangularSampling,          // polygon | s t                       -> p 3, n 3, pdf
  kRectangularSampling,         // polygon | s t                       -> p 3, n 3, pdf
  kPolygonSampling,             // polygon | s t                       -> p 3, n 3, pdf
  kSphereSample,                // centre 3, radius, from 3, s t       -> p 3, n 3, pdf
  kSpherePdf,                   // centre 3, radius, from 3, p 3, n 3  -> pdf
  kDirectLighting,              // p 3, n 3, error, material (int), wo 3, seed 2 -> 3
  kLambertianBrdf,              // Kd 3 | wo wi n 9                    -> 3
  kLambertianPdf,               // Kd 3 | wo wi n 9                    -> pdf
  kLambertianReflection,        // Kd 3 | wo n 6, s t u                -> wi 3, pdf
  kPhongBrdf,                   // Kd 3, Ks 3, exponent | wo wi n 9    -> 3
  kPhongPdf,                    // Kd 3, Ks 3, exponent | wo wi n 9    -> pdf
  kPhongReflection,             // Kd 3, Ks 3, exponent | wo n 6, s t u -> wi 3, pdf
  kTracePath,                   // ray 6, seed 2                       -> 3
  kRussianRoulette,             // throughput 3, depth (int), u        -> survives (int), weight
  kPowerHeuristic,              // a, b                                -> weight
  kSolidAnglePdf,               // from 3, p 3, n 3, pdf               -> pdf
  kTracePathMis,                // ray 6, seed 2                       -> 3
  kSphericalTriangleSampling,   // polygon | from 3, s t               -> p 3, n 3, pdf
  kSphericalTrianglePdf,        // polygon | from 3, p 3               -> pdf
  kSphericalRectangleSampling,  // polygon | from 3, s t               -> p 3, n 3, pdf
  kSphericalRectanglePdf,       // polygon | from 3, p 3               -> pdf
};

// mesh: 18 words a triangle (corners 9, normal 3, colour 3, emission 3).
// polygon: vertex count (int), triangle count (int), normal 3, vertices 3 each, triangles 3 (int)
// each. camera: eye 3, topLeft 3, pixelRight 3, pixelDown 3, width (int), height (int).

struct FunctionContract {
  CourseworkFunction function;
  int part;
  std::string_view section;  // of the task in the stub; of the part's handout
  std::string_view name;     // as in PATHMARK_UNIMPLEMENTED
  std::uint32_t inputWords;  // of one call
  std::uint32_t outputWords;
  bool needsScene;  // calls a member of LitScene: a scene must have been loaded
};

// A file of functions. Part 7, scenes of one's own, is none.
struct PartContract {
  int part;
  std::string_view file;
  std::string_view title;

  // More than the coursework asks for: the file may be missing, and nothing else depends on it.
  bool bonus = false;
};

std::span<const FunctionContract> contract();
std::span<const PartContract> parts();

// Its place in parts(); there must be a part of functions with this number.
std::size_t placeOfPart(int number);

inline const PartContract& partNumbered(int number) { return parts()[placeOfPart(number)]; }

inline const FunctionContract& contractOf(CourseworkFunction f) {
  return contract()[static_cast<std::size_t>(f)];
}

inline bool isBonus(const FunctionContract& f) { return partNumbered(f.part).bonus; }

}  // namespace pathmark
