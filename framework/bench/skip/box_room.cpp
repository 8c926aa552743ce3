#include "bench/skip/box_room.h"

#include "bench/quick_random.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace pathmark::bench {

LoadedScene boxRoom(int boxes, int side) {
  QuickRandom random(static_cast<std::uint64_t>(boxes));
  const auto between = [&](double low, double high) {
    return low + (high - low) * double{random.next()};
  };
  std::string shapes =
      R"({"type":"box","inward":true,"material":"grey","low":[-1,-1,-1],"high":[1,1,1]},)"
      R"({"type":"rectangle","material":"grey","emission":[9,9,9],"vertices":)"
      R"([[-0.3,0.99,-0.3],[0.3,0.99,-0.3],[0.3,0.99,0.3],[-0.3,0.99,0.3]]})";
  const double size = 0.5 / std::cbrt(boxes);
  for (int k = 0; k < boxes; ++k) {
    const double x = size * between(0.5, 1.0), y = size * between(0.5, 1.0),
                 z = size * between(0.5, 1.0), angle = between(0.0, 360.0);
    shapes += fmt::format(
        R"(,{{"type":"box","material":"grey","low":[-0.5,-0.5,-0.5],"high":[0.5,0.5,0.5],)"
        R"("transform":{{"scale":[{},{},{}],"rotate":{{"axis":[0,1,0],"angle":{}}},)"
        R"("translate":[{},{},{}]}}}})",
        x, y, z, angle, between(-0.8, 0.8), between(-0.8, 0.8), between(-0.8, 0.6));
  }
  const std::string text = fmt::format(
      R"({{"camera":{{"eye":[0,0,0.95],"target":[0,0,0],"fieldOfView":80}},"size":[{0},{0}],)"
      R"("materials":{{"grey":{{"type":"lambertian","Kd":[0.6,0.6,0.6]}}}},"shapes":[{1}]}})",
      side, shapes);
  return loadScene(SceneSource{fmt::format("room of {} boxes.json", boxes), text});
}

}  // namespace pathmark::bench
