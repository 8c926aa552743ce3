#include "bench/error_peers.h"

#include "host/session.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <fstream>
#include <set>
#include <tuple>

namespace pathmark::bench {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

template <class Number>
bool read(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

void check(const PeerImage& peer, const std::string& where) {
  if (peer.name.empty() || peer.name.find_first_of(",\"\n") != std::string::npos)
    throw UsageError(fmt::format("{}: a renderer has a name, without commas and quotes.", where));
  if (!(peer.cpuSeconds > 0.0))
    throw UsageError(fmt::format("{}: the CPU seconds are a number above 0.", where));
  if (!fs::is_regular_file(peer.image))
    throw UsageError(fmt::format("{}: there is no file {}.", where, peer.image.string()));
}

PeerImage fromWord(const std::string& word) {
  const std::size_t equals = word.find('='), comma = word.find(',', equals);
  PeerImage peer;
  const std::string_view view(word);
  bool good = equals != std::string::npos && comma != std::string::npos;
  if (good) {
    peer.name = word.substr(0, equals);
    peer.image = word.substr(equals + 1, comma - equals - 1);
    const std::size_t second = word.find(',', comma + 1);
    good = read(view.substr(comma + 1, second - comma - 1), peer.cpuSeconds) &&
           (second == std::string::npos || read(view.substr(second + 1), peer.raysPerPixel));
  }
  if (!good)
    throw UsageError(fmt::format(
        "--peer {}: it is NAME=IMAGE,SECONDS or NAME=IMAGE,SECONDS,RAYS, a .json file with a list, "
        "or cycles.",
        word));
  check(peer, fmt::format("--peer {}", word));
  return peer;
}

PeerImage fromJson(const Json& json, const fs::path& file, std::size_t number) {
  const std::string where = fmt::format("{}, entry {}", file.string(), number);
  const auto bad = [&](const char* key, const char* what) {
    return UsageError(fmt::format("{}: \"{}\" must be {}.", where, key, what));
  };
  if (!json.is_object()) throw UsageError(fmt::format("{}: it is no object.", where));
  PeerImage peer;
  const auto text = [&](const char* key, bool needed) -> std::string {
    if (!json.contains(key) && !needed) return {};
    if (!json.contains(key) || !json[key].is_string()) throw bad(key, "a text");
    return json[key].get<std::string>();
  };
  peer.name = text("name", true);
  peer.scene = text("scene", false);
  peer.image = file.parent_path() / text("image", true);
  if (!json.contains("seconds") || !json["seconds"].is_number())
    throw bad("seconds", "a number of CPU seconds");
  peer.cpuSeconds = json["seconds"].get<double>();
  if (json.contains("raysPerPixel")) {
    if (!json["raysPerPixel"].is_number_unsigned()) throw bad("raysPerPixel", "a whole number");
    peer.raysPerPixel = json["raysPerPixel"].get<std::uint64_t>();
  }
  check(peer, where);
  return peer;
}

void readList(const fs::path& file, std::vector<PeerImage>& peers) {
  std::ifstream in(file);
  if (!in) throw UsageError(fmt::format("--peer {}: the file cannot be read.", file.string()));
  const Json list = Json::parse(in, nullptr, false);
  if (!list.is_array())
    throw UsageError(fmt::format("--peer {}: it must be a JSON list of objects.", file.string()));
  for (std::size_t k = 0; k < list.size(); ++k) peers.push_back(fromJson(list[k], file, k + 1));
}

// Without its number of rays a second image of a renderer is neither another point nor another
// replicate.
void refuseUnknownRays(const std::vector<PeerImage>& peers) {
  std::set<std::tuple<std::string, std::string>> seen;
  for (const PeerImage& peer : peers)
    if (!seen.emplace(peer.name, peer.scene).second && peer.raysPerPixel == 0)
      throw UsageError(fmt::format(
          "--peer: of several images of {}, each must say its rays per pixel.", peer.name));
}

}  // namespace

std::vector<PeerImage> readPeers(const std::vector<std::string>& words) {
  std::vector<PeerImage> peers;
  for (const std::string& word : words) {
    if (word.find('=') == std::string::npos && fs::path(word).extension() == ".json")
      readList(word, peers);
    else
      peers.push_back(fromWord(word));
  }
  refuseUnknownRays(peers);
  return peers;
}

}  // namespace pathmark::bench
