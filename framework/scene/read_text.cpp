#include "scene/read_text.h"

#include "scene/load_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <system_error>

namespace pathmark {
namespace {

constexpr std::uintmax_t kMegabyte = std::uintmax_t{1} << 20;
constexpr std::uintmax_t kLargestFile = 256 * kMegabyte;

constexpr std::size_t kPiece = std::size_t{1} << 18;

// A file that may be read, and its size. A file that becomes shorter meanwhile is judged by what is
// left of it.
class OpenFile {
 public:
  OpenFile(const std::filesystem::path& file, std::string_view rule) : file_(file) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found) refuse("there is no such file.");
    if (error) refuse(fmt::format("the file cannot be opened ({}).", error.message()));
    if (std::filesystem::is_directory(status)) {
      refuse(fmt::format("this is a folder, but {}.", rule));
    }
    // A pipe or a device may never end.
    if (!std::filesystem::is_regular_file(status)) {
      refuse(fmt::format("this is a pipe or a device, but {}.", rule));
    }
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) refuse(fmt::format("the file cannot be read ({}).", error.message()));
    if (size == 0) refuse(fmt::format("the file is empty, but {}.", rule));
    if (size > kLargestFile) {
      refuse(fmt::format("the file has {} MB, but it may have at most {} MB.", size / kMegabyte,
                         kLargestFile / kMegabyte));
    }
    size_ = static_cast<std::size_t>(size);
    stream_.open(file, std::ios::binary);
    if (!stream_) refuse("the file cannot be opened; may you read it?");
  }

  std::size_t size() const { return size_; }

  // Returns how many characters there were; fewer than `count` only at the end.
  std::size_t read(char* to, std::size_t count) {
    stream_.read(to, static_cast<std::streamsize>(count));
    if (stream_.bad()) refuse("the file cannot be read to its end.");
    return static_cast<std::size_t>(stream_.gcount());
  }

 private:
  [[noreturn]] void refuse(const std::string& sentence) const {
    throw SceneError(fmt::format("{}: {}", file_.string(), sentence));
  }

  const std::filesystem::path& file_;
  std::size_t size_ = 0;
  std::ifstream stream_;
};

}  // namespace

std::string readText(const std::filesystem::path& file, std::string_view rule) {
  OpenFile open(file, rule);
  std::string text(open.size(), '\0');
  text.resize(open.read(text.data(), text.size()));
  return text;
}

void readTextInPieces(const std::filesystem::path& file, std::string_view rule,
                      const TakeText& take) {
  OpenFile open(file, rule);
  std::string piece;
  std::size_t left = open.size();
  for (std::size_t kept = 0;;) {
    // Twice as much if nothing was used, so that a long statement is not looked at too often.
    const std::size_t wanted = std::min(std::max(kPiece, kept), left);
    piece.resize(kept + wanted);
    const std::size_t got = open.read(piece.data() + kept, wanted);
    left = got < wanted ? 0 : left - got;
    piece.resize(kept + got);
    const std::size_t used = take(piece, left == 0);
    if (left == 0) return;
    piece.erase(0, used);
    kept = piece.size();
  }
}

}  // namespace pathmark
