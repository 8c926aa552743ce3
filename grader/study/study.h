// The grader's own test: the checks under many seeds, of coursework that is known to be right or
// wrong.
//
//   StudySubject   the solutions, or a variant of them
//   StudyRecord    what the checks said of a subject under one seed
//   StudyLog       the records in a file, one JSON object a line, so that a study can go on later
//   runStudy       makes the records that are missing
#pragma once

#include "checks/runner.h"
#include "variants/variant.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::study {

struct StudySubject {
  std::string name;                // "solutions", or the variant's
  std::optional<Variant> variant;  // none: the solutions
  checks::Selection selection;     // of its checks
  CourseworkBuild build;
};

struct StudyRecord {
  std::string subject;
  std::uint64_t seed = 0;
  std::vector<std::string> failed;  // ids of checks that failed or broke, in their order
  std::vector<std::string> undecided;
  // Of the check that must find the mistake; where that did not fail, of the first that did.
  std::string cause;
  std::uint64_t calls = 0;
  double checkSeconds = 0.0;
  // The largest distance from what is right, in the smallest errors that a check finds, and the
  // check; 0 where one without statistics failed.
  double distance = 0.0;
  std::string farthest;
  std::int64_t statistics = 0;
  double seconds = 0.0;
};

// Of the program that is running: another build of it may judge differently.
const std::string& programHash();

class StudyLog {
 public:
  // Records made by another build of the grader, or of another version of a subject, are kept in
  // the file and left out. Throws std::system_error.
  explicit StudyLog(std::filesystem::path file);

  std::optional<StudyRecord> find(const std::string& key, std::uint64_t seed) const;

  // Appended to the file at once. May be called from several threads.
  void add(const std::string& key, const StudyRecord& record);

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  std::map<std::pair<std::string, std::uint64_t>, StudyRecord> records_;
};

// The solutions with all functions, or with all pictures.
StudySubject solutionsSubject(bool images);

// A variant with the checks of its part: those of the other parts run in the same program as the
// solutions'. Of a correct one, only functions that its change may reach: what the others do is the
// solutions', bit for bit. With `images`, the pictures too.
StudySubject variantSubject(const Variant& variant, bool images,
                            const std::filesystem::path& scratch);

struct StudyProgress {
  std::size_t done = 0, all = 0;
  double secondsLeft = 0.0;  // about
};

// Records in the order subject by subject, seed by seed. `goOn` is asked before each; if it says
// no, what is missing stays missing.
std::vector<StudyRecord> runStudy(const std::vector<StudySubject>& subjects, int seeds,
                                  unsigned threads, StudyLog& log,
                                  const std::function<bool(const StudyProgress&)>& goOn);

}  // namespace pathmark::study
