#include "grading/class_folder.h"

#include "film/atomic_file.h"
#include "host/display_path.h"
#include "host/session.h"
#include "record/record_json.h"
#include "submission/names.h"
#include "worker/contract.h"

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

// What is under way. In it a submission has a folder of its name, and no name begins with a dot.
constexpr const char* kWork = ".work";
constexpr const char* kMade = ".made";          // records that are about to appear
constexpr const char* kReplaced = ".replaced";  // those that they replace

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
  std::sort(names.begin(), names.end(), submission::naturalLess);
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

// Nothing if the file is missing or damaged.
std::optional<Run> readRun(const fs::path& file) {
  try {
    const Json known = Json::parse(readFile(file));
    return Run{known.at("seed").get<std::uint64_t>(), known.at("parts").get<std::vector<int>>(),
               known.at("whole").get<bool>()};
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::vector<int> allParts() {
  std::vector<int> numbers;
  for (const PartContract& part : parts()) numbers.push_back(part.part);
  return numbers;
}

// What a record was made with. Nothing if it does not tell: it has no parts where nothing could be
// graded, or where of a bonus part alone nothing is written.
std::optional<Run> runOf(const record::SubmissionRecord& record) {
  if (!record.hasMarks() || record.parts.empty()) return std::nullopt;
  // Only where the whole was graded are there pictures of it, and bonus parts may be missing then.
  if (!record.pictures.empty()) return Run{record.seed, allParts(), true};
  Run run{record.seed, {}, false};
  for (const record::PartRecord& part : record.parts) run.parts.push_back(part.part);
  return run;
}

std::string partsInWords(const std::vector<int>& parts, bool whole) {
  return whole ? "everything" : fmt::format("part {} only", fmt::join(parts, ", "));
}

}  // namespace

bool holdsGrades(const fs::path& folder) {
  return fs::exists(folder / "run.json") || !namesIn(folder).empty();
}

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
  endWork();
  readOrWriteRun(asked);
}

ClassFolder::~ClassFolder() { endWork(); }

// A run that was killed between the two steps of `put` has left a submission without its folder.
void ClassFolder::endWork() const {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_ / kWork / kReplaced, ignored)) {
    const fs::path place = folderOf(entry.path().filename().string());
    if (fs::exists(entry.path() / "record.json", ignored) && !fs::exists(place, ignored))
      fs::rename(entry.path(), place, ignored);
  }
  fs::remove_all(folder_ / kWork, ignored);
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
  if (const std::optional<Run> known = readRun(file)) {
    run_ = *known;
    expectSame(asked);
    return;
  }
  const bool isNew = names().empty();
  if (isNew && asked.parts.empty()) refuseWithoutRun("and there is no record here");
  if (isNew) {
    run_ = {asked.seed ? *asked.seed : newSeed(), asked.parts, asked.whole};
  } else {
    run_ = runOfRecords(asked);
    expectSame(asked);
  }
  // Marks can be made anew without the parts, and the next run may ask for some.
  if (run_.parts.empty()) return;
  writeFileAtomically(
      file,
      Json{
          {"format", kRunFormat}, {"seed", run_.seed}, {"parts", run_.parts}, {"whole", run_.whole}}
              .dump(1) +
          "\n");
}

void ClassFolder::expectSame(const RunAsked& asked) const {
  if (asked.seed && *asked.seed != run_.seed)
    throw UsageError(
        fmt::format("{} was graded with seed {}, and marks of different seeds do "
                    "not belong together: leave --seed out, or give another folder "
                    "with --out.",
                    displayPath(folder_), run_.seed));
  if (!asked.parts.empty() && (asked.parts != run_.parts || asked.whole != run_.whole))
    throw UsageError(
        fmt::format("In {} {} was graded, and now {} is asked for: give another "
                    "folder with --out.",
                    displayPath(folder_), partsInWords(run_.parts, run_.whole),
                    partsInWords(asked.parts, asked.whole)));
}

// Of what was left out only the seed is known: its parts are those that are asked for, if any.
Run ClassFolder::runOfRecords(const RunAsked& asked) const {
  std::optional<std::uint64_t> seed;
  std::optional<Run> run;
  for (const std::string& name : names()) {
    const std::optional<record::SubmissionRecord> record = find(name);
    if (!record) continue;
    const std::optional<Run> said = runOf(*record);
    if ((seed && *seed != record->seed) || (run && said && !(*run == *said)))
      refuseWithoutRun("and the records here are not all of the same seed and parts");
    seed = record->seed;
    if (said) run = said;
  }
  if (!seed) refuseWithoutRun("and no record here can be read");
  return run ? *run : Run{*seed, asked.parts, asked.whole};
}

void ClassFolder::refuseWithoutRun(const char* why) const {
  throw UsageError(
      fmt::format("{}: run.json, which tells the seed and the parts of what was graded here, is "
                  "missing or damaged, {}: give another folder with --out.",
                  displayPath(folder_), why));
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

fs::path ClassFolder::scratch(const fs::path& name) const {
  fs::path folder = folder_ / kWork / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

void ClassFolder::removeScratch(const std::string& name) const {
  std::error_code ignored;
  fs::remove_all(folder_ / kWork / name, ignored);
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
  const fs::path made = scratch(fs::path(kMade) / name), place = folderOf(name);
  fs::create_directories(made / "pictures");
  for (const auto& [file, bytes] : judged.files) writeFileAtomically(made / file, bytes);
  record::writeRecord(judged.record, made / "record.json");
  const fs::path replaced = scratch(fs::path(kReplaced) / name);
  if (fs::exists(place)) fs::rename(place, replaced);
  fs::rename(made, place);
  fs::remove_all(replaced);
}

void ClassFolder::noteHandedIn(record::SubmissionRecord record, const std::string& source,
                               const submission::Collected& collected) const {
  if (record.source == source && record.collecting == collected.remarks &&
      record.refusedScenes == collected.refusedScenes)
    return;
  expectNoOther(record.name, source);
  record.source = source;
  record.collecting = collected.remarks;
  record.refusedScenes = collected.refusedScenes;
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
