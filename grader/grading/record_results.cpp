#include "grading/record_results.h"

#include "host/build_config.h"
#include "host/display_path.h"
#include "report/terminal.h"
#include "scene/load_scene.h"

#include <algorithm>
#include <filesystem>

namespace pathmark::grading {

namespace {

using record::Verdict;

Verdict verdictOf(WorkerFault fault) {
  switch (fault) {
    case WorkerFault::kTimeLimit:
      return Verdict::kTimeLimit;
    case WorkerFault::kOutputLimit:
      return Verdict::kOutputLimit;
    case WorkerFault::kMemoryLimit:
      return Verdict::kMemoryLimit;
    case WorkerFault::kForbiddenCall:
      return Verdict::kForbiddenCall;
    case WorkerFault::kCrashed:
    case WorkerFault::kEnded:
      return Verdict::kCrashed;
    case WorkerFault::kNonsense:
      break;
  }
  return Verdict::kWrong;
}

Verdict verdictOf(const checks::Finding& finding) {
  switch (finding.status) {
    case checks::Status::kPass:
      return Verdict::kOk;
    case checks::Status::kFail:
      return Verdict::kWrong;
    case checks::Status::kUndecided:
      return Verdict::kUndecided;
    case checks::Status::kNotWritten:
      return Verdict::kNotWritten;
    case checks::Status::kBlocked:
      return Verdict::kBlocked;
    case checks::Status::kBroken:
      break;
  }
  return finding.fault ? verdictOf(*finding.fault) : Verdict::kCrashed;
}

record::FunctionRecord functionRecord(const checks::FunctionResult& function, std::uint64_t seed) {
  record::FunctionRecord record{std::string(function.function.section),
                                std::string(function.function.name),
                                Verdict::kOk,
                                {}};
  if (function.status == checks::Status::kNotWritten) record.verdict = Verdict::kNotWritten;
  for (const checks::CheckResult& result : function.checks) {
    record.checks.push_back(recordOf(result, seed));
    const Verdict verdict = record.checks.back().verdict;
    if (worseThan(verdict, record.verdict)) record.verdict = verdict;
  }
  record.mistake = function.diagnosis.mistake;
  record.what = function.diagnosis.what;
  record.evidence = function.diagnosis.evidence;
  return record;
}

// Of a part without results.
void tellFailure(record::PartRecord& part, const PartBuild& build,
                 const checks::PartResult* result) {
  if (!build.compiled) {
    part.verdict =
        std::filesystem::exists(build.source) ? Verdict::kDoesNotCompile : Verdict::kNotWritten;
    part.message = part.verdict == Verdict::kNotWritten ? "The file is not in the submission."
                                                        : build.messages;
  } else if (result != nullptr) {
    // One that is stopped while its constants are made has compiled.
    part.verdict = result->fault ? verdictOf(*result->fault) : Verdict::kDoesNotCompile;
    part.message = result->failure;
  } else {
    part.verdict = Verdict::kTimeLimit;
    part.message = "The time for the whole submission was up before this part was checked.";
  }
}

void remove(std::string& text, const std::string& what) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos;)
    text.erase(at, what.size());
}

}  // namespace

record::CheckRecord recordOf(const checks::CheckResult& result, std::uint64_t seed) {
  const checks::Finding& finding = result.finding;
  record::CheckRecord record;
  record.id = idOf(*result.check);
  record.statement = result.check->statement;
  record.verdict = verdictOf(finding);
  record.where = finding.where;
  record.expected = finding.expected;
  record.got = finding.got;
  record.tolerance = finding.tolerance;
  record.cause = finding.cause;
  record.evidence = finding.evidence;
  record.remark = finding.remark;
  for (const report::Field& field : report::fieldsOf(result))
    if (field.name == "read") record.read = field.value;
  record.repeat = report::repeatCommand(result, seed, "student");
  record.delta = result.check->delta;
  record.shown = finding.shown;
  record.calls = finding.calls;
  record.seconds = result.seconds;
  return record;
}

std::vector<record::PartRecord> recordParts(const checks::CourseworkResults& results,
                                            const CourseworkBuild& build,
                                            const std::vector<int>& selected) {
  std::vector<record::PartRecord> parts;
  for (const int number : selected) {
    const PartBuild& built = build.parts.at(placeOfPart(number));
    record::PartRecord part;
    part.part = number;
    part.file = built.part.file;
    part.title = built.part.title;
    const auto found =
        std::find_if(results.parts.begin(), results.parts.end(),
                     [&](const checks::PartResult& r) { return r.part.part == number; });
    const checks::PartResult* result = found == results.parts.end() ? nullptr : &*found;
    if (built.part.bonus && (result == nullptr || isBonusNotBegun(*result))) continue;
    if (result == nullptr || !result->failure.empty()) {
      tellFailure(part, built, result);
    } else {
      for (const checks::FunctionResult& f : result->functions) {
        part.functions.push_back(functionRecord(f, results.seed));
        if (worseThan(part.functions.back().verdict, part.verdict))
          part.verdict = part.functions.back().verdict;
      }
      part.message = built.messages;
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<record::CheckRecord> recordImages(const checks::CourseworkResults& results) {
  std::vector<record::CheckRecord> images;
  for (const checks::CheckResult& result : results.images)
    images.push_back(recordOf(result, results.seed));
  return images;
}

std::vector<record::SceneRecord> recordScenes(const checks::CourseworkResults& results) {
  std::vector<record::SceneRecord> scenes;
  for (const checks::SceneFinding& finding : results.scenes) {
    record::SceneRecord scene;
    scene.file = finding.file.filename().string();
    scene.message = finding.message;
    scene.noise = finding.noise;
    checks::Finding asFinding;
    asFinding.status = finding.status;
    scene.verdict = verdictOf(asFinding);
    try {
      scene.caption = loadScene(finding.file).caption;
    } catch (const SceneError&) {
      // What is wrong with it is its message.
    }
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

void forgetFolder(record::SubmissionRecord& record, const std::filesystem::path& folder) {
  const std::string whole = std::filesystem::absolute(folder).lexically_normal().string() + "/",
                    shown = displayPath(folder) + "/",
                    program = std::string(build::kProjectFolder) + "/";
  const auto clean = [&](std::string& text) {
    for (const std::string& path : {whole, shown, program}) remove(text, path);
  };
  const auto cleanCheck = [&](record::CheckRecord& check) {
    for (std::string* text : {&check.where, &check.expected, &check.got, &check.cause})
      clean(*text);
  };
  const auto cleanPictures = [&](std::vector<record::PictureRecord>& pictures) {
    for (record::PictureRecord& picture : pictures) clean(picture.failure);
  };
  for (record::PartRecord& part : record.parts) {
    clean(part.message);
    cleanPictures(part.pictures);
    for (record::FunctionRecord& function : part.functions)
      for (record::CheckRecord& check : function.checks) cleanCheck(check);
  }
  for (record::CheckRecord& image : record.images) cleanCheck(image);
  for (record::SceneRecord& scene : record.scenes) clean(scene.message);
  cleanPictures(record.pictures);
  clean(record.printed);  // a failed assertion says its file
}

}  // namespace pathmark::grading
