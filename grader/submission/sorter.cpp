#include "submission/sorter.h"

#include "host/content_hash.h"
#include "scene/syntax_sentence.h"
#include "scene/utf8.h"
#include "submission/names.h"
#include "worker/contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>

namespace pathmark::submission {

namespace {

constexpr std::size_t kMostNotes = 20;
constexpr std::size_t kMostNearMisses = 5;
constexpr std::size_t kMostScenes = 32;  // each is rendered twice
constexpr std::size_t kMostNamed = 5;
constexpr std::size_t kLongestShown = 120;

constexpr double kMebibyte = 1 << 20;

// What the project has beside student/: coursework in it is not the student's.
constexpr std::array<std::string_view, 7> kProjectFolders{
    "framework", "solutions", "answers", "grader", "handouts", "scenes", "build"};

std::string joined(const std::vector<std::string>& path) {
  return shown(fmt::format("{}", fmt::join(path, "/")), kLongestShown);
}

// "a, b, c", or with many of them "a, b, c, d, e and 7 more".
std::string inOneList(const std::vector<std::string>& names) {
  const std::size_t named = std::min(names.size(), kMostNamed), more = names.size() - named;
  return fmt::format("{}{}", fmt::join(names.data(), names.data() + named, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

bool endsWith(const std::string& name, std::string_view ending) {
  return name.size() > ending.size() && lowerCase(name).ends_with(ending);
}

// Files that systems and editors leave behind, without a word.
bool isDebris(const std::vector<std::string>& path) {
  return std::any_of(path.begin(), path.end(), [](const std::string& piece) {
    return piece.starts_with('.') || piece == "__MACOSX";
  });
}

bool isArchiveName(const std::string& name) {
  return archiveStem(name) || endsWith(name, ".7z") || endsWith(name, ".rar") ||
         endsWith(name, ".gz") || endsWith(name, ".xz") || endsWith(name, ".zst");
}

bool isProjectFolder(const std::string& name) {
  return std::find(kProjectFolders.begin(), kProjectFolders.end(), name) != kProjectFolders.end();
}

bool isNearMiss(const std::vector<std::string>& path) {
  return looksLikePart(path.back()) && std::none_of(path.begin(), path.end(), isProjectFolder);
}

bool isSceneFile(const std::string& target) {
  return target.starts_with("scenes/") && endsWith(target, ".json");
}

bool isPlain(char c) {
  constexpr std::string_view kOthers = " ._-()+,";
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         kOthers.find(c) != std::string_view::npos;
}

bool holdsPlainOnly(std::string_view piece) {
  while (!piece.empty()) {
    const std::size_t bytes = isPlain(piece.front()) ? 1 : bytesOfNameLetter(piece);
    if (bytes == 0) return false;
    piece.remove_prefix(bytes);
  }
  return true;
}

// Names that scenes of any system can be written under, and that mean nothing to a shell.
bool isPlainName(const std::string& piece) {
  return !piece.starts_with('.') && !piece.starts_with('-') && !piece.starts_with(' ') &&
         !piece.ends_with(' ') && !piece.ends_with('.') && piece.size() <= 100 &&
         holdsPlainOnly(piece);
}

// Why an entry under the name of a coursework file is none; empty for a file.
std::string kindProblem(const Entry& entry) {
  switch (entry.kind) {
    case EntryKind::kFile:
      return entry.encrypted ? "is encrypted" : "";
    case EntryKind::kFolder:
      return "is a folder";
    case EntryKind::kSymbolicLink:
    case EntryKind::kHardLink:
      return "is a link, and links are not followed";
    case EntryKind::kOther:
      break;
  }
  return "is a pipe or a device";
}

}  // namespace

// The name as the contract spells it; empty if the file is none of the coursework's.
std::string Sorter::partName(const std::string& name) {
  for (const PartContract& part : parts())
    if (lowerCase(name) == part.file) return std::string(part.file);
  return {};
}

// The name below the folder of the coursework, which the first `below` pieces are; empty if the
// file is no scene's.
std::string Sorter::sceneName(const Path& path, std::size_t below) {
  if (path.size() < below + 2 || lowerCase(path[below]) != "scenes") return {};
  const bool direct = path.size() == below + 2;
  if (!(direct && endsWith(path.back(), ".json")) && !endsWith(path.back(), ".obj")) return {};
  const Path rest(path.begin() + static_cast<std::ptrdiff_t>(below) + 1, path.end());
  return fmt::format("scenes/{}", fmt::join(rest, "/"));
}

bool Sorter::mayBeOfAScene(const Path& path) {
  for (std::size_t below = 0; below + 1 < path.size(); ++below)
    if (!sceneName(path, below).empty()) return true;
  return false;
}

std::size_t Sorter::largest(const std::string& name) const {
  if (endsWith(name, ".obj")) return limits_.meshBytes;
  return endsWith(name, ".json") ? limits_.sceneBytes : limits_.codeBytes;
}

bool Sorter::isWanted(int part) const {
  return only_.empty() || std::find(only_.begin(), only_.end(), part) != only_.end();
}

bool Sorter::isWanted(const std::string& target) const {
  return only_.empty() ||
         std::any_of(parts().begin(), parts().end(), [&](const PartContract& part) {
           return part.file == target && isWanted(part.part);
         });
}

void Sorter::note(std::string sentence) { notes_.push_back(std::move(sentence)); }

void Sorter::noteAbout(const std::string& target, std::string sentence) {
  if (isWanted(target)) note(std::move(sentence));
}

void Sorter::noteRefusal(const std::string& target, std::string sentence) {
  if (isSceneFile(target)) refusedScenes_.push_back(sentence);
  noteAbout(target, std::move(sentence));
}

void Sorter::noteNearMisses() {
  std::size_t noted = 0;
  for (const std::string& name : nearMisses_) {
    const std::optional<int> part = numberOfPart(name.substr(name.rfind('/') + 1));
    if (part && !isWanted(*part)) {
      --ignored_;
      continue;
    }
    if (noted++ < kMostNearMisses)
      note(fmt::format("{} was ignored: this is not the name of a file of the coursework.", name));
  }
}

void Sorter::noteLeftOut(const std::vector<std::string>& scenes) {
  if (scenes.empty()) return;
  noteRefusal(scenes.front(),
              fmt::format("{} {} left out: of the scenes the first {} by name are taken.",
                          inOneList(scenes), scenes.size() == 1 ? "was" : "were", kMostScenes));
}

void Sorter::take(const Entry& entry, const ReadEntry& read) {
  if (++entries_ > limits_.entries)
    throw Refusal(fmt::format("it holds more than {} files and folders", limits_.entries));
  const EntryPath path = splitPath(entry.path, limits_);
  if (!path.problem.empty()) {
    note(fmt::format("{} was refused: it {}.", inQuotes(entry.path), path.problem));
    const std::size_t scenes = lowerCase(entry.path).find("scenes/");
    if (scenes != std::string::npos && isSceneFile("scenes/" + entry.path.substr(scenes + 7)))
      refusedScenes_.push_back(notes_.back());
    return;
  }
  if (path.pieces.empty()) return;
  const std::string& name = path.pieces.back();
  const bool isFolder = entry.kind == EntryKind::kFolder;
  if (isDebris(path.pieces)) return;
  if (!partName(name).empty() || mayBeOfAScene(path.pieces)) {
    keep(path.pieces, entry, read);
  } else if (isFolder) {
    return;
  } else if (entry.kind != EntryKind::kFile) {
    note(fmt::format("{} was refused: it {}.", joined(path.pieces), kindProblem(entry)));
  } else if (isArchiveName(name)) {
    note(fmt::format("{} was not opened: it is an archive within the submission.",
                     joined(path.pieces)));
    // The entries' order decides nothing.
    if (unopened_.empty() || notes_.back() < unopened_) unopened_ = notes_.back();
  } else {
    ++ignored_;
    if (isNearMiss(path.pieces)) nearMisses_.push_back(joined(path.pieces));
  }
}

void Sorter::keep(Path path, const Entry& entry, const ReadEntry& read) {
  Candidate candidate{std::move(path), kindProblem(entry), {}};
  if (candidate.problem.empty()) {
    const std::size_t most = largest(candidate.path.back());
    candidate.bytes = read(most + 1);
    if (candidate.bytes.size() > most) {
      candidate.problem =
          fmt::format("is larger than {:g} MiB", static_cast<double>(most) / kMebibyte);
      candidate.bytes = {};
    }
  }
  keptBytes_ += candidate.bytes.size();
  if (keptBytes_ > limits_.keptBytes)
    throw Refusal(fmt::format("its coursework files have more than {:g} MiB together",
                              static_cast<double>(limits_.keptBytes) / kMebibyte));
  candidates_.push_back(std::move(candidate));
}

// Where the coursework's own files lie. Compared with each file, they are looked up: there may be
// as many of them.
Sorter::Homes Sorter::homes() const {
  Homes found;
  for (const Candidate& candidate : candidates_) {
    if (partName(candidate.path.back()).empty()) continue;
    Path folder = candidate.folder();
    if (!folder.empty() && folder.back() == "student")
      found.projects.emplace(folder.begin(), folder.end() - 1);
    found.courseworks.insert(std::move(folder));
  }
  return found;
}

// Whether the file lies in another folder of a project whose student/ has been handed in as well.
bool Sorter::belongsToTheProject(const Path& folder, const Homes& homes) {
  for (auto top = folder.begin(); top != folder.end(); ++top)
    if (isProjectFolder(*top) && homes.projects.contains(Path(folder.begin(), top))) return true;
  return false;
}

// Whether the file lies in a lab, COURSEWORK/labs/NAME, of a coursework that has been handed in as
// well: labs are not marked.
bool Sorter::belongsToALab(const Path& folder, const Homes& homes) {
  return folder.size() >= 2 && folder[folder.size() - 2] == "labs" &&
         homes.courseworks.contains(Path(folder.begin(), folder.end() - 2));
}

std::string Sorter::sceneTarget(const Candidate& candidate, const std::set<Path>& folders) const {
  for (std::size_t below = 0; below < candidate.path.size(); ++below) {
    std::string name = sceneName(candidate.path, below);
    const auto top = candidate.path.begin();
    if (!name.empty() && folders.contains(Path(top, top + static_cast<std::ptrdiff_t>(below))))
      return name;
  }
  return {};
}

// One file, or several under its name: which of them is meant is not for luck to say.
void Sorter::decide(const std::string& target, const std::vector<const Candidate*>& candidates,
                    Collected& collected) {
  const Candidate& first = *candidates.front();
  const bool same = std::all_of(candidates.begin(), candidates.end(), [&](const Candidate* other) {
    return other->problem == first.problem && other->bytes == first.bytes;
  });
  if (!same) {
    std::set<std::string> places;
    for (const Candidate* candidate : candidates) places.insert(joined(candidate->path));
    noteRefusal(target,
                fmt::format("{} was refused: it was handed in {} times with different contents "
                            "({}).",
                            target, candidates.size(), inOneList({places.begin(), places.end()})));
    return;
  }
  if (!first.problem.empty()) {
    noteRefusal(target, fmt::format("{} was refused: it {}.", joined(first.path), first.problem));
    return;
  }
  if (candidates.size() > 1)
    noteAbout(target, fmt::format("{} was handed in {} times with the same contents.", target,
                                  candidates.size()));
  const std::string given = first.path.back();
  if (!partName(given).empty() && given != target)
    noteAbout(target, fmt::format("{} was renamed to {}.", joined(first.path), target));
  collected.files.emplace(target, first.bytes);
}

void Sorter::sayWhatIsMissing(const std::set<std::string>& seen, Collected& collected) {
  std::vector<std::string_view> asked, missing;
  for (const PartContract& part : parts()) {
    // Nobody misses a bonus part, but where it alone is asked for.
    if (!isWanted(part.part) || (part.bonus && only_.empty())) continue;
    asked.push_back(part.file);
    if (!seen.contains(std::string(part.file))) missing.push_back(part.file);
  }
  if (!missing.empty() && !seen.empty())
    note(fmt::format("{} {} missing.", fmt::join(missing, ", "),
                     missing.size() == 1 ? "is" : "are"));
  const bool anyPart = std::any_of(collected.files.begin(), collected.files.end(),
                                   [](const auto& file) { return !partName(file.first).empty(); });
  if (anyPart) return;
  const char* verb = seen.empty() ? "is" : "could be read";
  // The work is probably in there.
  if (seen.empty() && !unopened_.empty()) collected.failure = unopened_ + " ";
  collected.failure +=
      asked.size() == 1
          ? fmt::format(
                "Nothing was taken: neither {} nor another file of the coursework {} in it.",
                asked.front(), verb)
          : fmt::format("Nothing was taken: none of the files {} {} in it.", fmt::join(asked, ", "),
                        verb);
}

Collected Sorter::finish() {
  std::map<std::string, std::vector<const Candidate*>> byTarget;
  std::set<Path> folders;
  std::vector<const Candidate*> others;
  const Homes known = homes();
  for (const Candidate& candidate : candidates_) {
    const std::string name = partName(candidate.path.back());
    if (name.empty()) {
      others.push_back(&candidate);
    } else if (const Path folder = candidate.folder();
               belongsToTheProject(folder, known) || belongsToALab(folder, known)) {
      ++ignored_;
    } else {
      byTarget[name].push_back(&candidate);
      folders.insert(candidate.folder());
    }
  }
  std::set<std::string> seen;
  for (const auto& target : byTarget) seen.insert(target.first);

  // Scenes that differ only by capitals are one file in some file systems.
  std::map<std::string, std::vector<const Candidate*>> scenes;
  for (const Candidate* candidate : others) {
    const std::string name = sceneTarget(*candidate, folders);
    if (name.empty()) {
      ignored_ += candidate->problem == "is a folder" ? 0 : 1;
    } else if (!std::all_of(candidate->path.begin() + 1, candidate->path.end(), isPlainName)) {
      noteRefusal(
          name,
          fmt::format("{} was refused: names of scenes and meshes have letters (of all scripts), "
                      "digits, spaces and . _ - ( ) + , only.",
                      joined(candidate->path)));
    } else {
      scenes[lowerCase(name)].push_back(candidate);
    }
  }

  Collected collected;
  for (const auto& [target, candidates] : byTarget) decide(target, candidates, collected);
  std::vector<std::string> leftOut;
  std::size_t taken = 0;
  for (const auto& [lower, candidates] : scenes) {
    const std::string target = sceneTarget(*candidates.front(), folders);
    if (isSceneFile(target) && ++taken > kMostScenes)
      leftOut.push_back(target);
    else
      decide(target, candidates, collected);
  }
  noteLeftOut(leftOut);
  sayWhatIsMissing(seen, collected);

  noteNearMisses();
  if (ignored_ > 0)
    note(fmt::format("{} other {} ignored: only part*.cpp and scenes/ are taken.", ignored_,
                     ignored_ == 1 ? "file was" : "files were"));

  ContentHasher hasher;
  for (const auto& [name, bytes] : collected.files)
    hasher.add(fmt::format("{} {}\n{}", name, bytes.size(), bytes));
  collected.contents = hasher.digits();

  // What was handed in first is not what counts: a report must not depend on it.
  std::sort(notes_.begin(), notes_.end());
  std::sort(refusedScenes_.begin(), refusedScenes_.end());
  collected.remarks = std::move(notes_);
  collected.refusedScenes = std::move(refusedScenes_);
  if (collected.remarks.size() > kMostNotes) {
    const std::size_t more = collected.remarks.size() - kMostNotes;
    collected.remarks.resize(kMostNotes);
    collected.remarks.push_back(fmt::format("There are {} more remarks of this kind.", more));
  }
  return collected;
}

}  // namespace pathmark::submission
