#include "submission/read_archive.h"

#include "host/shared_memory.h"
#include "scene/syntax_sentence.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <locale.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <memory>

namespace pathmark::submission {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMebibyte = 1 << 20;

// Small, because limits are looked at once for each of them, and some formats pack a hundred
// thousand bytes in four.
constexpr std::size_t kBlock = 4096;

constexpr const char* kEmpty = "the archive is empty";

// Neither waits for a pipe nor follows a link that has taken the file's place.
FileDescriptor openFile(const std::filesystem::path& file) {
  return FileDescriptor(open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
}

// Names in UTF-8 are handed on by the library as they are only where text is UTF-8, and a program
// that has chosen no locale runs in "C". Of this thread alone.
class Utf8Here {
 public:
  Utf8Here() : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (utf8_ != nullptr) before_ = uselocale(utf8_);
  }
  ~Utf8Here() {
    if (utf8_ == nullptr) return;
    uselocale(before_);
    freelocale(utf8_);
  }
  Utf8Here(const Utf8Here&) = delete;
  Utf8Here& operator=(const Utf8Here&) = delete;

 private:
  locale_t utf8_, before_ = nullptr;
};

class Reader {
 public:
  Reader(const std::filesystem::path& file, const Limits& limits)
      : limits_(limits), descriptor_(openFile(file)), start_(Clock::now()) {
    struct stat status {};
    if (descriptor_.get() < 0 || fstat(descriptor_.get(), &status) != 0)
      throw Refusal("the archive cannot be opened");
    if (!S_ISREG(status.st_mode)) throw Refusal("it is no file");
    size_ = status.st_size;
    if (static_cast<std::uint64_t>(size_) > limits_.archiveBytes)
      throw Refusal(fmt::format("the archive has {:.0f} MiB, but at most {:g} MiB are allowed",
                                static_cast<double>(size_) / kMebibyte,
                                static_cast<double>(limits_.archiveBytes) / kMebibyte));
    if (size_ == 0) throw Refusal("the file is empty");
    if (isEmptyZip()) throw Refusal(kEmpty);
    openArchive();
  }

  void entries(const TakeEntry& take) {
    archive_entry* header = nullptr;
    for (bool any = false;; any = true) {
      check(archive_read_next_header(archive_.get(), &header));
      if (atEnd_ && !any) throw Refusal(kEmpty);
      if (atEnd_) return;
      const std::uint64_t claimed =
          archive_entry_size_is_set(header)
              ? static_cast<std::uint64_t>(std::max<la_int64_t>(archive_entry_size(header), 0))
              : 0;
      // Of an entry that is going to be skipped.
      if (claimed > limits_.unpackedBytes) refuseSize();
      claimed_ += claimed;
      checkLimits();
      take(describe(header), [this](std::size_t atMost) { return read(atMost); });
    }
  }

 private:
  struct Close {
    void operator()(archive* a) const { archive_read_free(a); }
  };

  // Nothing but the record that ends every zip (APPNOTE.TXT, 4.3.16), with zeros for the number,
  // size and place of entries: the library takes it for no archive.
  bool isEmptyZip() const {
    constexpr std::size_t kSignature = 4, kZeros = 16;
    std::array<char, kSignature + kZeros> begin{};
    if (pread(descriptor_.get(), begin.data(), begin.size(), 0) !=
        static_cast<ssize_t>(begin.size()))
      return false;
    return std::string_view(begin.data(), kSignature) == "PK\5\6" &&
           std::all_of(begin.begin() + kSignature, begin.end(), [](char c) { return c == 0; });
  }

  void openArchive() {
    archive_.reset(archive_read_new());
    archive* const a = archive_.get();
    if (a == nullptr) throw Refusal("there is too little memory to read the archive");
    archive_read_support_format_tar(a);
    archive_read_support_format_zip_seekable(a);
    for (const auto support : {archive_read_support_filter_gzip, archive_read_support_filter_bzip2,
                               archive_read_support_filter_xz, archive_read_support_filter_lzma,
                               archive_read_support_filter_zstd})
      if (isBuiltIn(support)) support(a);
    archive_read_set_read_callback(a, readBlock);
    archive_read_set_skip_callback(a, skipBytes);
    archive_read_set_seek_callback(a, seekTo);
    archive_read_set_callback_data(a, this);
    if (archive_read_open1(a) != ARCHIVE_OK) refuseAsDamaged();
    // The last one is the file itself.
    if (archive_filter_count(a) > 2) throw Refusal("it is compressed more than once");
  }

  // Otherwise the library would start a program to decompress.
  static bool isBuiltIn(int (*support)(archive*)) {
    const std::unique_ptr<archive, Close> probe(archive_read_new());
    return probe && support(probe.get()) == ARCHIVE_OK;
  }

