#include "light_paths/language.h"

#include "render/lobe_shares.h"

#include <algorithm>
#include <map>
#include <vector>

namespace pathmark {

namespace {

using Letters = PathExpression::Letters;

constexpr Lobe kLobes[] = {Lobe::kDiffuse, Lobe::kSpecular};

// A deterministic automaton of any size.
struct Table {
  struct Row {
    std::array<std::size_t, 2> next{};
    bool lightMayCome = false;
  };
  std::vector<Row> rows;
  std::size_t start = 0;
};

[[noreturn]] void refuseAsTooIntricate() {
  throw ExpressionError(0,
                        "the expression is too intricate: to follow its paths takes more than 256 "
                        "states; fewer letters before a * or + help");
}

// Letters that may come before one of these on the way to the light, by what they stand for.
class Steps {
 public:
  explicit Steps(const PathExpression& expression) : expression_(expression) {}

  Letters atTheEye() const { return expression_.last() & lettersOf("E"); }

  Letters after(Letters letters, Lobe lobe) const {
    return before(letters) & lettersOf(lobe == Lobe::kDiffuse ? "D." : "S.");
  }

  bool lightMayCome(Letters letters) const {
    return (before(letters) & lettersOf("L") & expression_.first()) != 0;
  }

 private:
  Letters before(Letters letters) const {
    Letters all = 0;
    for (std::size_t i = 0; i < expression_.letterCount(); ++i)
      if ((letters >> i & 1) != 0) all |= expression_.before(i);
    return all;
  }

  Letters lettersOf(std::string_view symbols) const {
    Letters letters = 0;
    for (std::size_t i = 0; i < expression_.letterCount(); ++i)
      if (symbols.find(expression_.symbol(i)) != std::string_view::npos) letters |= Letters{1} << i;
    return letters;
  }

  const PathExpression& expression_;
};

// The subset construction (Rabin & Scott 1959). Row 0 is the empty set.
Table determined(const Steps& steps, const LobesPresent& lobes) {
  constexpr std::size_t kMostSets = 2048;
  std::vector<Letters> sets{0};
  std::map<Letters, std::size_t> known{{0, 0}};
  const auto rowOf = [&](Letters set) {
    const auto [place, isNew] = known.try_emplace(set, sets.size());
    if (isNew) sets.push_back(set);
    if (sets.size() > kMostSets) refuseAsTooIntricate();
    return place->second;
  };
  Table table;
  table.start = rowOf(steps.atTheEye());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    Table::Row row;
    row.lightMayCome = steps.lightMayCome(sets[i]);
    for (const Lobe lobe : kLobes)
      if (lobes.has(lobe))
        row.next[static_cast<std::size_t>(lobe)] = rowOf(steps.after(sets[i], lobe));
    table.rows.push_back(row);
  }
  return table;
}

// For every row the class of those that let the same paths through (Moore 1956).
std::vector<std::size_t> classesOf(const Table& table) {
  std::vector<std::size_t> classes;
  for (const Table::Row& row : table.rows) classes.push_back(row.lightMayCome ? 1 : 0);
  for (std::size_t count = 0;;) {
    std::map<std::array<std::size_t, 3>, std::size_t> known;
    std::vector<std::size_t> finer;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const auto& next = table.rows[i].next;
      const std::array key{classes[i], classes[next[0]], classes[next[1]]};
      finer.push_back(known.try_emplace(key, known.size()).first->second);
    }
    classes = std::move(finer);
    if (known.size() == count) return classes;
    count = known.size();
  }
}

PathAutomaton minimal(const Table& table) {
  const std::vector<std::size_t> classes = classesOf(table);
  PathAutomaton automaton;
  // The dead class is the first, and its representative the empty set.
  std::vector<std::size_t> rows{0};
  std::map<std::size_t, PathAutomaton::State> known{{classes[0], PathAutomaton::kDead}};
  const auto stateOf = [&](std::size_t row) {
    if (rows.size() == PathAutomaton::kMostStates && !known.contains(classes[row]))
      refuseAsTooIntricate();
    const auto state = static_cast<PathAutomaton::State>(rows.size());
    const auto [place, isNew] = known.try_emplace(classes[row], state);
    if (isNew) rows.push_back(row);
    return place->second;
  };
  automaton.start = stateOf(table.start);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Table::Row& row = table.rows[rows[i]];
    automaton.nodes[i].lightMayCome = row.lightMayCome ? 1 : 0;
    for (std::size_t lobe = 0; lobe < 2; ++lobe)
      automaton.nodes[i].next[lobe] = stateOf(row.next[lobe]);
  }
  automaton.states = static_cast<std::uint32_t>(rows.size());
  return automaton;
}

// States from which light may still come are not dead, so that a circle of them has no bound.
class LongestPath {
 public:
  explicit LongestPath(const PathAutomaton& automaton) : automaton_(automaton) {}

  // Nothing if there is no bound.
  std::optional<std::size_t> from(PathAutomaton::State state) {
    if (state == PathAutomaton::kDead) return 0;
    if (inWork_[state]) return std::nullopt;
    if (lengths_[state]) return lengths_[state];
    inWork_[state] = true;
    std::size_t longest = 0;
    for (const Lobe lobe : kLobes) {
      const PathAutomaton::State next = automaton_.next(state, lobe);
      if (next == PathAutomaton::kDead) continue;
      const auto further = from(next);
      if (!further) return std::nullopt;
      longest = std::max(longest, *further + 1);
    }
    inWork_[state] = false;
    lengths_[state] = longest;
    return longest;
  }

 private:
  const PathAutomaton& automaton_;
  std::array<bool, PathAutomaton::kMostStates> inWork_{};
  std::array<std::optional<std::size_t>, PathAutomaton::kMostStates> lengths_{};
};

std::size_t shortestPath(const PathAutomaton& automaton) {
  std::vector<PathAutomaton::State> states{automaton.start};
  for (std::size_t length = 0;; ++length) {
    std::vector<PathAutomaton::State> further;
    for (const PathAutomaton::State state : states) {
      if (automaton.lightMayCome(state)) return length;
      for (const Lobe lobe : kLobes)
        if (automaton.next(state, lobe) != PathAutomaton::kDead)
          further.push_back(automaton.next(state, lobe));
    }
    std::sort(further.begin(), further.end());
    further.erase(std::unique(further.begin(), further.end()), further.end());
    states = std::move(further);
  }
}

}  // namespace

LobesPresent lobesPresent(const FlatSceneView& scene) {
  LobesPresent lobes{false, false};
  for (const FlatShape& shape : scene.shapes) {
    const LobeShares shares = lobeSharesOf(scene.materials[shape.material]);
    lobes.diffuse = lobes.diffuse || shares.diffuse > 0.0f;
    lobes.specular = lobes.specular || shares.specular > 0.0f;
  }
  return lobes;
}

PathAutomaton automatonFor(const PathExpression& expression, const LobesPresent& lobes) {
  return minimal(determined(Steps(expression), lobes));
}

bool isAllLight(const PathAutomaton& automaton, const LobesPresent& lobes) {
  return automaton == automatonFor(PathExpression("L.*E"), lobes);
}

std::optional<Scattering> scatteringOf(const PathAutomaton& automaton) {
  if (automaton.start == PathAutomaton::kDead) return std::nullopt;
  return Scattering{shortestPath(automaton), LongestPath(automaton).from(automaton.start)};
}

}  // namespace pathmark
