// The chapter on compensating mistakes, for instructors.
#pragma once

#include "pairs/pair_study.h"

#include <span>
#include <string>

namespace pathmark::pairs {

struct StudiedPair {
  Pair pair;
  PairFinding finding;
};

// One line for a terminal.
std::string pairLine(const StudiedPair& studied);

// Markdown: what the table says, and the table.
std::string pairChapter(std::span<const StudiedPair> pairs, std::uint64_t seed);

}  // namespace pathmark::pairs
