// readScene: the text of a scene file as a SceneDescription.
//
// Checks the form: JSON with // and /* */ comments, known and unrepeated keys, the kinds of
// values, how many numbers there are. What the values may be is the business of validate.
#pragma once

#include "scene/description.h"
#include "scene/source.h"

namespace pathmark {

// Throws SceneError.
SceneDescription readScene(const SceneSource& source);

}  // namespace pathmark
