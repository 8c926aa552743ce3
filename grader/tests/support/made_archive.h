// MadeArchive: zips and tars for tests, the ordinary and the malicious.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::test {

enum class ArchiveKind { kZip, kTar, kTarGz, kTarXz, kTarZst, kTarBz2, kEncryptedZip };

class MadeArchive {
 public:
  MadeArchive& file(std::string name, std::string bytes = "x");
  MadeArchive& folder(std::string name);
  MadeArchive& symbolicLink(std::string name, std::string target);
  MadeArchive& hardLink(std::string name, std::string target);
  MadeArchive& fifo(std::string name);
  MadeArchive& device(std::string name);
  MadeArchive& time(long seconds);  // of the entries that follow

  void write(ArchiveKind kind, const std::filesystem::path& file) const;

 private:
  struct Entry {
    std::string name, bytes, target;
    unsigned type;
    bool isHardLink;
    long time;
  };
  MadeArchive& add(std::string name, unsigned type, std::string bytes = {}, std::string target = {},
                   bool isHardLink = false);

  std::vector<Entry> entries_;
  long time_ = 1'000'000;
};

std::string readBytes(const std::filesystem::path& file);
void writeBytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace pathmark::test
