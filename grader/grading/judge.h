// Judge: from a submission's files to its record.
//
//   Judge         what all submissions of a class share: the solutions, scenes, the sandbox
//   Judge::judge  one submission
#pragma once

#include "grading/mistake_pictures.h"
#include "host/confinement.h"
#include "host/coursework_builder.h"
#include "host/interrupt.h"
#include "marking/pictures.h"
#include "record/record.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pathmark::grading {

struct JudgeOptions {
  std::uint64_t seed = 1;
  std::vector<int> parts{0, 1, 2, 3, 4, 5, 6};
  bool whole = true;  // pictures of all parts together, and scenes
  // By the clock, for a submission, from compiling to its last picture.
  double secondsAtMost = 600.0;
};

struct Judged {
  record::SubmissionRecord record;
  std::map<std::string, std::string> files;  // pictures by the names in the record
};

// How far a submission is, in [0,1]; returns whether to go on.
using OnProgress = std::function<bool(double fraction)>;

class Judge {
 public:
  // Compiles the solutions. Throws std::runtime_error if they do not compile.
  Judge(JudgeOptions options, std::shared_ptr<Confinement> confinement);

  // The coursework files are in `folder`, and nothing else. The same files give the same record,
  // seconds aside, for any number of threads. Several may be judged at the same time. Throws
  // Interrupted, where OnProgress said no too: there is nothing to record. Anything else that is
  // thrown is an error of the grader or the machine.
  Judged judge(const std::filesystem::path& folder, unsigned threads, const OnProgress& onProgress);

 private:
  class Session;

  JudgeOptions options_;
  std::shared_ptr<Confinement> confinement_;
  CourseworkBuild solutions_;
  std::filesystem::path solvedWorker_;
  std::map<int, std::vector<marking::MarkingScene>> scenes_;
  std::vector<marking::MarkingScene> wholeScenes_;
  std::unique_ptr<marking::SolvedPictures> solved_;
  std::unique_ptr<MistakePictures> mistakes_;
};

}  // namespace pathmark::grading
