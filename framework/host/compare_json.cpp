#include "host/compare_report.h"

#include <nlohmann/json.hpp>

namespace pathmark {

namespace {

using Json = nlohmann::ordered_json;

Json imageJson(const std::filesystem::path& name, const ImageFile& file, const Flaws& flaws) {
  const ImageOrigin& origin = file.origin;
  return {{"file", name.string()},
          {"width", file.image.width},
          {"height", file.image.height},
          {"scene", origin.scene},
          {"sceneHash", origin.sceneHash},
          {"coursework", origin.coursework},
          {"raysPerPixel", origin.raysPerPixel},
          {"replicates", origin.replicates},
          // JSON numbers are doubles to many readers.
          {"seed", std::to_string(origin.seed)},
          {"sampler", origin.sampler},
          {"paths", origin.paths},
          {"hasVariance", !file.image.variance.empty()},
          {"invalidPixels", flaws.invalid},
          {"nanPixels", flaws.nan},
          {"infinitePixels", flaws.infinite},
          {"pixelsOfBrokenVariance", flaws.noVariance}};
}

// What is unknown is null, as are numbers that are not finite.
Json regionJson(const RegionResult& r, const Replicates& replicates, bool undecided) {
  const auto known = [](double value, bool is) { return is ? Json(value) : Json(nullptr); };
  return {{"left", r.region.left},
          {"top", r.region.top},
          {"width", r.region.width},
          {"height", r.region.height},
          {"channel", kChannelNames[static_cast<std::size_t>(r.channel)]},
          {"pixels", r.pixels},
          {"meanA", r.a},
          {"errorA", known(r.errorA, replicates.a > 0)},
          {"meanB", r.b},
          {"errorB", known(r.errorB, replicates.b > 0)},
          {"ratio", r.a / r.b},
          {"z", known(r.z, replicates.any())},
          {"p", known(r.pValue, replicates.any())},
          {"differs", undecided && r.differs ? Json(nullptr) : Json(r.differs)}};
}

}  // namespace

std::string compareJson(const CompareReport& report) {
  const Comparison& comparison = report.comparison;
  const CompareSettings& settings = report.settings;
  Json json{{"same", comparison.undecided ? Json(nullptr) : Json(comparison.same)},
            {"equal", comparison.equal},
            {"verdict", verdictSentence(report)},
            {"notes", compareNotes(report)},
            {"a", imageJson(report.names[0], report.files[0], comparison.pixels.a)},
            {"b", imageJson(report.names[1], report.files[1], comparison.pixels.b)},
            {"comparedPixels", comparison.pixels.count},
            {"differentValues", comparison.differentValues},
            {"mse", comparison.mse},
            {"relMse", comparison.relativeMse},
            {"tile", settings.tile},
            {"alpha", settings.alpha},
            {"alphaOfWhole", comparison.alphaOfWhole},
            {"alphaOfTile", comparison.alphaOfTile},
            {"within", settings.within ? Json(*settings.within) : Json(nullptr)}};
  const auto add = [&](const char* where, const std::vector<RegionResult>& regions) {
    json[where] = Json::array();
    for (const RegionResult& r : regions)
      json[where].push_back(regionJson(r, comparison.replicates, comparison.undecided));
  };
  add("whole", comparison.whole);
  add("furthestTiles", furthestTiles(comparison));
  json["pictures"] = Json::array();
  for (const ComparePicture& picture : report.pictures)
    json["pictures"].push_back(
        {{"file", picture.file.string()},
         {"fullColour", picture.fullColour > 0.0 ? Json(picture.fullColour) : Json(nullptr)}});
  // File names and scenes need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pathmark
