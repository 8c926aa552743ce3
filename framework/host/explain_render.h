// How a scene would be rendered, and why, in aligned lines for a person.
//
//   explainRender          with as many rays of every pixel
//   explainRenderToTarget  with as many of each tile as a stated error needs
#pragma once

#include "host/render_state.h"
#include "scene/load_scene.h"

#include <string>

namespace pathmark {

std::string explainRender(const LoadedScene& scene, const RenderSettings& settings);

// `settings` as AdaptiveRender takes them.
std::string explainRenderToTarget(const LoadedScene& scene, const RenderSettings& settings,
                                  double relativeError);

}  // namespace pathmark
