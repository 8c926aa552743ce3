// RenderWay: how a picture is made of a coursework, in the options of pathmark render.
#pragma once

#include "render/render_job.h"
#include "scene/flat_scene.h"

#include <string>
#include <string_view>

namespace pathmark::bench {

struct RenderWay {
  Estimator estimator = Estimator::kPath;
  PathSharing sharing{};
  LightSampling lightSampling = LightSampling::kByArea;
  std::string words{};  // as they were asked for, such as "+reuse16+direct-paths4"; empty: none
};

// Takes from the end of `text` what says how to render: +mis, +solid-angle, +splitN,
// +share-direct, +reuseN, +direct-pathsN. Throws UsageError for numbers and combinations that
// render does not take.
RenderWay takeWay(std::string_view& text);

}  // namespace pathmark::bench
