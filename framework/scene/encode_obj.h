// encodeObj: triangles as the text of a Wavefront OBJ file.
#pragma once

#include "scene/blob_mesh.h"

#include <string>

namespace pathmark {

// One line for each vertex, in the fewest digits that give the same float back, then one for each
// triangle.
std::string encodeObj(const BlobMesh& mesh);

}  // namespace pathmark
