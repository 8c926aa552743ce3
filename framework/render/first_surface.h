// What LitScene shows of the first surface of a path in the calling thread, where several paths
// share one camera ray (split_paths.h).
//
// The first ray of a path is its camera ray: LitScene::intersect then answers with the surface that
// was met before, and the rest of the path is as always.
#pragma once

#include <pathmark/lit_scene.h>

namespace pathmark {

// The camera ray of the next path meets this surface. With `dark`, the surface is not seen to emit,
// no light is there to light it, and what the first ray from it meets does not emit either: all
// that has been counted already, however the path finds it.
void beginWithSurface(const Hit& surface, bool dark);

// The next path begins like any other.
void beginAnywhere();

}  // namespace pathmark
