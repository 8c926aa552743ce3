#include "scene/syntax_sentence.h"
#include "submission/names.h"
#include "submission/read_archive.h"
#include "submission/read_folder.h"
#include "submission/submission.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <system_error>

namespace pathmark::submission {

namespace fs = std::filesystem;

namespace {

constexpr int kMostWrappers = 8;
constexpr std::size_t kMostEntries = 10'000;

bool isHidden(const std::string& name) { return name.starts_with('.') || name == "__MACOSX"; }

bool holdsPart(const std::vector<FolderEntry>& entries) {
  return std::any_of(entries.begin(), entries.end(), [](const FolderEntry& entry) {
    return std::any_of(parts().begin(), parts().end(), [&](const PartContract& part) {
      return lowerCase(entry.name) == part.file;
    });
  });
}

bool isArchive(const FolderReader& folder, const FolderEntry& entry) {
  if (entry.kind != EntryKind::kFile || isHidden(entry.name)) return false;
  return archiveStem(entry.name) ||
         looksLikeArchive(folder.read(entry.name, kMagicBytes).value_or(std::string()));
}

// Directly, in student/, or below folders beside which there is neither another nor an archive.
bool isSubmission(const FolderReader& folder, int wrappers = 0) {
  const std::vector<FolderEntry> entries = folder.list(kMostEntries);
  if (holdsPart(entries)) return true;
  std::vector<std::string> folders;
  for (const FolderEntry& entry : entries)
    if (entry.kind == EntryKind::kFolder && !isHidden(entry.name)) folders.push_back(entry.name);
  const auto student = std::find(folders.begin(), folders.end(), "student");
  if (student != folders.end()) {
    const std::optional<FolderReader> below = folder.openFolder(*student);
    if (below && holdsPart(below->list(kMostEntries))) return true;
  }
  if (folders.size() != 1 || wrappers == kMostWrappers) return false;
  for (const FolderEntry& entry : entries)
    if (isArchive(folder, entry)) return false;
  const std::optional<FolderReader> below = folder.openFolder(folders.front());
  return below && isSubmission(*below, wrappers + 1);
}

std::string nameOf(const fs::path& source, bool archive) {
  const std::string name = source.filename().string();
  return safeName(archive ? archiveStem(name).value_or(name) : name);
}

std::string quoted(const fs::path& path) { return inQuotes(path.string()); }

class Finder {
 public:
  explicit Finder(bool onlyOnePath) : onlyOnePath_(onlyOnePath) {}

  void path(const fs::path& given) {
    std::error_code error;
    const fs::path real = fs::canonical(given, error);
    if (error) {
      found_.remarks.push_back(fmt::format("{}: there is no such file or folder.", given.string()));
    } else if (fs::is_directory(real)) {
      folder(real);
    } else {
      file(real);
    }
  }

  FoundSubmissions finish() {
    auto& all = found_.submissions;
    std::sort(all.begin(), all.end(), [](const Submission& a, const Submission& b) {
      return a.name != b.name ? naturalLess(a.name, b.name)
                              : naturalLess(a.source.string(), b.source.string());
    });
    UniqueNames names;
    for (Submission& one : all) one.name = names.unique(one.name);
    // -2 may have moved behind another's name.
    std::sort(all.begin(), all.end(),
              [](const Submission& a, const Submission& b) { return naturalLess(a.name, b.name); });
    return std::move(found_);
  }

 private:
  void add(const fs::path& source, const std::string& name, bool archive) {
    if (sources_.insert(source).second) found_.submissions.push_back({name, source, archive});
  }

  void refuse(const fs::path& path) {
    found_.remarks.push_back(fmt::format(
        "{} was left out: a submission is a folder with part*.cpp, a zip or a tar.", quoted(path)));
  }

  void file(const fs::path& path) {
    const std::optional<FolderReader> folder = FolderReader::open(path.parent_path());
    const bool isFile = fs::is_regular_file(path);
    if (isFile && folder && isArchive(*folder, {path.filename().string(), EntryKind::kFile})) {
      add(path, nameOf(path, true), true);
    } else {
      refuse(path);
    }
  }

  void folder(const fs::path& path) {
    const std::optional<FolderReader> reader = FolderReader::open(path);
    if (!reader) {
      found_.remarks.push_back(fmt::format("{} was left out: it cannot be read.", quoted(path)));
    } else if (isSubmission(*reader, onlyOnePath_ ? kMostWrappers : 0)) {
      add(path, nameOf(path, false), false);
    } else {
      classFolder(path, *reader);
    }
  }

  void classFolder(const fs::path& path, const FolderReader& reader) {
    const std::size_t before = found_.submissions.size() + found_.remarks.size();
    for (const FolderEntry& entry : reader.list(kMostEntries)) {
      const fs::path inside = path / entry.name;
      if (isHidden(entry.name)) continue;
      if (entry.kind == EntryKind::kSymbolicLink) {
        found_.remarks.push_back(
            fmt::format("{} was left out: links within a class are not followed.", quoted(inside)));
      } else if (isArchive(reader, entry)) {
        add(inside, nameOf(inside, true), true);
      } else if (entry.kind == EntryKind::kFolder) {
        studentFolder(inside, reader.openFolder(entry.name));
      } else {
        refuse(inside);
      }
    }
    if (found_.submissions.size() + found_.remarks.size() == before)
      found_.remarks.push_back(
          fmt::format("{} was left out: there is no submission in it.", quoted(path)));
  }

  // A folder of a class.
  void studentFolder(const fs::path& path, const std::optional<FolderReader>& reader) {
    if (reader && isSubmission(*reader)) {
      add(path, nameOf(path, false), false);
      return;
    }
    std::vector<fs::path> archives;
    if (reader)
      for (const FolderEntry& entry : reader->list(kMostEntries))
        if (isArchive(*reader, entry)) archives.push_back(path / entry.name);
    if (archives.size() == 1) {
      add(archives.front(), nameOf(path, false), true);
    } else if (archives.empty()) {
      refuse(path);
    } else {
      found_.remarks.push_back(
          fmt::format("{} was left out: there are {} archives in it, and which of them counts is "
                      "not for the grader to say.",
                      quoted(path), archives.size()));
    }
  }

  // A folder that is named alone is a class, even if only one has handed in so far.
  bool onlyOnePath_;
  FoundSubmissions found_;
  std::set<fs::path> sources_;
};

}  // namespace

FoundSubmissions findSubmissions(std::span<const fs::path> paths) {
  Finder finder(paths.size() == 1);
  for (const fs::path& path : paths) finder.path(path);
  return finder.finish();
}

}  // namespace pathmark::submission
