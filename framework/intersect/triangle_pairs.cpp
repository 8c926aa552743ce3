#include "intersect/triangle_pairs.h"

#include <map>
#include <optional>
#include <utility>

namespace pathmark {

namespace {

using Corners = std::array<Float3, 3>;

struct Side {
  std::uint32_t triangle;
  std::size_t from;  // corner that the edge starts from
};

struct Edge {
  Float3 from, to;
  bool frontOnly;
  auto operator<=>(const Edge&) const = default;
};

class Pairing {
 public:
  explicit Pairing(const FlatSceneView& scene)
      : scene_(scene), paired_(scene.triangles.size(), false) {}

  std::vector<TrianglePair> pairs(std::span<const std::uint32_t> triangles) {
    for (const std::uint32_t i : triangles)
      if (!joinWaiting(i)) wait(i);
    for (const std::uint32_t i : triangles)
      if (!paired_[i]) addSingle(i);
    return std::move(pairs_);
  }

 private:
  Corners cornersOf(std::uint32_t triangle) const {
    return scene_.corners(scene_.triangles[triangle]);
  }

  Edge edge(std::uint32_t triangle, const Float3& from, const Float3& to) const {
    return {from, to, scene_.frontOnly(scene_.triangles[triangle])};
  }

  void wait(std::uint32_t triangle) {
    const Corners c = cornersOf(triangle);
    for (std::size_t k = 0; k < 3; ++k)
      waiting_.insert_or_assign(edge(triangle, c[k], c[(k + 1) % 3]), Side{triangle, k});
  }

  // Pairs the triangle with an earlier one that has one of its edges the other way round.
  bool joinWaiting(std::uint32_t triangle) {
    const Corners c = cornersOf(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = waiting_.find(edge(triangle, c[(k + 1) % 3], c[k]));
      if (found == waiting_.end() || paired_[found->second.triangle]) continue;
      const Side other = found->second;
      const Corners o = cornersOf(other.triangle);
      // Of the earlier triangle a b c the common edge is c a.
      pairs_.push_back(
          {{o[(other.from + 1) % 3], o[(other.from + 2) % 3], o[other.from], c[(k + 2) % 3]},
           {other.triangle, triangle},
           false});
      paired_[triangle] = paired_[other.triangle] = true;
      return true;
    }
    return false;
  }

  void addSingle(std::uint32_t triangle) {
    const Corners c = cornersOf(triangle);
    pairs_.push_back({{c[0], c[1], c[2], c[2]}, {triangle, triangle}, true});
  }

  const FlatSceneView& scene_;
  std::vector<bool> paired_;
  std::map<Edge, Side> waiting_;
  std::vector<TrianglePair> pairs_;
};

}  // namespace

std::vector<TrianglePair> pairTriangles(const FlatSceneView& scene,
                                        std::span<const std::uint32_t> triangles) {
  return Pairing(scene).pairs(triangles);
}

}  // namespace pathmark
