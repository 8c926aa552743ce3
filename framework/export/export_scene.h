// Scenes for other renderers.
//
//   ExportedFile     a file to write
//   requireFloats    whether the other renderers' numbers can hold the scene
//   farthestSurface  how far rays must reach
//   exportPbrt       for pbrt-v4
//   exportMitsuba    for Mitsuba 3
//   exportNotes      what the other renderer has no counterpart of, in sentences
//
// Of a path with at most B scattering events pbrt says maxdepth B (its PathIntegrator ends at the
// depth that equals it, the camera ray's hit having depth 0) and Mitsuba max_depth B + 1 (which
// counts the emission that is seen directly as 1).
#pragma once

#include "export/world_scene.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pathmark {

enum class ExportFormat { kPbrt, kMitsuba };

struct ExportedFile {
  std::filesystem::path path;  // relative to the scene file's folder
  std::string content;
};

struct ExportRequest {
  std::string stem;  // of the scene file and the image that the other renderer writes
  std::uint64_t raysPerPixel = 64;
  std::string command{};  // that renders the scene file, to be told at its top; on one line
};

// Throws SceneError for lengths and a field of view that are no floats of use.
void requireFloats(const WorldScene& scene);

// The distance from the eye.
double farthestSurface(const WorldScene& scene);

// The scene file first, then its meshes in the folder STEM_meshes.
std::vector<ExportedFile> exportPbrt(const WorldScene& scene, const ExportRequest& request);
std::vector<ExportedFile> exportMitsuba(const WorldScene& scene, const ExportRequest& request);

std::vector<std::string> exportNotes(const WorldScene& scene, ExportFormat format);

// Binary, little endian, floats.
std::string plyText(const WorldMesh& mesh);

}  // namespace pathmark
