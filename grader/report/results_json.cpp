#include "report/results_json.h"

#include "film/atomic_file.h"

#include <nlohmann/json.hpp>

namespace pathmark::report {

namespace {

using Json = nlohmann::ordered_json;

Json checkJson(const checks::CheckResult& result) {
  const checks::Finding& finding = result.finding;
  Json json{{"check", idOf(*result.check)},
            {"statement", result.check->statement},
            {"status", statusName(finding.status)},
            {"delta", result.check->delta},
            {"seconds", result.seconds},
            {"calls", finding.calls}};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) json[name] = value;
  };
  add("where", finding.where);
  add("expected", finding.expected);
  add("got", finding.got);
  add("tolerance", finding.tolerance);
  add("cause", finding.cause);
  add("evidence", finding.evidence);
  add("remark", finding.remark);
  if (finding.shown > 0.0) json["shown"] = finding.shown;
  return json;
}

}  // namespace

std::string statusName(checks::Status status) {
  switch (status) {
    case checks::Status::kPass:
      return "pass";
    case checks::Status::kFail:
      return "fail";
    case checks::Status::kUndecided:
      return "undecided";
    case checks::Status::kBroken:
      return "broken";
    case checks::Status::kNotWritten:
      return "not written";
    case checks::Status::kBlocked:
      break;
  }
  return "blocked";
}

std::string toJson(const checks::CourseworkResults& results) {
  Json json{{"seed", results.seed},
            {"seconds", results.seconds},
            {"statistics", results.statistics},
            {"parts", Json::array()}};
  for (const checks::PartResult& part : results.parts) {
    Json p{{"part", part.part.part}, {"file", part.part.file}};
    if (!part.failure.empty()) p["failure"] = part.failure;
    p["functions"] = Json::array();
    for (const checks::FunctionResult& f : part.functions) {
      Json function{{"section", f.function.section},
                    {"name", f.function.name},
                    {"status", statusName(f.status)},
                    {"checks", Json::array()}};
      for (const checks::CheckResult& r : f.checks) function["checks"].push_back(checkJson(r));
      if (!f.diagnosis.mistake.empty())
        function["diagnosis"] = {{"mistake", f.diagnosis.mistake},
                                 {"what", f.diagnosis.what},
                                 {"evidence", f.diagnosis.evidence},
                                 {"read", f.diagnosis.read}};
      p["functions"].push_back(std::move(function));
    }
    json["parts"].push_back(std::move(p));
  }
  json["images"] = Json::array();
  for (const checks::CheckResult& r : results.images) json["images"].push_back(checkJson(r));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeJson(const checks::CourseworkResults& results, const std::filesystem::path& file) {
  writeFileAtomically(file, toJson(results));
}

}  // namespace pathmark::report
