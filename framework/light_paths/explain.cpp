#include "light_paths/explain.h"

#include "light_paths/language.h"
#include "render/lobe_shares.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark {

namespace {

constexpr const char* kLine = "light paths";

std::string events(std::size_t n) {
  return n == 1 ? std::string("1 scattering event") : fmt::format("{} scattering events", n);
}

PlanLine nothing(const std::string& text, const std::string& why) {
  return {kLine, fmt::format("{}: none, the picture is black", text), why};
}

// Why no path of the expression can be one of the scene.
std::string whatIsMissing(const LobesPresent& lobes) {
  if (!lobes.diffuse && !lobes.specular) return "there is no surface";
  return lobes.specular ? "no surface has a diffuse lobe (D), and every such path needs one"
                        : "no surface has a specular lobe (S), and every such path needs one";
}

PlanLine howFar(const Scattering& scattering, std::uint32_t maxBounces) {
  const std::size_t fewest = scattering.fewest;
  if (scattering.most && *scattering.most < maxBounces) {
    const std::size_t most = *scattering.most;
    return {"scattering",
            fewest == most ? events(most) : fmt::format("{} to {}", fewest, events(most)),
            fmt::format("no ray goes on from surface {}; maxBounces is {}", most + 1, maxBounces)};
  }
  return {"scattering", fmt::format("{} to {}", fewest, events(maxBounces)),
          "the expression sets no limit below maxBounces"};
}

bool anyMaterialHasBothLobes(const FlatSceneView& scene) {
  return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const FlatShape& shape) {
    return lobeSharesOf(scene.materials[shape.material]).hasBoth();
  });
}

PlanLine choiceOfLobes(const PathAutomaton& automaton, const LobesPresent& lobes,
                       const FlatSceneView& scene) {
  if (!lobes.specular) return {"lobes", "no choice", "every surface has a diffuse lobe (D) only"};
  if (!lobes.diffuse) return {"lobes", "no choice", "every surface has a specular lobe (S) only"};
  if (!anyMaterialHasBothLobes(scene)) return {"lobes", "no choice", "no surface has both D and S"};
  bool apart = false, byChance = false;
  for (std::size_t i = 1; i < automaton.states; ++i) {
    const auto& next = automaton.nodes[i].next;
    apart = apart || next[0] != next[1];
    byChance = byChance || (next[0] != next[1] && next[0] != PathAutomaton::kDead &&
                            next[1] != PathAutomaton::kDead);
  }
  if (!apart) return {"lobes", "no choice", "D and S are never told apart"};
  if (!byChance)
    return {"lobes", "only the lobe that is asked for",
            "where D and S are told apart, one of them is ruled out"};
  return {"lobes", "one by chance at a surface that has both, over its probability",
          "in proportion to Kd and Ks; where one of them is ruled out, the other"};
}

}  // namespace

std::vector<PlanLine> explainLightPaths(const PathExpression& expression,
                                        const FlatSceneView& scene) {
  const std::string& text = expression.text();
  const LobesPresent lobes = lobesPresent(scene);
  const PathAutomaton automaton = automatonFor(expression, lobes);
  const auto scattering = scatteringOf(automaton);
  if (!scattering) return {nothing(text, whatIsMissing(lobes) + "; no ray is traced")};
  if (scattering->fewest > scene.maxBounces)
    return {nothing(text, fmt::format("its paths have at least {}, and maxBounces is {}",
                                      events(scattering->fewest), scene.maxBounces))};
  if (isAllLight(automaton, lobes))
    return {{kLine, fmt::format("{}: all of the scene's", text),
             "the picture is bit for bit that without --paths"}};
  return {{kLine, text, "shadow rays and surfaces that cannot complete such a path are left out"},
          howFar(*scattering, scene.maxBounces),
          choiceOfLobes(automaton, lobes, scene)};
}

}  // namespace pathmark
