// ClassFolder: the folder that a class is graded into, and what earlier runs have left there.
//
//   DIR/run.json                       the seed and what was asked for
//   DIR/rubric.json                    by what it was marked, if not by the project's own
//   DIR/submissions/NAME/record.json   one record, with pictures/ and reports beside it
//   DIR/.work                          what is under way
//
// A submission's folder appears whole, and what it replaces is kept until then: a run that is
// killed leaves whole records only, and loses none.
#pragma once

#include "grading/judge.h"
#include "host/shared_memory.h"
#include "record/record.h"
#include "submission/submission.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::grading {

struct RunAsked {
  std::optional<std::uint64_t> seed;  // by default the folder's, or a new one
  std::vector<int> parts;             // none: those that the folder was graded with
  bool whole = true;
};

// What all of a folder was graded with.
struct Run {
  std::uint64_t seed = 0;
  std::vector<int> parts;
  bool whole = true;

  bool operator==(const Run&) const = default;
};

// Whether anything was graded into this folder, which may be missing.
bool holdsGrades(const std::filesystem::path& folder);

// By the source of each graded submission of this folder its name, where the source is still there:
// one that is gone has been handed in anew, or moved. The folder itself may be missing.
std::map<std::filesystem::path, std::string> gradedNames(const std::filesystem::path& folder);

class ClassFolder {
 public:
  // Makes the folder where it is missing, and run.json too, from the records where there are some.
  // One run at a time: throws UsageError if another one is at work there, if the folder was graded
  // with another seed or other parts, or if these cannot be known any more.
  ClassFolder(std::filesystem::path folder, const RunAsked& asked);

  ~ClassFolder();
  ClassFolder(const ClassFolder&) = delete;
  ClassFolder& operator=(const ClassFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }
  std::uint64_t seed() const { return run_.seed; }
  const std::vector<int>& parts() const { return run_.parts; }
  bool whole() const { return run_.whole; }

  // Names of all submissions that have a record, in natural order.
  std::vector<std::string> names() const;

  std::filesystem::path folderOf(const std::string& name) const;

  // Nothing if there is none that can be read.
  std::optional<record::SubmissionRecord> find(const std::string& name) const;

  // Bytes of one of its pictures; empty if it is not there.
  std::string picture(const std::string& name, const std::string& file) const;

  // An empty folder for something that is under way.
  std::filesystem::path scratch(const std::filesystem::path& name) const;
  void removeScratch(const std::string& name) const;

  // Throws UsageError where that name is the one of another source, by gradedNames.
  void expectNoOther(const std::string& name, const std::string& source) const;

  // Replaces what there is of this submission. Throws as expectNoOther, or ImageError or
  // std::filesystem_error.
  void put(const Judged& judged) const;

  // The same files were handed in otherwise by now: at another place, beside other files that were
  // not taken. Throws as put.
  void noteHandedIn(record::SubmissionRecord record, const std::string& source,
                    const submission::Collected& collected) const;

  // Of sources that have a new name: what there is under others. `sources` leads from each to its
  // name.
  void removeRenamed(const std::map<std::string, std::string>& sources) const;

 private:
  void lock();
  void endWork() const;
  void readOrWriteRun(const RunAsked& asked);
  void expectSame(const RunAsked& asked) const;
  Run runOfRecords(const RunAsked& asked) const;
  [[noreturn]] void refuseWithoutRun(const char* why) const;

  std::filesystem::path folder_;
  FileDescriptor lock_;
  Run run_;
};

}  // namespace pathmark::grading
