#include "scene/syntax_sentence.h"
#include "submission/names.h"
#include "submission/read_archive.h"
#include "submission/read_folder.h"
#include "submission/submission.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

namespace pathmark::submission {

namespace fs = std::filesystem;

namespace {

constexpr int kMostWrappers = 8;
constexpr std::size_t kMostEntries = 10'000;

constexpr std::size_t kLongestShown = 300;
constexpr const char* kUnreadable = "it cannot be read";

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

// Of what could be a class within a class: with a submission in it, or one as learning platforms
// make them.
bool isSubmissionFolder(const FolderReader& folder, const FolderEntry& entry) {
  if (entry.kind != EntryKind::kFolder || isHidden(entry.name)) return false;
  const std::optional<FolderReader> below = folder.openFolder(entry.name);
  if (!below) return false;
  const std::vector<FolderEntry> entries = below->list(kMostEntries);
  return isSubmission(*below) ||
         std::count_if(entries.begin(), entries.end(),
                       [&](const FolderEntry& e) { return isArchive(*below, e); }) == 1;
}

// What lies beside a class's submissions, and is nobody's: lists, instructions, what systems leave.
bool isDocument(const std::string& name) {
  static constexpr std::array<std::string_view, 15> kEndings{
      ".csv",  ".tsv", ".txt", ".md",   ".pdf", ".html", ".json", ".yml",
      ".yaml", ".ods", ".xls", ".xlsx", ".log", ".ini",  ".db"};
  const std::string ending = lowerCase(fs::path(name).extension().string());
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

// Why a file is no archive, where its ending tells; empty for others.
std::string whyNotRead(const std::string& name) {
  const std::string ending = lowerCase(fs::path(name).extension().string());
  return ending == ".7z" || ending == ".rar"
             ? fmt::format("{} is not read: a zip or a tar is", ending)
             : std::string();
}

// The file that is meant by one of almost its name, or any other of the coursework.
std::string_view fileLike(const std::string& name) {
  const std::optional<int> number = numberOfPart(name);
  for (const PartContract& part : parts())
    if (number && part.part == *number) return part.file;
  return parts().front().file;
}

// Why there is no submission in a folder, or in the only folder that it holds; empty where nothing
// better can be said than what a submission is.
std::string whyNone(const FolderReader& folder, int wrappers = 0) {
  std::vector<FolderEntry> entries = folder.list(kMostEntries);
  std::erase_if(entries, [](const FolderEntry& entry) { return isHidden(entry.name); });
  if (entries.empty()) return "the folder is empty";
  for (const FolderEntry& entry : entries)
    if (entry.kind == EntryKind::kFile && looksLikePart(entry.name))
      return fmt::format("{} is not the name of a file of the coursework, such as {}",
                         inQuotes(entry.name), fileLike(entry.name));
  for (const FolderEntry& entry : entries)
    if (std::string why = whyNotRead(entry.name); entry.kind == EntryKind::kFile && !why.empty())
      return why;
  if (entries.size() > 1 || entries.front().kind != EntryKind::kFolder || wrappers == kMostWrappers)
    return {};
  const std::optional<FolderReader> below = folder.openFolder(entries.front().name);
  return below ? whyNone(*below, wrappers + 1) : kUnreadable;
}

std::string nameOf(const fs::path& source, bool archive) {
  const std::string name = source.filename().string();
  return safeName(archive ? archiveStem(name).value_or(name) : name);
}

// Of what cannot be graded: "bob" for "bob.7z" too, but not for a folder "bob.7".
std::string nameOfLeftOut(const fs::path& source) {
  std::error_code ignored;
  const bool isFolder = fs::symlink_status(source, ignored).type() == fs::file_type::directory;
  const std::string stem = source.stem().string();
  return isFolder || stem.empty()
             ? nameOf(source, false)
             : safeName(archiveStem(source.filename().string()).value_or(stem));
}

// Of submissions, or of what is left out.
struct ByName {
  template <class T>
  bool operator()(const T& a, const T& b) const {
    return a.name != b.name ? naturalLess(a.name, b.name)
                            : naturalLess(a.source.string(), b.source.string());
  }
};

class Finder {
 public:
  Finder(bool onlyOnePath, const EarlierNames& earlier)
      : onlyOnePath_(onlyOnePath), earlier_(earlier) {}

  void path(const fs::path& given) {
    std::error_code error;
    const fs::path real = fs::canonical(given, error);
    if (error) {
      found_.missing.push_back(given.string());
    } else if (fs::is_directory(real)) {
      folder(real);
    } else {
      file(real);
    }
  }

  FoundSubmissions finish() {
    UniqueNames names;
    for (const auto& [source, name] : earlier_) names.take(name);
    for (const Submission& one : found_.submissions) remarkOnNewcomer(one, names);
    giveNames(found_.submissions, names);
    // Behind all submissions, whose names do not depend on what lies beside them.
    giveNames(found_.leftOut, names);
    return std::move(found_);
  }

 private:
  // It may be somebody's of the same name, or the same one at another place.
  void remarkOnNewcomer(const Submission& one, const UniqueNames& earlier) {
    if (!earlier_.contains(one.source) && earlier.isTaken(one.name))
      found_.remarks.push_back(
          fmt::format("\"{}\" gets a name with a number: another submission has been graded as {}.",
                      shown(one.source.string(), kLongestShown), one.name));
  }

  template <class T>
  void giveNames(std::vector<T>& all, UniqueNames& names) const {
    std::sort(all.begin(), all.end(), ByName{});
    for (T& one : all) {
      const auto known = earlier_.find(one.source);
      one.name = known != earlier_.end() ? known->second : names.unique(one.name);
    }
    // -2 may have moved behind another's name.
    std::sort(all.begin(), all.end(), ByName{});
  }

  void add(const fs::path& source, const std::string& name, bool archive) {
    if (sources_.insert(source).second) found_.submissions.push_back({name, source, archive});
  }

  void leaveOut(const fs::path& path, std::string why) {
    if (!sources_.insert(path).second) return;
    found_.remarks.push_back(
        fmt::format("\"{}\" was left out: {}.", shown(path.string(), kLongestShown), why));
    why.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(why.front())));
    found_.leftOut.push_back({nameOfLeftOut(path), path, fmt::format("{}.", why)});
  }

