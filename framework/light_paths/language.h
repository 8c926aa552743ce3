// From an expression to the automaton that a worker follows paths with, and what can be said of it.
//
//   LobesPresent    the lobes that the surfaces of a scene have
//   automatonFor    the paths of an expression that such a scene can have
//   isAllLight      whether they are all that there are
//   Scattering      between how many scattering events the paths have
#pragma once

#include "light_paths/expression.h"
#include "render/path_automaton.h"
#include "scene/flat_scene.h"

#include <cstddef>
#include <optional>

namespace pathmark {

struct LobesPresent {
  bool diffuse = true, specular = true;

  bool has(Lobe lobe) const { return lobe == Lobe::kDiffuse ? diffuse : specular; }
};

LobesPresent lobesPresent(const FlatSceneView& scene);

// Minimal, with its states in the order in which they are reached from the eye: two expressions for
// the same paths give the same automaton. Throws ExpressionError if it needs too many states.
PathAutomaton automatonFor(const PathExpression& expression, const LobesPresent& lobes = {});

// Whether the paths are all that bring light to the eye.
bool isAllLight(const PathAutomaton& automaton, const LobesPresent& lobes);

struct Scattering {
  std::size_t fewest = 0;
  std::optional<std::size_t> most{};  // nothing: there is no bound
};

// Nothing if the automaton lets no path through.
std::optional<Scattering> scatteringOf(const PathAutomaton& automaton);

}  // namespace pathmark
