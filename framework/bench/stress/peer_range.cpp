// The same for another renderer, so that the ranges can be compared: Cycles has no reader that
// moves a scene to where floats are accurate, and gets it where it is.
#include "bench/cycles_peer.h"
#include "bench/picture_folder.h"
#include "bench/stress/block_difference.h"
#include "bench/stress/stress.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace pathmark::bench {

namespace {

constexpr std::uint64_t kRays = 64;

// The longest side of the box around what is in the scene, and the eye.
double sizeOf(const FlatScene& scene) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  const auto include = [&](const Float3& p, float radius) {
    low = min(low, glm::vec3(p[0], p[1], p[2]) - radius);
    high = max(high, glm::vec3(p[0], p[1], p[2]) + radius);
  };
  include(scene.camera.eye, 0.0f);
  for (const Float3& vertex : scene.vertices) include(vertex, 0.0f);
  for (const FlatSphere& sphere : scene.spheres) include(sphere.centre, sphere.radius);
  const glm::vec3 sides = high - low;
  return std::max({sides.x, sides.y, sides.z});
}

std::vector<CyclesPlace> places(double size) {
  std::vector<CyclesPlace> all;
  for (const double scale : {1e-6, 1e-5, 1e-4, 1e-3, 1e3, 1e4, 1e5, 1e6})
    all.push_back({scale, 0.0});
  for (const double sizes : {1.0, 1e1, 1e2, 1e3, 1e4}) all.push_back({1.0, sizes * size});
  return all;
}

}  // namespace

void stressPeer(Stress& stress) {
  const PictureFolder folder;
  const std::optional<CyclesPeer> peer = CyclesPeer::find(folder.path());
  if (!peer) throw UsageError("--peer cycles: the program blender has gone.");
  stress.begin(
      {.key = "peer",
       .title = fmt::format("{}: differences in % from the scene as it is, with {} rays per "
                            "pixel and the same random numbers",
                            peer->version(), kRays),
       .columns = {{"scene", "scene"},
                   {"scale", "scale"},
                   {"sizes", "moved by sizes"},
                   {"mean", "mean", 4},
                   {"block", "worst block", 4}},
       .rows = {}});
  // Of triangles alone: a sphere is a mesh of many thousands there.
  const BenchScene scene = loadBenchScene("s1", "cornell_box");
  const double size = sizeOf(scene.scene.flat);
  stress.progress.show("cornell_box with Cycles");
  const Image original = peer->render(scene, kRays, 1).image;
  for (const CyclesPlace& place : places(size)) {
    const double sizes = place.shift / size;
    stress.progress.show(fmt::format("cornell_box with Cycles, scale {:g}, moved by {:g} sizes",
                                     place.scale, sizes));
    const BlockDifference d = blockDifference(peer->render(scene, kRays, 1, place).image, original);
    stress.progress.advance(8.0);
    stress.row({std::string("cornell_box"), fmt::format("{:g}", place.scale),
                fmt::format("{:g}", sizes), 100.0 * d.mean, 100.0 * d.block});
  }
}

}  // namespace pathmark::bench
