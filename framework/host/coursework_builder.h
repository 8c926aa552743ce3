// buildCoursework: from a folder of coursework files to a worker program.
//
// Only the expected file names are compiled, each by itself, from the bytes that were read once;
// other files of the folder cannot be included; what a lab (lab.h) does not change is taken from
// the coursework that it belongs to. Objects and workers are kept by the hash of what they were
// made from, so that only what changed is compiled again. The warnings are kept beside the object:
// they are said until their cause is mended.
#pragma once

#include "host/confinement.h"
#include "worker/contract.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark {

struct PartBuild {
  PartContract part;
  std::filesystem::path source;
  std::filesystem::path object;  // empty if it could not be compiled
  bool compiled = false;
  std::string messages;  // the compiler's warnings, or why the part could not be compiled
  bool absent = false;   // a bonus part without a file: the framework's stubs stand in for it
  bool missing = false;  // any other part without a file

  // Of a part that could not be compiled: "does not compile" or "is missing"; and a sentence, with
  // the compiler's words.
  std::string_view problem() const;
  std::string failure() const;

  // What the compiler warns of in a part that was compiled; empty if nothing.
  std::string_view warnings() const;
};

struct CourseworkBuild {
  std::filesystem::path folder;
  std::vector<PartBuild> parts;
  std::filesystem::path worker;  // empty if it could not be made
  std::string linkMessages;      // empty if all functions were found

  // In which it was compiled, all its workers are linked, and they must run; often none.
  std::shared_ptr<Confinement> confinement;

  bool complete() const;        // every part compiled
  std::string failure() const;  // sentences about what did not, with the compiler's words
};

enum class Incomplete {
  kCompileOnly,   // no worker, complete or not
  kNoWorker,      // a part that does not compile: no worker
  kLeaveThemOut,  // a worker without those parts, good for asking which stubs are left
};

// As many compilers at the same time as the machine has processors.
inline constexpr unsigned kOnePerProcessor = 0;

// Throws std::system_error if the compiler cannot be run, or is killed by the machine, or the build
// folder not be written; ConfinementError; and Interrupted, if this process is.
CourseworkBuild buildCoursework(const std::filesystem::path& folder,
                                Incomplete policy = Incomplete::kNoWorker,
                                std::shared_ptr<Confinement> confinement = {},
                                unsigned compilersAtMost = kOnePerProcessor);

// One file alone, outside of any confinement, for a folder of which only this part is of interest.
// Throws as buildCoursework does.
PartBuild compilePart(const std::filesystem::path& folder, int part);

struct LinkedWorker {
  std::filesystem::path worker;  // empty if it could not be made
  std::string failure;           // why: sentences with the linker's words
};

// A worker with some parts of the coursework, which have been compiled, and with stand-ins for the
// others: what is wrong in another part cannot show in it. Throws as buildCoursework does.
LinkedWorker linkWithStandIns(const CourseworkBuild& build, std::span<const int> parts);

// A worker with some parts of one coursework, and all others of another one, such as the solutions.
// Throws as buildCoursework does.
LinkedWorker linkWithOthers(const CourseworkBuild& build, std::span<const int> parts,
                            const CourseworkBuild& others);

// A worker that also says what happens on the paths (WorkerProcess::recordPaths): the same objects,
// and more of the framework's, through which the linker leads the calls between them. Throws as
// buildCoursework does.
LinkedWorker linkForRecording(const CourseworkBuild& build);

// The folder meant by --with: "student" and "solutions" are the project's own.
std::filesystem::path courseworkFolder(const std::string& with);

}  // namespace pathmark
