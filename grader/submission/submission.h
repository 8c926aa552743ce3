// Collecting submissions: from what is handed in to the files that are compiled.
//
//   findSubmissions   the submissions that words of the command line mean, and what is left out
//   collect           the expected files of one, in memory, and what was refused
//   writeOut          those files in a clean folder
//
// A submission is a folder or an archive (zip or tar) that holds at least one file part*.cpp of the
// coursework, directly, in a folder student/, or below folders that merely wrap it. Of its files
// only part*.cpp, scenes/*.json and the meshes below scenes/ are taken. Nothing of an archive is
// written anywhere while it is read, links are not followed, and whatever is odd becomes a
// sentence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace pathmark::submission {

struct Submission {
  std::string name;              // unique; letters, digits, '.', '_', '-', at most 80 of them
  std::filesystem::path source;  // the folder or archive
  bool isArchive = false;
};

// Somebody may have handed it in, but there is nothing in it that can be graded.
struct LeftOut {
  std::string name;  // as of a submission, and unique among these
  std::filesystem::path source;
  std::string reason;  // a sentence that does not name it
};

struct FoundSubmissions {
  std::vector<Submission> submissions;  // in natural order of their names
  std::vector<LeftOut> leftOut;         // likewise
  std::vector<std::string> remarks;     // about what is no submission, and about names: sentences
  std::vector<std::string> missing;     // paths where there is nothing
};

// The names that submissions have been graded under, by their sources.
using EarlierNames = std::map<std::filesystem::path, std::string>;

// A folder that is no submission is a class: each of its entries may be one. A folder that is the
// only path, and merely wraps another one, is a class of one. A folder of a class
// that holds nothing but one archive, as learning platforms make them, is that archive under the
// folder's name. Documents (.csv, .txt, .pdf, .yml and such) among the entries of a class are
// nobody's: there is a remark about each and no more. A path that has nothing in it but files that
// are no submission is left out as a whole. Whoever has an earlier name keeps it, and no other gets
// it.
FoundSubmissions findSubmissions(std::span<const std::filesystem::path> paths,
                                 const EarlierNames& earlier = {});

struct Limits {
  std::size_t entries = 10'000;  // files, folders and whatever else there is
  std::size_t pathBytes = 512, pathDepth = 16;
  std::size_t codeBytes = std::size_t{1} << 20;  // of one file, as everywhere else
  std::size_t sceneBytes = std::size_t{4} << 20;
  std::size_t meshBytes = std::size_t{16} << 20;
  std::size_t keptBytes = std::size_t{64} << 20;           // of all files that may be taken
  std::uint64_t archiveBytes = std::uint64_t{128} << 20;   // as it was handed in
  std::uint64_t unpackedBytes = std::uint64_t{512} << 20;  // of all entries, skipped or not
  double seconds = 30.0;
};

struct Collected {
  // "part3_lambertian.cpp", "scenes/my_scene.json", "scenes/meshes/cup.obj" and their bytes.
  std::map<std::string, std::string> files;
  std::string contents;  // hash of names and bytes: the same for a folder and any archive of it
  std::vector<std::string> remarks;  // what was refused, renamed, ignored or is missing: sentences
  std::vector<std::string> refusedScenes;  // those of them that are about scenes/*.json
  std::string failure;                     // why nothing at all was taken: sentences
};

// Never throws because of what is in the submission. All is taken whatever is asked for, but no
// remark is made about files of other parts than `only`, nor about scenes then; empty: all parts
// and scenes.
Collected collect(const Submission& submission, const Limits& limits = {},
                  std::span<const int> only = {});

// The folder is made; if it is there, it must be empty. Throws std::runtime_error with a sentence.
void writeOut(const Collected& collected, const std::filesystem::path& folder);

}  // namespace pathmark::submission
