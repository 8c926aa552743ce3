// explainLightPaths: what an expression means for renders of a scene, in words for a person.
#pragma once

#include "light_paths/expression.h"
#include "render/explain_plan.h"

#include <vector>

namespace pathmark {

std::vector<PlanLine> explainLightPaths(const PathExpression& expression,
                                        const FlatSceneView& scene);

}  // namespace pathmark
