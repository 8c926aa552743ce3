// explainPlan: a plan in words, for a person.
//
// Tells what the plan and the scene's arrays hold, by the functions that a worker asks, too.
#pragma once

#include "render/plan.h"

#include <string>
#include <vector>

namespace pathmark {

struct PlanLine {
  std::string what, decision;
  std::string why;  // may be empty
};

std::vector<PlanLine> explainPlan(const Plan& plan, const FlatSceneView& scene);

}  // namespace pathmark
