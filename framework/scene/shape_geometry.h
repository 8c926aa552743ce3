// makeGeometry: the vertices of boxes and meshes, in the coordinates of the scene.
#pragma once

#include "scene/description.h"
#include "scene/source.h"

namespace pathmark {

// Fills `vertices` and, of meshes, `triangles`, with the transforms applied. Mesh files are looked
// for below the scene's own folder and nowhere else: a scene may come from a stranger, and an error
// quotes what it has found. Throws SceneError.
void makeGeometry(SceneDescription& scene, const SceneSource& source);

}  // namespace pathmark
