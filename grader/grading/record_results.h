// From what the checks found to what is recorded.
#pragma once

#include "checks/results.h"
#include "host/coursework_builder.h"
#include "record/record.h"

#include <filesystem>
#include <vector>

namespace pathmark::grading {

record::CheckRecord recordOf(const checks::CheckResult& result, std::uint64_t seed);

// All selected parts, those that could not be checked included. Of a part that is not among the
// results the checks were stopped: the time was up.
std::vector<record::PartRecord> recordParts(const checks::CourseworkResults& results,
                                            const CourseworkBuild& build,
                                            const std::vector<int>& selected);

std::vector<record::CheckRecord> recordImages(const checks::CourseworkResults& results);

std::vector<record::SceneRecord> recordScenes(const checks::CourseworkResults& results);

// Takes the name of the folder that the coursework was compiled in out of all sentences, and of
// what it printed: it means nothing to anybody.
void forgetFolder(record::SubmissionRecord& record, const std::filesystem::path& folder);

}  // namespace pathmark::grading
