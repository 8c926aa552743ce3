#include "bench/stress/moved_scene.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <limits>

namespace pathmark::bench {

namespace {

using nlohmann::json;

class Mover {
 public:
  Mover(const json& scene, const Similarity& similarity) : scale_(similarity.scale) {
    include(scene.at("camera").at("eye"), 0.0);
    for (const json& shape : scene.at("shapes")) include(shape);
    distance_ = 0.0;
    for (std::size_t k = 0; k < 3; ++k) distance_ = std::max(distance_, high_[k] - low_[k]);
    distance_ *= similarity.shift;
  }

  void move(json& scene) const {
    point(scene["camera"]["eye"]);
    point(scene["camera"]["target"]);
    for (json& shape : scene["shapes"]) moveShape(shape);
  }

 private:
  void include(const json& p, double radius) {
    for (std::size_t k = 0; k < 3; ++k) {
      low_[k] = std::min(low_[k], p[k].get<double>() - radius);
      high_[k] = std::max(high_[k], p[k].get<double>() + radius);
    }
  }

  // The size need not be exact: transforms and meshes are left out.
  void include(const json& shape) {
    if (shape.contains("centre")) include(shape["centre"], shape["radius"].get<double>());
    if (shape.contains("low") && !shape.contains("transform")) {
      include(shape["low"], 0.0);
      include(shape["high"], 0.0);
    }
    if (shape.contains("vertices"))
      for (const json& v : shape["vertices"]) include(v, 0.0);
  }

  void point(json& p) const {
    for (json& coordinate : p) coordinate = (coordinate.get<double>() + distance_) * scale_;
  }

  void moveShape(json& shape) const {
    if (shape.contains("centre")) {
      point(shape["centre"]);
      shape["radius"] = shape["radius"].get<double>() * scale_;
    }
    if (shape.contains("vertices"))
      for (json& v : shape["vertices"]) point(v);
    if (shape.contains("low") && !shape.contains("transform")) {
      point(shape["low"]);
      point(shape["high"]);
    } else if (shape.contains("low") || shape.contains("file")) {
      moveTransform(shape["transform"]);
    }
  }

  void moveTransform(json& transform) const {
    if (!transform.contains("translate")) transform["translate"] = json::array({0, 0, 0});
    if (!transform.contains("scale")) transform["scale"] = 1;
    point(transform["translate"]);
    json& scale = transform["scale"];
    if (scale.is_number()) {
      scale = scale.get<double>() * scale_;
    } else {
      for (json& factor : scale) factor = factor.get<double>() * scale_;
    }
  }

  static constexpr double kFar = std::numeric_limits<double>::max();
  double low_[3] = {kFar, kFar, kFar}, high_[3] = {-kFar, -kFar, -kFar};
  double scale_;
  double distance_ = 0.0;
};

}  // namespace

std::string movedScene(const std::filesystem::path& file, const Similarity& similarity) {
  std::ifstream stream(file);
  json scene = json::parse(stream, nullptr, true, true);
  Mover(scene, similarity).move(scene);
  return scene.dump();
}

}  // namespace pathmark::bench
