// Sorter: tells the files of a coursework from everything else that is handed in with them.
//
// Which folder is the coursework's is known only at the end, so whatever may belong to it is kept
// until then. The order of the entries decides nothing.
#pragma once

#include "submission/entry.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace pathmark::submission {

class Sorter {
 public:
  // Remarks are about these parts alone; about all, and scenes, if there are none.
  explicit Sorter(const Limits& limits, std::span<const int> only = {})
      : limits_(limits), only_(only.begin(), only.end()) {}

  // Throws Refusal where the whole submission is beyond the limits.
  void take(const Entry& entry, const ReadEntry& read);

  Collected finish();

 private:
  using Path = std::vector<std::string>;

  // A file that may be one of the coursework's.
  struct Candidate {
    Path path;
    std::string problem;  // "is a link"; empty for bytes that can be taken
    std::string bytes;

    Path folder() const { return Path(path.begin(), path.end() - 1); }
  };

  struct Homes {
    std::set<Path> projects;     // whose student/ has files of the coursework
    std::set<Path> courseworks;  // folders of such files
  };

  static std::string partName(const std::string& name);
  static std::string sceneName(const Path& path, std::size_t below);
  static bool mayBeOfAScene(const Path& path);

  bool isWanted(int part) const;
  bool isWanted(const std::string& target) const;  // "part3_lambertian.cpp", "scenes/a.json"
  void note(std::string sentence);                 // for the report
  void noteAbout(const std::string& target, std::string sentence);
  void noteRefusal(const std::string& target, std::string sentence);
  void noteNearMisses();
  void noteLeftOut(const std::vector<std::string>& scenes);
  std::size_t largest(const std::string& name) const;
  void keep(Path path, const Entry& entry, const ReadEntry& read);
  Homes homes() const;
  static bool belongsToTheProject(const Path& folder, const Homes& homes);
  static bool belongsToALab(const Path& folder, const Homes& homes);
  std::string sceneTarget(const Candidate& candidate, const std::set<Path>& folders) const;
  void decide(const std::string& target, const std::vector<const Candidate*>& candidates,
              Collected& collected);
  void sayWhatIsMissing(const std::set<std::string>& seen, Collected& collected);

  Limits limits_;
  std::vector<int> only_;
  std::vector<Candidate> candidates_;
  std::vector<std::string> notes_, refusedScenes_;
  std::vector<std::string> nearMisses_;  // "part3_lambertian (1).cpp"
  std::string unopened_;                 // the first sentence about an archive within
  std::size_t entries_ = 0, keptBytes_ = 0, ignored_ = 0;
};

}  // namespace pathmark::submission
