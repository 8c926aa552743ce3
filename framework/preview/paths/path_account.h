// Where a path's radiance comes from: what the recorded numbers add up to, and what they do not.
//
//   PathAccount   throughputs and contributions of a path, and sentences about what does not fit
//   accountFor    makes it
#pragma once

#include "preview/paths/path_record.h"

#include <optional>
#include <string>
#include <vector>

namespace pathmark::preview {

// What the light that leaves a vertex contributes to the path.
struct VertexAccount {
  // Factor on the light that leaves the vertex: f cos / pdf of the vertices before it, and the
  // roulette's weights. Where the coursework has said its own, to the roulette, that is taken.
  Colour throughput{1.0f};
  bool own = false;        // the coursework's own
  bool stepFits = true;    // the throughput that the path leaves with is f cos / pdf times this one
  Colour emission{0.0f};   // contributed, throughput and all
  Colour direct{0.0f};     // contributed, throughput and all
  bool directFits = true;  // what directLighting returned is what its shadow rays add up to
  std::vector<Colour> shadowRays{};  // Le f G V / pdf of each

  // Of part 8: the weights of the emission and of each shadow ray, if they are known; and what the
  // shadow rays then add up to, without the throughput.
  std::optional<double> emissionWeight{};
  std::vector<std::optional<double>> weights{};
  std::optional<Colour> found{};
};

struct PathAccount {
  std::vector<VertexAccount> vertices;  // of the path, in its order
  Colour explained{0.0f};               // the sum of all contributions
  bool known = true;                    // nothing is missing in that sum
  bool fits = true;                     // the path returned that, within rounding, or nobody knows
  std::vector<std::string> remarks;     // about what does not fit; vertices counted from 1
};

struct AccountRules {
  bool warmUp = false;     // part 0: every vertex adds what it emits, on both sides
  std::size_t lights = 1;  // of the scene
  bool mis = false;        // part 8: lights are sampled by the path itself, and met by it
};

PathAccount accountFor(const TracedPath& path, const AccountRules& rules);

}  // namespace pathmark::preview
