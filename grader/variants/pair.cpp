#include "variants/pair.h"

#include "host/build_config.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

Pair pairOf(const Json& json, const fs::path& variants) {
  Pair pair;
  pair.name = json.at("name");
  pair.scene = json.at("scene");
  if (json.contains("maxBounces")) pair.maxBounces = json.at("maxBounces").get<int>();
  pair.warmUp = json.value("warmUp", false);
  for (const std::string patch : json.at("mistakes"))
    pair.mistakes.push_back(readVariant(variants / (patch + ".patch")));
  return pair;
}

}  // namespace

std::vector<Pair> allPairs() {
  const fs::path variants = fs::path(build::kProjectFolder) / "grader/variants";
  const fs::path file = variants / "pairs/pairs.json";
  std::ifstream in(file);
  try {
    std::vector<Pair> pairs;
    for (const Json& json : Json::parse(in)) pairs.push_back(pairOf(json, variants));
    return pairs;
  } catch (const Json::exception& e) {
    throw std::runtime_error(file.string() + ": " + e.what());
  }
}

}  // namespace pathmark
