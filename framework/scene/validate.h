// validate: whether the values of a scene are allowed, one by one.
//
// What shapes must satisfy as a whole (planar, simple, not of zero area) is asked in normalised
// coordinates by makeFaces. Throws SceneError.
#pragma once

#include "scene/description.h"
#include "scene/load_scene.h"
#include "scene/place.h"
#include "scene/source.h"

#include <filesystem>

namespace pathmark {

// No coordinate may be farther from 0, no radius smaller than its inverse: squares and products of
// three still fit a double.
inline constexpr double kLargestCoordinate = 1e100;

// Of an image, in pixels.
inline constexpr int kLargestSide = 16384;

void validate(const SceneDescription& scene, const SceneSource& source);

// Puts the overrides into the scene, under the same limits.
void applyOverrides(SceneDescription& scene, const SceneOverrides& overrides,
                    const std::filesystem::path& file);

}  // namespace pathmark
