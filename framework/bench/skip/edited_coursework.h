// EditedCoursework: a copy of a coursework with one passage replaced, gone afterwards.
#pragma once

#include "host/session.h"

#include <memory>
#include <string>

namespace pathmark::bench {

struct Edit {
  std::string file, passage, replacement;
};

class EditedCoursework {
 public:
  // Nothing if the passage is not in the file. Throws CourseworkError if the copy does not compile.
  static std::unique_ptr<EditedCoursework> make(const Coursework& from, const Edit& edit);
  ~EditedCoursework();
  EditedCoursework(const EditedCoursework&) = delete;
  EditedCoursework& operator=(const EditedCoursework&) = delete;

  const Coursework& coursework() const { return coursework_; }

 private:
  EditedCoursework() = default;

  std::filesystem::path folder_;
  Coursework coursework_;
};

}  // namespace pathmark::bench
