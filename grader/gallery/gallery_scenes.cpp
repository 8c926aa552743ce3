#include "gallery/gallery_scenes.h"

#include "film/contact_sheet.h"
#include "host/session.h"
#include "scene/load_scene.h"

namespace pathmark::gallery {

namespace {

std::vector<const char*> namesOf(int part) {
  switch (part) {
    case 0:
      return {"cornell_box"};
    case 1:
      return {"cornell_box", "cornell_spheres"};
    case 2:
      return {"ucl_rectangle", "ucl_triangle", "ucl_sphere",
              "polygon_light", "many_lights",  "furnace"};
    case 3:
      return {"cornell_box", "cornell_spheres", "polygon_light"};
    case 4:
      return {"cornell_phong", "veach_plates", "ucl_sphere"};
    case 5:
      return {"cornell_box", "cornell_phong", "furnace", "ucl_rectangle"};
    case 8:
      return {"veach_plates", "cornell_phong", "ucl_rectangle"};
    case 9:
      return {"ucl_triangle", "ucl_rectangle", "cornell_box"};
    default:
      return {"cornell_box", "furnace", "ucl_rectangle"};
  }
}

Estimator estimatorOf(int part) {
  return part == 0 ? Estimator::kWarmUp : part == 8 ? Estimator::kMis : Estimator::kPath;
}

}  // namespace

std::vector<marking::MarkingScene> scenesOf(int part) {
  std::vector<marking::MarkingScene> scenes;
  for (const char* name : namesOf(part)) {
    const std::filesystem::path file = shippedSceneFile(name);
    const FlatCamera camera = loadScene(file).flat.camera;
    const LoadedScene loaded =
        loadScene(file, {.size = thumbnailSize(static_cast<int>(camera.width),
                                               static_cast<int>(camera.height), kPixels)});
    scenes.push_back({loaded.name, loaded.flat, estimatorOf(part), loaded.exposure});
    if (part == 9) scenes.back().flat.lightSampling = LightSampling::kBySolidAngle;
  }
  return scenes;
}

}  // namespace pathmark::gallery
