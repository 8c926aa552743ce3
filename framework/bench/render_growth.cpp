#include "bench/alternate.h"
#include "bench/render_bench.h"
#include "film/atomic_file.h"
#include "host/blob_file.h"
#include "scene/blob_mesh.h"
#include "scene/encode_obj.h"
#include "scene/load_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

// Of 968 triangles.
constexpr int kCoarse = 11;

// The scene blob with another mesh, in the bench's folder.
fs::path writeCoarseBlob(const fs::path& folder) {
  const fs::path shipped = shippedSceneFile("blob");
  std::ifstream in(shipped);
  nlohmann::ordered_json scene = nlohmann::ordered_json::parse(in);
  scene.erase("$schema");
  for (auto& shape : scene["shapes"]) {
    if (shape["type"] != "mesh") continue;
    shape["file"] = "coarse_blob.obj";
    shape.erase("madeBy");
  }
  writeFileAtomically(folder / "coarse_blob.obj", encodeObj(makeBlobMesh(kCoarse)));
  const fs::path file = folder / "coarse_blob.json";
  writeFileAtomically(file, scene.dump(2));
  return file;
}

}  // namespace

void measureGrowth(RenderBench& bench) {
  const BenchScene* fine = bench.find("s3");
  if (fine == nullptr) return;
  const fs::path file = writeCoarseBlob(bench.runs.folder());
  const std::string scenes[] = {file.string(), fine->name};
  const double perPath[] = {bench.runs.raysPerPath(loadScene(file)),
                            bench.runs.raysPerPath(fine->scene)};
  const RenderPlan& plan = bench.plan;
  std::vector<double> ratios;
  for (int k = 0; k < bench.plan.seeds; ++k) {
    double seconds[2];
    for (int s = 0; s < 2; ++s) {
      bench.progress.show("blobs of 1,000 and of 1,000,000 triangles");
      const auto cpu = [&](std::uint64_t rays) {
        return bench.runs
            .render(
                {.scene = scenes[s], .raysPerPixel = rays, .seed = static_cast<std::uint64_t>(k)})
            .usage.cpuSeconds;
      };
      // Without what it takes to start and to load the mesh.
      seconds[s] = (cpu(plan.manyRays) - cpu(plan.fewRays)) / perPath[s];
    }
    ratios.push_back(seconds[1] / seconds[0]);
    bench.progress.advance(1.0);
  }
  bench.add({.key = "growth",
             .name = "s3: cost of a ray with 1,000,000 triangles / with 1,000, whole renders",
             .value = median(std::move(ratios)),
             .target = Target{.must = 2.5, .moreIsBetter = false},
             .note = "CPU time of rendering, by the rays of all kinds; bench rays --large has that "
                     "of rays alone"});
}

}  // namespace pathmark::bench
