// readScene: the text of a scene file as a SceneDescription.
//
// Checks the form: JSON with // and /* */ comments, known and unrepeated keys, the kinds of
// values, how many numbers there are. What the values may be is the business of validate.
#pragma once

#include "scene/description.h"
#include "scene/place.h"

#include <filesystem>
#include <string_view>

namespace pathmark {

// `file` is only used to say where an error is. Throws SceneError.
SceneDescription readScene(std::string_view text, const std::filesystem::path& file);

}  // namespace pathmark
