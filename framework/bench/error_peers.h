// Images and times of other renderers, for bench error.
//
//   PeerImage    one of them
//   readPeers    from words of the command line
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::bench {

struct PeerImage {
  std::string name;
  std::string scene;  // empty: the only one
  std::filesystem::path image;
  double cpuSeconds = 0.0;
  std::uint64_t raysPerPixel = 0;  // 0: not known
};

// Each word is NAME=IMAGE,SECONDS or NAME=IMAGE,SECONDS,RAYS, or a .json file with a list of
// objects
// {"name", "scene", "image", "seconds", "raysPerPixel"}, whose images are looked for beside the
// file. Images of one name, scene and number of rays are replicates. Throws UsageError.
std::vector<PeerImage> readPeers(const std::vector<std::string>& words);

}  // namespace pathmark::bench
