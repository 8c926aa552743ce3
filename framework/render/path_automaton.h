// PathAutomaton: which light paths a render lets through, as the host tells a worker.
//
//   Lobe            what a path does at a surface
//   PathAutomaton   reads a path from the eye, surface by surface
//   isPossible      whether all its numbers lead to states that it has
//
// Deterministic and minimal, so that equal states say that nothing further depends on what was
// read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pathmark {

enum class Lobe : std::uint8_t { kDiffuse = 0, kSpecular = 1 };

struct PathAutomaton {
  using State = std::uint8_t;

  static constexpr std::size_t kMostStates = 256;
  static constexpr State kDead = 0;  // no light can come along such a path any more

  struct Node {
    std::array<State, 2> next{};    // after a scattering event of either lobe
    std::uint8_t lightMayCome = 0;  // 1: the path may end at a light here

    bool operator==(const Node&) const = default;
  };

  std::uint32_t states = 0;  // 0: no automaton, all light is let through
  State start = kDead;       // at the eye
  std::array<std::uint8_t, 3> reserved{};
  std::array<Node, kMostStates> nodes{};

  bool filters() const { return states > 0; }
  State next(State state, Lobe lobe) const {
    return nodes[state].next[static_cast<std::size_t>(lobe)];
  }
  bool lightMayCome(State state) const { return nodes[state].lightMayCome != 0; }

  bool operator==(const PathAutomaton&) const = default;
};

inline bool isPossible(const PathAutomaton& automaton) {
  if (!automaton.filters()) return true;
  if (automaton.states > PathAutomaton::kMostStates || automaton.start >= automaton.states)
    return false;
  for (std::size_t i = 0; i < automaton.states; ++i)
    for (const PathAutomaton::State next : automaton.nodes[i].next)
      if (next >= automaton.states) return false;
  return true;
}

}  // namespace pathmark