  void refuse(const fs::path& path, const std::string& why) {
    leaveOut(path, why.empty() ? "a submission is a folder with part*.cpp, a zip or a tar" : why);
  }

  void file(const fs::path& path) {
    const std::optional<FolderReader> folder = FolderReader::open(path.parent_path());
    const bool isFile = fs::is_regular_file(path);
    if (isFile && folder && isArchive(*folder, {path.filename().string(), EntryKind::kFile})) {
      add(path, nameOf(path, true), true);
    } else {
      refuse(path, whyNotRead(path.filename().string()));
    }
  }

  void folder(const fs::path& path) {
    const std::optional<FolderReader> reader = FolderReader::open(path);
    if (!reader) {
      leaveOut(path, kUnreadable);
    } else if (isSubmission(*reader, onlyOnePath_ ? kMostWrappers : 0)) {
      add(path, nameOf(path, false), false);
    } else {
      classFolder(path, *reader);
    }
  }

  void classFolder(const fs::path& path, const FolderReader& reader) {
    const std::vector<FolderEntry> entries = reader.list(kMostEntries);
    const bool onlyFiles =
        std::all_of(entries.begin(), entries.end(), [&](const FolderEntry& entry) {
          return isHidden(entry.name) ||
                 (entry.kind == EntryKind::kFile && !isArchive(reader, entry));
        });
    // Somebody's whose files have other names, rather than a class of theirs.
    if (onlyFiles) {
      const std::string why = whyNone(reader);
      return leaveOut(path, why.empty() ? "there is no submission in it" : why);
    }
    for (const FolderEntry& entry : entries) {
      const fs::path inside = path / entry.name;
      if (isHidden(entry.name)) continue;
      if (entry.kind == EntryKind::kSymbolicLink) {
        leaveOut(inside, "links within a class are not followed");
      } else if (isArchive(reader, entry)) {
        add(inside, nameOf(inside, true), true);
      } else if (entry.kind == EntryKind::kFolder) {
        studentFolder(inside, reader.openFolder(entry.name));
      } else if (isDocument(entry.name)) {
        found_.remarks.push_back(fmt::format("\"{}\" was taken for nobody's: it is a document.",
                                             shown(inside.string(), kLongestShown)));
      } else {
        refuse(inside, whyNotRead(entry.name));
      }
    }
  }

  // A folder of a class.
  void studentFolder(const fs::path& path, const std::optional<FolderReader>& reader) {
    if (!reader) return leaveOut(path, kUnreadable);
    if (isSubmission(*reader)) return add(path, nameOf(path, false), false);
    std::vector<fs::path> archives;
    std::size_t folders = 0;
    for (const FolderEntry& entry : reader->list(kMostEntries)) {
      if (isArchive(*reader, entry)) archives.push_back(path / entry.name);
      if (isSubmissionFolder(*reader, entry)) ++folders;
    }
    if (folders > 0) {
      const std::size_t all = folders + archives.size();
      leaveOut(path, fmt::format("it holds {} submission{}: name it by itself on the command line, "
                                 "or the one that counts",
                                 all, all == 1 ? "" : "s"));
    } else if (archives.size() == 1) {
      add(archives.front(), nameOf(path, false), true);
    } else if (archives.empty()) {
      refuse(path, whyNone(*reader));
    } else {
      leaveOut(path, fmt::format("there are {} archives in it, and which of them counts is not for "
                                 "the grader to say",
                                 archives.size()));
    }
  }

  // A folder that is named alone is a class, even if only one has handed in so far.
  bool onlyOnePath_;
  const EarlierNames& earlier_;
  FoundSubmissions found_;
  std::set<fs::path> sources_;
};

}  // namespace

FoundSubmissions findSubmissions(std::span<const fs::path> paths, const EarlierNames& earlier) {
  Finder finder(paths.size() == 1, earlier);
  for (const fs::path& path : paths) finder.path(path);
  return finder.finish();
}

}  // namespace pathmark::submission
