#include "study/named_log.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace pathmark::study {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

NamedLog::NamedLog(fs::path file) : file_(std::move(file)) {
  fs::create_directories(file_.parent_path());
  std::ifstream in(file_);
  for (std::string line; std::getline(in, line);) {
    // The last line may have been cut off when a study was killed.
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("words")) continue;
    cases_[json["key"]] = {json["name"],    json["mistake"],      json["known"],
                           json["leftOut"], json["leftOutAlike"], json["words"]};
  }
}

std::optional<NamedCase> NamedLog::find(const std::string& key) const {
  const auto found = cases_.find(key);
  return found == cases_.end() ? std::nullopt : std::optional(found->second);
}

void NamedLog::add(const std::string& key, const NamedCase& named) {
  const Json json{
      {"key", key},           {"name", named.name},       {"mistake", named.mistake},
      {"known", named.known}, {"leftOut", named.leftOut}, {"leftOutAlike", named.leftOutAlike},
      {"words", named.words}};
  const std::lock_guard lock(mutex_);
  std::ofstream out(file_, std::ios::app);
  out << json.dump() << "\n" << std::flush;
  if (!out)
    throw std::system_error(errno, std::generic_category(),
                            fmt::format("writing {}", file_.string()));
}

}  // namespace pathmark::study
