// SmallProject: some of the project's files, with a contents.txt of their own, in which a test can
// put what must not be in a kit.
#pragma once

#include "kit/kit_plan.h"
#include "kit/write_kit.h"
#include "support/test_coursework_files.h"

#include <filesystem>
#include <string>

namespace pathmark::test {

class SmallProject {
 public:
  SmallProject();

  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path destination() const { return outside_ / "kit"; }
  std::filesystem::path inKit(const std::string& name) const { return destination() / name; }

  void write(const std::string& name, const std::string& content) const;
  void append(const std::string& name, const std::string& content) const;
  void copy(const std::string& from, const std::string& to) const;  // within the project
  std::string read(const std::string& name) const;

  kit::WrittenKit makeKit(int releasedThrough = kit::kNothingReleased) const;

  // No kit is there, nor anything half; and of the findings one has these words.
  void expectRefused(const std::string& words) const;

 private:
  TemporaryFolder folder_, outside_;
};

}  // namespace pathmark::test
