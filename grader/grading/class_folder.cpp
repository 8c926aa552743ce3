#include "grading/class_folder.h"

#include "film/atomic_file.h"
#include "host/display_path.h"
#include "host/session.h"
#include "record/record_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>

#include <fcntl.h>
#include <sys/file.h>

namespace pathmark::grading {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr int kRunFormat = 1;

std::string readFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

// Nobody who is graded can guess it. It fits into the numbers of every JSON reader.
std::uint64_t newSeed() {
  std::random_device device;
  constexpr int kBits = 53;
  return ((std::uint64_t{device()} << 32) | device()) >> (64 - kBits);
}

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "submissions", error))
    if (fs::exists(entry.path() / "record.json")) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<record::SubmissionRecord> recordIn(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / "submissions" / name / "record.json";
  if (!fs::exists(file)) return std::nullopt;
  try {
    return record::readRecord(file);
  } catch (const record::RecordError&) {
    return std::nullopt;
  }
}

// What was left out has no marks that could become another's.
bool keepsItsName(const record::SubmissionRecord& known) {
  std::error_code error;
  return known.leftOut.empty() && !known.source.empty() && fs::exists(known.source, error);
}

std::string partsInWords(const std::vector<int>& parts, bool whole) {
  return whole ? "everything" : fmt::format("part {} only", fmt::join(parts, ", "));
}

}  // namespace

std::map<fs::path, std::string> gradedNames(const fs::path& folder) {
  std::map<fs::path, std::string> names;
  for (const std::string& name : namesIn(folder))
    if (const auto known = recordIn(folder, name);
        known && known->name == name && keepsItsName(*known))
      names.emplace(known->source, name);
  return names;
}

ClassFolder::ClassFolder(fs::path folder, const RunAsked& asked) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_ / "submissions", error);
  if (error)
    throw UsageError(
        fmt::format("{}: this folder cannot be made: {}.", displayPath(folder_), error.message()));
  lock();
  readOrWriteRun(asked);
  fs::remove_all(folder_ / ".work", error);
}

ClassFolder::~ClassFolder() {
  std::error_code ignored;
  fs::remove_all(folder_ / ".work", ignored);
}

void ClassFolder::lock() {
  lock_ = FileDescriptor(
      open((folder_ / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR));
  if (lock_.get() < 0)
    throw UsageError(fmt::format("{}: nothing can be written here: {}.", displayPath(folder_),
                                 std::generic_category().message(errno)));
  if (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0)
    throw UsageError(
        fmt::format("{}: another run is grading into this folder; wait for it, or "
                    "give another folder with --out.",
                    displayPath(folder_)));
}

void ClassFolder::readOrWriteRun(const RunAsked& asked) {
  const fs::path file = folder_ / "run.json";
  const Json known = Json::parse(readFile(file), nullptr, false);
  if (known.is_object() && known.contains("seed") && known.contains("parts")) {
    try {
      seed_ = known.at("seed");
      parts_ = known.at("parts").get<std::vector<int>>();
      whole_ = known.at("whole");
    } catch (const Json::exception&) {
      throw UsageError(fmt::format("{}: this file is damaged. Give another folder with --out.",
                                   displayPath(file)));
    }
    if (asked.seed && *asked.seed != seed_)
      throw UsageError(
          fmt::format("{} was graded with seed {}, and marks of different seeds do "
                      "not belong together: leave --seed out, or give another folder "
                      "with --out.",
                      displayPath(folder_), seed_));
    if (!asked.parts.empty() && (asked.parts != parts_ || asked.whole != whole_))
      throw UsageError(
          fmt::format("In {} {} was graded, and now {} is asked for: give another "
                      "folder with --out.",
                      displayPath(folder_), partsInWords(parts_, whole_),
                      partsInWords(asked.parts, asked.whole)));
    return;
  }
  if (!names().empty() || asked.parts.empty())
    throw UsageError(
        fmt::format("{}: run.json, which tells the seed and the parts of what was graded here, is "
                    "missing or damaged: give another folder with --out.",
                    displayPath(folder_)));
  seed_ = asked.seed ? *asked.seed : newSeed();
  parts_ = asked.parts;
  whole_ = asked.whole;
  writeFileAtomically(
      file,
      Json{{"format", kRunFormat}, {"seed", seed_}, {"parts", parts_}, {"whole", whole_}}.dump(1) +
          "\n");
}

std::vector<std::string> ClassFolder::names() const { return namesIn(folder_); }

fs::path ClassFolder::folderOf(const std::string& name) const {
  return folder_ / "submissions" / name;
}

std::optional<record::SubmissionRecord> ClassFolder::find(const std::string& name) const {
  return recordIn(folder_, name);
}

std::string ClassFolder::picture(const std::string& name, const std::string& file) const {
  return readFile(folderOf(name) / file);
}

fs::path ClassFolder::scratch(const std::string& name) const {
  fs::path folder = folder_ / ".work" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

void ClassFolder::removeScratch(const std::string& name) const {
  std::error_code ignored;
  fs::remove_all(folder_ / ".work" / name, ignored);
}

void ClassFolder::expectNoOther(const std::string& name, const std::string& source) const {
  const std::optional<record::SubmissionRecord> known = find(name);
  if (known && known->source != source && keepsItsName(*known))
    throw UsageError(
        fmt::format("{}: this is the record of {}, and that of {} would replace it: rename one of "
                    "them, give another folder with --out, or remove this one.",
                    displayPath(folderOf(name)), known->source, source));
}

void ClassFolder::put(const Judged& judged) const {
  const std::string& name = judged.record.name;
  expectNoOther(name, judged.record.source);
  const fs::path made = scratch(name + ".new"), place = folderOf(name);
  fs::create_directories(made / "pictures");
  for (const auto& [file, bytes] : judged.files) writeFileAtomically(made / file, bytes);
  record::writeRecord(judged.record, made / "record.json");
  fs::remove_all(place);
  fs::rename(made, place);
}

void ClassFolder::noteSource(record::SubmissionRecord record, const std::string& source) const {
  if (record.source == source) return;
  expectNoOther(record.name, source);
  record.source = source;
  record::writeRecord(record, folderOf(record.name) / "record.json");
}

void ClassFolder::removeRenamed(const std::map<std::string, std::string>& sources) const {
  for (const std::string& name : names()) {
    const std::optional<record::SubmissionRecord> known = find(name);
    if (!known) continue;
    const auto now = sources.find(known->source);
    if (now != sources.end() && now->second != name) fs::remove_all(folderOf(name));
  }
}

}  // namespace pathmark::grading
