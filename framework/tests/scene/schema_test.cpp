// scene.schema.json, which editors go by, against the loader.
#include "scene_files.h"

#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace pathmark {
namespace {

using nlohmann::json;

const std::filesystem::path kRoot = PATHMARK_ROOT;

json parseFile(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return json::parse(stream, nullptr, true, true);
}

rapidjson::Document toRapid(const json& value) {
  rapidjson::Document document;
  document.Parse(value.dump().c_str());
  return document;
}

bool fitsSchema(const json& scene) {
  static const rapidjson::SchemaDocument schema(
      toRapid(parseFile(kRoot / "scenes" / "scene.schema.json")));
  rapidjson::SchemaValidator validator(schema);
  return toRapid(scene).Accept(validator);
}

bool loads(const SceneFolder& folder, const json& scene) {
  try {
    folder.load(scene.dump());
    return true;
  } catch (const SceneError&) {
    return false;
  }
}

TEST(Schema, AcceptsEveryShippedScene) {
  int found = 0;
  for (const char* folder : {"scenes", "student/scenes", "solutions/scenes"}) {
    if (!std::filesystem::exists(kRoot / folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(kRoot / folder)) {
      const std::filesystem::path& file = entry.path();
      if (file.extension() != ".json" || file.stem().extension() == ".schema") continue;
      const json scene = parseFile(file);
      EXPECT_TRUE(fitsSchema(scene)) << file;
      EXPECT_TRUE(scene.contains("$schema")) << file;
      ++found;
    }
  }
  EXPECT_GE(found, 7);
}

// Every kind of material, shape and optional key.
const json& fullScene() {
  static const json scene = json::parse(R"({
    "$schema": "scene.schema.json",
    "caption": "all",
    "camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 45},
    "size": [64, 48], "maxBounces": 4, "raysPerPixel": 16, "exposure": 2,
    "materials": {
      "white": {"type": "lambertian", "Kd": [0.7, 0.7, 0.7]},
      "shiny": {"type": "phong", "Kd": [0.2, 0.2, 0.2], "Ks": [0.5, 0.5, 0.5], "exponent": 10}},
    "shapes": [
      {"type": "triangle", "name": "t", "material": "white", "frontOnly": true,
       "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]},
      {"type": "quad", "material": "white", "vertices": [[0,0,0], [1,0,0], [1,1,0.5], [0,1,0]]},
      {"type": "rectangle", "material": "white", "emission": [1, 1, 1],
       "vertices": [[0, 2, 0], [1, 2, 0], [1, 2, 1], [0, 2, 1]]},
      {"type": "polygon", "material": "shiny",
       "vertices": [[0, 0, 1], [3, 0, 1], [3, 3, 1], [1, 1, 1], [0, 3, 1]]},
      {"type": "sphere", "material": "shiny", "centre": [0, 0, -3], "radius": 1.5, "inward": true},
      {"type": "box", "material": "white", "low": [0, 0, 0], "high": [1, 1, 1], "inward": false,
       "transform": {"scale": [1, 2, -3], "rotate": {"axis": [0, 1, 0], "angle": 30},
                     "translate": [1, 2, 3]}},
      {"type": "mesh", "material": "white", "file": "m.obj", "madeBy": "hand",
       "transform": {"scale": 2}}]
  })");
  return scene;
}

class SchemaAndLoader : public testing::Test {
 protected:
  SchemaAndLoader() { folder_.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); }

  // Puts `value` at `pointer`, or takes what is there away if it is null, and asks both.
  void expectBoth(bool accept, const std::string& pointer, const json& value) {
    json scene = fullScene();
    const json::json_pointer place(pointer);
    if (value.is_null()) {
      scene.at(place.parent_pointer()).erase(place.back());
    } else {
      scene[place] = value;
    }
    EXPECT_EQ(fitsSchema(scene), accept) << "schema: " << pointer << " = " << value;
    EXPECT_EQ(loads(folder_, scene), accept) << "loader: " << pointer << " = " << value;
  }

  SceneFolder folder_;
};

TEST_F(SchemaAndLoader, AgreeOnASceneOfEverything) {
  EXPECT_TRUE(fitsSchema(fullScene()));
  EXPECT_TRUE(loads(folder_, fullScene()));
}

TEST_F(SchemaAndLoader, AgreeOnWhatMayBeLeftOut) {
  for (const char* key :
       {"/$schema", "/caption", "/camera/up", "/size", "/maxBounces", "/raysPerPixel", "/exposure",
        "/shapes/0/name", "/shapes/0/frontOnly", "/shapes/2/emission", "/shapes/4/inward",
        "/shapes/5/transform", "/shapes/5/transform/scale", "/shapes/5/transform/rotate",
        "/shapes/6/madeBy"}) {
    expectBoth(true, key, nullptr);
  }
  for (const char* key :
       {"/camera", "/shapes", "/camera/eye", "/camera/target", "/camera/fieldOfView",
        "/materials/white/type", "/materials/white/Kd", "/materials/shiny/Ks",
        "/materials/shiny/exponent", "/shapes/0/type", "/shapes/0/material", "/shapes/0/vertices",
        "/shapes/4/centre", "/shapes/4/radius", "/shapes/5/low", "/shapes/5/high",
        "/shapes/5/transform/rotate/axis", "/shapes/5/transform/rotate/angle", "/shapes/6/file"}) {
    expectBoth(false, key, nullptr);
  }
}

TEST_F(SchemaAndLoader, AgreeOnUnknownKeys) {
  for (const char* parent : {"", "/camera", "/materials/white", "/materials/shiny", "/shapes/0",
                             "/shapes/3", "/shapes/4", "/shapes/5", "/shapes/5/transform",
                             "/shapes/5/transform/rotate", "/shapes/6"}) {
    expectBoth(false, fmt::format("{}/colour", parent), "red");
  }
}

TEST_F(SchemaAndLoader, AgreeOnKindsOfValues) {
  for (const char* place : {"/caption",
                            "/camera",
                            "/camera/eye",
                            "/camera/fieldOfView",
                            "/size",
                            "/maxBounces",
                            "/raysPerPixel",
                            "/exposure",
                            "/materials",
                            "/materials/white",
                            "/materials/white/type",
                            "/materials/white/Kd",
                            "/materials/shiny/exponent",
                            "/shapes",
                            "/shapes/0",
                            "/shapes/0/name",
                            "/shapes/0/material",
                            "/shapes/0/frontOnly",
                            "/shapes/0/vertices",
                            "/shapes/0/vertices/1",
                            "/shapes/0/vertices/1/2",
                            "/shapes/2/emission",
                            "/shapes/4/radius",
                            "/shapes/4/inward",
                            "/shapes/5/low",
                            "/shapes/5/transform",
                            "/shapes/5/transform/scale",
                            "/shapes/5/transform/rotate",
                            "/shapes/5/transform/rotate/angle",
                            "/shapes/6/file"}) {
    const json& there = fullScene().at(json::json_pointer(place));
    for (const json& other : {json("word"), json(true), json::array({1, 2, 3, 4, 5}),
                              json::object({{"a", 1}}), json(2.25)}) {
      if (other.type() == there.type() || (other.is_number() && there.is_number())) continue;
      if (std::string(place).ends_with("/scale") && other.is_number()) continue;
      expectBoth(false, place, other);
    }
  }
}

TEST_F(SchemaAndLoader, AgreeOnRanges) {
  const std::vector<std::pair<const char*, std::vector<json>>> refused{
      {"/camera/fieldOfView", {0, 180, -1, 200}},
      {"/size", {json::array({64}), json::array({0, 5}), json::array({5, 16385})}},
      {"/size/0", {1.5}},
      {"/maxBounces", {-1, 1001, 2.5}},
      {"/raysPerPixel", {0, 1000000001, 1e12, 0.5}},
      {"/exposure", {0, -1, 1e31}},
      {"/materials/white/Kd/1", {-0.1, 1.1, 7}},
      {"/materials/shiny/exponent", {-1, 1000001}},
      {"/materials/white/type", {"glass"}},
      {"/shapes/0/type", {"cone"}},
      {"/shapes/0/vertices", {json::array()}},
      {"/shapes/0/vertices/0", {json::array({1, 2}), json::array({1, 2, 3, 4})}},
      {"/shapes/0/vertices/0/0", {1e101, -1e101}},
      {"/shapes/2/emission/0", {-1, 1e31}},
      {"/shapes/4/radius", {0, -1, 1e101}},
      {"/shapes/5/transform/scale", {0, json::array({1, 0, 1}), json::array({1, 1})}},
      {"/shapes/6/file", {"m.stl", "/m.obj"}},
  };
  for (const auto& [place, values] : refused) {
    for (const json& value : values) expectBoth(false, place, value);
  }
  const std::vector<std::pair<const char*, std::vector<json>>> accepted{
      {"/camera/fieldOfView", {1, 179}},   {"/size", {json::array({1, 16384})}},
      {"/maxBounces", {0, 1000}},          {"/raysPerPixel", {1, 1000000000}},
      {"/materials/white/Kd/1", {0, 1}},   {"/materials/shiny/exponent", {0, 0.5, 1000000}},
      {"/shapes/2/emission/0", {0, 1e30}}, {"/shapes/5/transform/scale", {-1, 0.001}},
  };
  for (const auto& [place, values] : accepted) {
    for (const json& value : values) expectBoth(true, place, value);
  }
}

}  // namespace
}  // namespace pathmark
