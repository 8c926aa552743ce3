#include "bench/error_report.h"

#include <nlohmann/json.hpp>

namespace pathmark::bench {

namespace {

using Json = nlohmann::ordered_json;

Json intervalJson(const Interval& i) {
  return {{"value", i.value}, {"low", i.low}, {"high", i.high}};
}

Json pointJson(const PointSummary& p) {
  return {{"raysPerPixel", p.raysPerPixel},
          {"replicates", p.replicates},
          {"cpuSeconds", intervalJson(p.cpuSeconds)},
          {"mse", intervalJson(p.mse)},
          {"relativeMse", intervalJson(p.relativeMse)},
          {"efficiency", intervalJson(p.efficiency)},
          {"worstShare", intervalJson(p.worstShare)},
          {"meanDeviation", intervalJson(p.mean)}};
}

Json curveJson(const CurveSummary& curve) {
  Json points = Json::array();
  for (const PointSummary& p : curve.points) points.push_back(pointJson(p));
  return {{"estimator", curve.estimator},
          {"sampler", curve.sampler},
          {"slope", intervalJson(curve.slope)},
          {"points", std::move(points)}};
}

Json sceneJson(const SceneSummary& scene) {
  Json curves = Json::array();
  for (const CurveSummary& c : scene.curves) curves.push_back(curveJson(c));
  return {{"scene", scene.scene},
          {"reference",
           {{"relativeMse", scene.reference.relativeMse},
            {"relativeMseError", scene.reference.relativeMseError}}},
          {"curves", std::move(curves)}};
}

Json runJson(const ErrorRun& run) {
  return {{"scene", run.point.scene},
          {"estimator", run.point.estimator},
          {"sampler", run.point.sampler},
          {"raysPerPixel", run.point.raysPerPixel},
          {"replicate", run.replicate},
          {"cpuSeconds", run.cpuSeconds},
          {"mse", run.deviation.mse},
          {"relativeMse", run.deviation.relativeMse},
          {"worstShare", run.deviation.worstShare},
          {"meanDeviation", run.deviation.mean}};
}

}  // namespace

// Numbers that are not finite become null, which is what JSON has for them.
std::string errorsJson(const ErrorFindings& findings, const std::vector<ErrorRun>& runs,
                       const std::string& machine) {
  Json json{{"command", "bench error"}, {"machine", machine}, {"complete", !findings.interrupted}};
  json["scenes"] = Json::array();
  for (const SceneSummary& scene : findings.scenes) json["scenes"].push_back(sceneJson(scene));
  json["runs"] = Json::array();
  for (const ErrorRun& run : runs) json["runs"].push_back(runJson(run));
  json["notes"] = findings.notes;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pathmark::bench
