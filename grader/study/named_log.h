// NamedLog: what the diagnosis said of files, in a file of its own, one JSON object a line, so that
// what has not changed is not asked again.
#pragma once

#include "study/named_case.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace pathmark::study {

class NamedLog {
 public:
  // Throws std::system_error.
  explicit NamedLog(std::filesystem::path file);

  std::optional<NamedCase> find(const std::string& key) const;

  // Appended to the file at once. May be called from several threads.
  void add(const std::string& key, const NamedCase& named);

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  std::map<std::string, NamedCase> cases_;
};

}  // namespace pathmark::study
