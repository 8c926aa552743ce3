// Attack: takes memory without end
// Expected: memory limit
#include <pathmark/coursework.h>

#include <vector>

namespace pathmark {

namespace {

int attack() {
  std::vector<std::vector<char>> all;
  for (;;) all.emplace_back(std::size_t{1} << 24, 1);
}

}  // namespace

}  // namespace pathmark
