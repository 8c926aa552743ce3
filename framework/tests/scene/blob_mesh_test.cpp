// The generated mesh: closed, turned outwards, and of the shape that its formula says.
#include "scene/blob_mesh.h"
#include "scene/encode_obj.h"
#include "scene/obj_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pathmark {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Every triangle's three edges, in the direction in which it runs along them, sorted.
std::vector<Edge> directedEdges(const BlobMesh& mesh) {
  std::vector<Edge> edges;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) edges.push_back(edge);
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Six times the volume between a triangle and the blob's centre; positive if it runs
// counter-clockwise as seen from outside.
double volume(const BlobMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  std::array<std::array<double, 3>, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [x, y, z] = mesh.vertices[triangle[k]];
    p[k] = {x, y - 110.0, z};
  }
  double determinant = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    determinant +=
        p[0][k] * (p[1][(k + 1) % 3] * p[2][(k + 2) % 3] - p[1][(k + 2) % 3] * p[2][(k + 1) % 3]);
  return determinant;
}

class BlobMeshOf : public testing::TestWithParam<int> {};

TEST_P(BlobMeshOf, HasTheTrianglesAndVerticesOfASubdividedOctahedron) {
  const auto n = static_cast<std::size_t>(GetParam());
  const BlobMesh mesh = makeBlobMesh(GetParam());
  EXPECT_EQ(mesh.triangles.size(), 8 * n * n);
  EXPECT_EQ(mesh.vertices.size(), 4 * n * n + 2);
}

TEST_P(BlobMeshOf, EveryEdgeBelongsToTwoTrianglesThatRunAlongItInOppositeDirections) {
  const BlobMesh mesh = makeBlobMesh(GetParam());
  const std::vector<Edge> edges = directedEdges(mesh);
  EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
  const bool paired = std::all_of(edges.begin(), edges.end(), [&](const Edge& e) {
    return e.first != e.second &&
           std::binary_search(edges.begin(), edges.end(), Edge{e.second, e.first});
  });
  EXPECT_TRUE(paired);
  // Euler's characteristic of a sphere: vertices - edges + faces.
  EXPECT_EQ(static_cast<std::int64_t>(mesh.vertices.size()) -
                static_cast<std::int64_t>(edges.size() / 2) +
                static_cast<std::int64_t>(mesh.triangles.size()),
            2);
}

TEST_P(BlobMeshOf, StoresNoPointTwice) {
  BlobMesh mesh = makeBlobMesh(GetParam());
  std::sort(mesh.vertices.begin(), mesh.vertices.end());
  EXPECT_EQ(std::adjacent_find(mesh.vertices.begin(), mesh.vertices.end()), mesh.vertices.end());
}

TEST_P(BlobMeshOf, EveryTriangleFacesOutwards) {
  const BlobMesh mesh = makeBlobMesh(GetParam());
  for (const auto& triangle : mesh.triangles) ASSERT_GT(volume(mesh, triangle), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Subdivisions, BlobMeshOf, testing::Values(1, 2, 3, 7, kBlobSubdivisions));

TEST(BlobMesh, TheShippedOneHasAMillionTriangles) {
  EXPECT_EQ(makeBlobMesh(kBlobSubdivisions).triangles.size(), 1002528u);
}

// Vertices in the directions (1,0,0), (0,-1,0), (-1,2,3) and (2,1,-3), computed apart.
TEST(BlobMesh, VerticesLieWhereTheFormulaSays) {
  const std::array<std::array<double, 3>, 4> expected{
      {{97.24903736782325, 110.0, 0.0},
       {0.0, 11.151302790607616, 0.0},
       {-27.428824257722166, 164.85764851544434, 82.2864727731665},
       {53.04180359717897, 136.52090179858948, -79.56270539576846}}};
  const BlobMesh mesh = makeBlobMesh(6);
  for (const auto& e : expected) {
    const bool found = std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const auto& v) {
      return std::abs(v[0] - e[0]) < 1e-5 && std::abs(v[1] - e[1]) < 1e-5 &&
             std::abs(v[2] - e[2]) < 1e-5;
    });
    EXPECT_TRUE(found) << e[0] << " " << e[1] << " " << e[2];
  }
}

TEST(BlobMesh, ItsObjTextReadsBackToTheSameFloats) {
  const BlobMesh mesh = makeBlobMesh(5);
  const Mesh read = readObj({"blob.obj", encodeObj(mesh)});
  ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
  ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3& point = read.vertices[read.triangles[t][k]];
      const auto& vertex = mesh.vertices[mesh.triangles[t][k]];
      for (int i = 0; i < 3; ++i)
        EXPECT_EQ(static_cast<float>(point[i]), vertex[static_cast<std::size_t>(i)]);
    }
}

}  // namespace
}  // namespace pathmark
