// explainRender: how a scene would be rendered, and why, in aligned lines for a person.
#pragma once

#include "host/render_state.h"
#include "scene/load_scene.h"

#include <string>

namespace pathmark {

std::string explainRender(const LoadedScene& scene, const RenderSettings& settings);

}  // namespace pathmark
