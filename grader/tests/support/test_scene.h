// TestScene: a scene made in code by SceneBuilder, to be asked as a LitScene.
#pragma once

#include "checks/scenes.h"
#include "render/scene_core.h"
#include "scene/flat_scene.h"

#include <pathmark/coursework.h>

#include <memory>

namespace pathmark::testing {

using checks::SceneBuilder;
using checks::Surface;

class TestScene {
 public:
  explicit TestScene(const SceneBuilder& builder) : TestScene(builder.flat()) {}
  explicit TestScene(FlatScene flat);

  LitScene lit(int maxBounces) const { return {*core_, maxBounces}; }
  const SceneCore& core() const { return *core_; }
  const FlatScene& flat() const { return flat_; }

 private:
  FlatScene flat_;
  std::unique_ptr<SceneCore> core_;
};

}  // namespace pathmark::testing
