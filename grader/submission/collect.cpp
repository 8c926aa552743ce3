#include "submission/read_archive.h"
#include "submission/read_folder.h"
#include "submission/sorter.h"

#include <fmt/format.h>

#include <fstream>
#include <new>
#include <system_error>

namespace pathmark::submission {

namespace fs = std::filesystem;

namespace {

Collected nothing(const std::string& why) {
  Collected collected;
  collected.failure = fmt::format("Nothing was taken: {}{}", why, why.ends_with('?') ? "" : ".");
  collected.contents = Sorter({}).finish().contents;
  return collected;
}

}  // namespace

Collected collect(const Submission& submission, const Limits& limits, std::span<const int> only) {
  try {
    Sorter sorter(limits, only);
    const auto take = [&](const Entry& entry, const ReadEntry& read) { sorter.take(entry, read); };
    if (submission.isArchive) {
      readArchive(submission.source, limits, take);
    } else {
      readFolder(submission.source, limits, take);
    }
    return sorter.finish();
  } catch (const Refusal& refusal) {
    return nothing(refusal.what());
  } catch (const std::bad_alloc&) {
    return nothing("there is too little memory to read it");
  }
}

void writeOut(const Collected& collected, const fs::path& folder) {
  std::error_code error;
  const bool thereBefore = !fs::create_directories(folder, error);
  if (error || (thereBefore && !fs::is_empty(folder, error)) || error)
    throw std::runtime_error(
        fmt::format("{}: this must be a new or an empty folder{}.", folder.string(),
                    error ? fmt::format(" ({})", error.message()) : std::string()));
  for (const auto& [name, bytes] : collected.files) {
    const fs::path file = folder / name;
    fs::create_directories(file.parent_path(), error);
    std::ofstream out(file, std::ios::binary);
    out << bytes;
    out.close();
    if (!out) throw std::runtime_error(fmt::format("{}: cannot be written.", file.string()));
  }
}

}  // namespace pathmark::submission
