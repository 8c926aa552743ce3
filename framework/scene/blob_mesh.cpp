#include "scene/blob_mesh.h"

#include <cmath>
#include <cstdlib>

namespace pathmark {

namespace {

// A point of the octahedron |x| + |y| + |z| = n with whole coordinates. These are the corners of
// its triangles, and each stands for one vertex, whichever of the faces around it asks.
struct LatticePoint {
  int x, y, z;
};

// The number of a point if they are counted ring by ring from y = -n to y = n. The ring at y has
// 4 (n - |y|) points, or one at the tips.
class LatticeNumbering {
 public:
  explicit LatticeNumbering(int n) : n_(n) {
    std::uint32_t next = 0;
    for (int y = -n; y <= n; ++y) {
      firstOfRing_.push_back(next);
      next += pointsOfRing(n - std::abs(y));
    }
  }

  std::uint32_t number(const LatticePoint& p) const {
    const int ring = p.y + n_;
    return firstOfRing_[static_cast<std::size_t>(ring)] +
           static_cast<std::uint32_t>(stepsAlongRing(p.x, p.z));
  }

 private:
  static std::uint32_t pointsOfRing(int size) {
    return size == 0 ? 1 : 4 * static_cast<std::uint32_t>(size);
  }

  // From (size, 0) by way of (0, size), (-size, 0) and (0, -size) in (x, z).
  static int stepsAlongRing(int x, int z) {
    const int size = std::abs(x) + std::abs(z);
    if (x > 0 && z >= 0) return z;
    if (x <= 0 && z > 0) return size - x;
    if (x < 0) return 2 * size - z;
    return size == 0 ? 0 : 3 * size + x;
  }

  int n_;
  std::vector<std::uint32_t> firstOfRing_;
};

// In [-1, 1]: waves of three lengths, none of which repeats in another.
double lumps(double x, double y, double z) {
  return 0.5 * std::sin(7 * x + 1.3) * std::sin(8 * y + 0.7) * std::sin(9 * z + 0.2) +
         0.3 * std::sin(23 * x + 0.4) * std::sin(19 * y + 1.1) * std::sin(21 * z + 2.0) +
         0.2 * std::sin(61 * x + 0.9) * std::sin(53 * y + 0.3) * std::sin(67 * z + 1.7);
}

std::array<float, 3> vertexAt(const LatticePoint& p) {
  const double length = std::hypot(p.x, p.y, p.z);
  const double x = p.x / length, y = p.y / length, z = p.z / length;
  const double radius = 100.0 * (1.0 + 0.12 * lumps(x, y, z));
  return {static_cast<float>(radius * x), static_cast<float>(110.0 + radius * y),
          static_cast<float>(radius * z)};
}

std::vector<std::array<float, 3>> makeVertices(int n) {
  std::vector<std::array<float, 3>> vertices;
  const auto size = static_cast<std::size_t>(n);
  vertices.reserve(4 * size * size + 2);
  // In the order of LatticeNumbering.
  for (int y = -n; y <= n; ++y) {
    const int ring = n - std::abs(y);
    if (ring == 0) vertices.push_back(vertexAt({0, y, 0}));
    for (int k = 0; k < ring; ++k) vertices.push_back(vertexAt({ring - k, y, k}));
    for (int k = 0; k < ring; ++k) vertices.push_back(vertexAt({-k, y, ring - k}));
    for (int k = 0; k < ring; ++k) vertices.push_back(vertexAt({k - ring, y, -k}));
    for (int k = 0; k < ring; ++k) vertices.push_back(vertexAt({k, y, k - ring}));
  }
  return vertices;
}

}  // namespace

BlobMesh makeBlobMesh(int n) {
  BlobMesh mesh;
  mesh.vertices = makeVertices(n);
  const auto size = static_cast<std::size_t>(n);
  mesh.triangles.reserve(8 * size * size);
  const LatticeNumbering lattice(n);
  for (int octant = 0; octant < 8; ++octant) {
    const int sx = (octant & 1) != 0 ? -1 : 1, sy = (octant & 2) != 0 ? -1 : 1,
              sz = (octant & 4) != 0 ? -1 : 1;
    const auto corner = [&](int i, int j) {
      return lattice.number({sx * (n - i - j), sy * i, sz * j});
    };
    // Each mirroring turns the triangles' sense of rotation around.
    const bool mirrored = sx * sy * sz < 0;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      mesh.triangles.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (i + j + 1 < n) add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
    }
  }
  return mesh;
}

}  // namespace pathmark
