#include "tests/support/test_scene.h"

#include <utility>

namespace pathmark::testing {

TestScene::TestScene(FlatScene flat)
    : flat_(std::move(flat)), core_(std::make_unique<SceneCore>(viewOf(flat_))) {}

}  // namespace pathmark::testing
