#include "scene/spelling.h"

#include "scene/syntax_sentence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

namespace pathmark {
namespace {

// No word of the format is longer, and a hostile file must not make the table below large.
constexpr std::size_t kLongestWord = 64;

bool sameLetter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

// Optimal string alignment distance (Damerau 1964, Levenshtein 1966).
std::size_t editDistance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> table((a.size() + 1) * columns);
  const auto cost = [&](std::size_t i, std::size_t j) -> std::size_t& {
    return table[i * columns + j];
  };
  for (std::size_t i = 0; i <= a.size(); ++i) cost(i, 0) = i;
  for (std::size_t j = 0; j <= b.size(); ++j) cost(0, j) = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = cost(i - 1, j - 1) + (sameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
      cost(i, j) = std::min({cost(i - 1, j) + 1, cost(i, j - 1) + 1, replaced});
      if (i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1])) {
        cost(i, j) = std::min(cost(i, j), cost(i - 2, j - 2) + 1);
      }
    }
  }
  return cost(a.size(), b.size());
}

}  // namespace

std::string_view nearestName(std::string_view word, std::span<const std::string_view> names) {
  std::string_view nearest;
  if (word.empty() || word.size() > kLongestWord) return nearest;
  std::size_t fewest = kLongestWord;
  for (const std::string_view name : names) {
    if (name.size() > kLongestWord) continue;
    const std::size_t distance = editDistance(word, name);
    if (distance <= name.size() / 3 && distance < fewest) {
      fewest = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::string didYouMean(std::string_view word, std::span<const std::string_view> names) {
  const std::string_view nearest = nearestName(word, names);
  return nearest.empty() ? std::string() : fmt::format(" Did you mean {}?", inQuotes(nearest));
}

}  // namespace pathmark