  static Entry describe(archive_entry* header) {
    Entry entry;
    const char* name = archive_entry_pathname(header);
    if (name == nullptr) name = archive_entry_pathname_utf8(header);
    if (name != nullptr) entry.path = name;
    entry.encrypted = archive_entry_is_encrypted(header) != 0;
    if (archive_entry_hardlink(header) != nullptr ||
        archive_entry_hardlink_utf8(header) != nullptr) {
      entry.kind = EntryKind::kHardLink;
    } else {
      switch (archive_entry_filetype(header)) {
        case AE_IFREG:
          entry.kind = EntryKind::kFile;
          break;
        case AE_IFDIR:
          entry.kind = EntryKind::kFolder;
          break;
        case AE_IFLNK:
          entry.kind = EntryKind::kSymbolicLink;
          break;
        default:
          entry.kind = EntryKind::kOther;
      }
    }
    return entry;
  }

  std::string read(std::size_t atMost) {
    std::string bytes;
    std::array<char, 65536> block{};
    while (bytes.size() < atMost) {
      const la_ssize_t got = archive_read_data(archive_.get(), block.data(),
                                               std::min(block.size(), atMost - bytes.size()));
      checkLimits();
      if (got < 0) refuseAsDamaged();
      if (got == 0) break;
      bytes.append(block.data(), static_cast<std::size_t>(got));
      unpacked_ += static_cast<std::uint64_t>(got);
    }
    return bytes;
  }

  void check(int result) {
    atEnd_ = result == ARCHIVE_EOF;
    if (atEnd_ || result == ARCHIVE_OK || result == ARCHIVE_WARN) {
      if (atEnd_) checkLimits();
      return;
    }
    refuseAsDamaged();
  }

  [[noreturn]] void refuseAsDamaged() {
    checkLimits();
    const char* said = archive_error_string(archive_.get());
    throw Refusal(fmt::format("the archive is damaged, or no zip or tar ({})",
                              said != nullptr ? shown(said, 100) : "no details are known"));
  }

  [[noreturn]] void refuseSize() const {
    throw Refusal(fmt::format("it has more than {:g} MiB when unpacked",
                              static_cast<double>(limits_.unpackedBytes) / kMebibyte));
  }

  bool isTooLarge() const {
    const auto streamed = static_cast<std::uint64_t>(
        std::max<la_int64_t>(archive_filter_bytes(archive_.get(), 0), 0));
    return std::max({claimed_, unpacked_, streamed}) > limits_.unpackedBytes;
  }
  bool isTooLate() const {
    return std::chrono::duration<double>(Clock::now() - start_).count() > limits_.seconds;
  }
  void checkLimits() const {
    if (isTooLarge()) refuseSize();
    if (isTooLate())
      throw Refusal(fmt::format("it could not be read within {:g} s", limits_.seconds));
  }

  static la_ssize_t readBlock(archive* a, void* self, const void** buffer) {
    auto& reader = *static_cast<Reader*>(self);
    if (reader.isTooLarge() || reader.isTooLate()) {
      archive_set_error(a, E2BIG, "beyond the limits");
      return -1;
    }
    *buffer = reader.block_.data();
    const ssize_t got = ::read(reader.descriptor_.get(), reader.block_.data(), kBlock);
    if (got < 0) archive_set_error(a, errno, "the file cannot be read");
    return got;
  }

  static la_int64_t skipBytes(archive*, void* self, la_int64_t count) {
    const auto& reader = *static_cast<Reader*>(self);
    const off_t at = lseek(reader.descriptor_.get(), 0, SEEK_CUR);
    const off_t to = std::min<off_t>(count, reader.size_ - at) + at;
    if (at < 0 || to < at || lseek(reader.descriptor_.get(), to, SEEK_SET) < 0) return 0;
    return to - at;
  }

  static la_int64_t seekTo(archive*, void* self, la_int64_t offset, int whence) {
    const off_t at = lseek(static_cast<Reader*>(self)->descriptor_.get(), offset, whence);
    return at < 0 ? ARCHIVE_FATAL : at;
  }

  Limits limits_;
  FileDescriptor descriptor_;
  Clock::time_point start_;
  off_t size_ = 0;
  std::array<char, kBlock> block_{};
  std::uint64_t claimed_ = 0, unpacked_ = 0;
  bool atEnd_ = false;
  std::unique_ptr<archive, Close> archive_;
};

}  // namespace

void readArchive(const std::filesystem::path& file, const Limits& limits, const TakeEntry& take) {
  const Utf8Here utf8;
  Reader(file, limits).entries(take);
}

bool looksLikeArchive(std::string_view firstBytes) {
  using namespace std::string_view_literals;
  for (const std::string_view magic :
       {"PK\3\4"sv, "PK\5\6"sv, "\x1f\x8b"sv, "BZh"sv, "\xfd\x37zXZ\0"sv, "\x28\xb5\x2f\xfd"sv})
    if (firstBytes.starts_with(magic)) return true;
  return firstBytes.size() >= kMagicBytes && firstBytes.substr(257, 5) == "ustar";
}

}  // namespace pathmark::submission
