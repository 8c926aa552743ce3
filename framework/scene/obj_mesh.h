// readObj: the triangles of a Wavefront OBJ file.
//
// Vertices are read in double and shared as in the file; those that no face uses are left out.
// Faces of more than three vertices are cut into triangles. Normals, texture coordinates, groups
// and materials are skipped: a mesh has flat faces and the material that the scene gives it.
#pragma once

#include "scene/source.h"
#include "scene/triangulate.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <vector>

namespace pathmark {

struct Mesh {
  std::vector<glm::dvec3> vertices;
  std::vector<TriangleIndices> triangles;  // counter-clockwise seen from the front
};

// Throws SceneError "file:line: ..." for anything that is not as the format says, a number that is
// none included, and for a file without faces.
Mesh readObj(const SceneSource& source);

// The same of a file, of which only a small part is in memory at a time.
Mesh readObj(const std::filesystem::path& file);

}  // namespace pathmark
