// makeSampleClass: the submissions of a class that does not exist, for `pathmark demo` and for
// trying a grader: what is right, half done, wrong, broken and malicious.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace pathmark {

enum class SamplePacking { kFolder, kZip, kTarGz };

struct SampleSubmission {
  std::string_view name;
  // Below grader/, a change of the solutions; empty for the solutions as they are.
  std::string_view patch;
  int partsWritten;  // those from there on are the stubs of student/
  bool hasScene;     // of part 7
  SamplePacking packing;
};

const std::vector<SampleSubmission>& sampleClass();

// Into `folder`, which is made: a folder or an archive for each. Throws std::runtime_error or
// std::system_error.
void makeSampleClass(const std::filesystem::path& folder);

}  // namespace pathmark
