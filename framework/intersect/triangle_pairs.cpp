#include "intersect/triangle_pairs.h"

#include "math/rounding.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
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

// Corners are where rounding has put them: as far from the first triangle's plane as that, the
// fourth is in it. A corner between the two triangles that is nearly straight might be seen from
// the side as bent inwards.
bool isFlatAndConvex(const std::array<Float3, 4>& corners) {
  std::array<glm::dvec3, 4> p;
  double magnitude = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    p[k] = {corners[k][0], corners[k][1], corners[k][2]};
    for (const float x : corners[k]) magnitude = std::max(magnitude, std::abs(double{x}));
  }
  const glm::dvec3 n = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
  if (!(std::abs(glm::dot(p[3] - p[0], n)) <= 4.0 * kUnitRoundoff * magnitude)) return false;
  constexpr double kLeastBend = 1e-3;
  for (std::size_t k = 0; k < 4; ++k) {
    const glm::dvec3 in = p[k] - p[(k + 3) % 4], out = p[(k + 1) % 4] - p[k];
    const double bend = glm::dot(glm::cross(in, out), n);
    if (!(bend > kLeastBend * glm::length(in) * glm::length(out))) return false;
  }
  return true;
}

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
      const std::array<Float3, 4> corners{o[(other.from + 1) % 3], o[(other.from + 2) % 3],
                                          o[other.from], c[(k + 2) % 3]};
      const bool flat =
          scene_.triangles[other.triangle].shape == scene_.triangles[triangle].shape &&
          isFlatAndConvex(corners);
      pairs_.push_back({corners, {other.triangle, triangle}, false, flat});
      paired_[triangle] = paired_[other.triangle] = true;
      return true;
    }
    return false;
  }

  void addSingle(std::uint32_t triangle) {
    const Corners c = cornersOf(triangle);
    pairs_.push_back({{c[0], c[1], c[2], c[2]}, {triangle, triangle}, true, true});
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

std::vector<TrianglePair> inNoPairs(const FlatSceneView& scene,
                                    std::span<const std::uint32_t> triangles) {
  std::vector<TrianglePair> all;
  for (const std::uint32_t t : triangles) {
    const auto [a, b, c] = scene.corners(scene.triangles[t]);
    all.push_back({{a, b, c, c}, {t, t}, true, true});
  }
  return all;
}

}  // namespace pathmark
