#include "host/object_file.h"

#include "host/build_config.h"
#include "host/elf_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// Of installCrashHandlers in the worker's crash_handler.cpp.
constexpr unsigned kLockPriority = 101;

// Coursework has a few kilobytes of code; large arrays are filled when the program runs.
constexpr std::uintmax_t kMebibyte = 1 << 20, kLargestObject = 4 * kMebibyte;

struct Descriptor {
  int fd = -1;
  ~Descriptor() {
    if (fd >= 0) close(fd);
  }
};

[[noreturn]] void fail(const fs::path& file) {
  throw std::system_error(errno, std::generic_category(), file.string());
}

void writeAll(int fd, const char* bytes, std::size_t size, const fs::path& file) {
  while (size > 0) {
    const ssize_t n = write(fd, bytes, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail(file);
    bytes += n;
    size -= static_cast<std::size_t>(n);
  }
}

bool hasEarlyFunction(std::span<const std::byte> bytes, const Elf64_Shdr& symbols) {
  const std::uint64_t count =
      std::min<std::uint64_t>(symbols.sh_size, bytes.size()) / sizeof(Elf64_Sym);
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto symbol = elf::at<Elf64_Sym>(bytes, symbols.sh_offset + k * sizeof(Elf64_Sym));
    if (symbol && ELF64_ST_TYPE(symbol->st_info) == STT_GNU_IFUNC) return true;
  }
  return false;
}

// Whether the functions of the section run before the worker's own lock, which is a constructor.
// Those of the same priority run in the order of the objects, the worker's first; what has no
// number for a priority is put where the linker likes.
bool runsEarly(std::string_view name, std::uint32_t type) {
  if (name == ".init" || type == SHT_PREINIT_ARRAY || name.starts_with(".preinit_array"))
    return true;
  // Another name for the array, with priorities counted down; compilers do not use it.
  if (name.starts_with(".ctors.")) return true;
  constexpr std::string_view kArray = ".init_array";
  if (name == kArray || (type != SHT_INIT_ARRAY && !name.starts_with(kArray))) return false;
  // Sanitizers begin in it; workers with them have no lock.
  if (build::kSanitized) return false;
  if (!name.starts_with(kArray) || name[kArray.size()] != '.') return true;
  const std::string_view digits = name.substr(kArray.size() + 1);
  const char* last = digits.data() + digits.size();
  unsigned priority = 0;
  const auto [end, error] = std::from_chars(digits.data(), last, priority);
  return error != std::errc{} || end != last || priority <= kLockPriority;
}

// Removed unless it has got its name.
struct Scratch {
  std::string path;
  bool isThere = false;

  ~Scratch() {
    if (isThere) unlink(path.c_str());
  }
};

}  // namespace

bool takeFile(const fs::path& from, const fs::path& to, std::size_t largest) {
  const Descriptor in{open(from.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)};
  struct stat status {};
  if (in.fd < 0 || fstat(in.fd, &status) != 0 || !S_ISREG(status.st_mode) ||
      static_cast<std::uintmax_t>(status.st_size) > largest)
    return false;
  Scratch made{to.string() + ".XXXXXX"};
  const Descriptor out{mkostemp(made.path.data(), O_CLOEXEC)};
  if (out.fd < 0) fail(to);
  made.isThere = true;
  std::vector<char> chunk(std::size_t{256} << 10);
  for (std::size_t taken = 0;;) {
    const ssize_t n = read(in.fd, chunk.data(), chunk.size());
    if (n < 0 && errno == EINTR) continue;
    if (n == 0) break;
    taken += static_cast<std::size_t>(std::max<ssize_t>(n, 0));
    if (n < 0 || taken > largest) return false;  // it has grown, or cannot be read
    writeAll(out.fd, chunk.data(), static_cast<std::size_t>(n), made.path);
  }
  const mode_t mode = (status.st_mode & S_IXUSR) != 0 ? 0755 : 0644;
  if (fchmod(out.fd, mode) != 0 || rename(made.path.c_str(), to.c_str()) != 0) fail(to);
  made.isThere = false;
  return true;
}

std::optional<std::string> objectComplaint(std::span<const std::byte> bytes) {
  const auto header = elf::at<Elf64_Ehdr>(bytes, 0);
  if (!header || !elf::isRelocatable(*header)) return "what the compiler made is no object file";
  const auto section = [&](std::uint64_t index) { return elf::sectionAt(bytes, *header, index); };
  // More sections than the header can count are announced in the first one.
  const auto first = section(0);
  if (!first) return "the object file is cut short";
  const std::uint64_t count = header->e_shnum != 0 ? header->e_shnum : first->sh_size;
  const auto names =
      section(header->e_shstrndx != SHN_XINDEX ? header->e_shstrndx : first->sh_link);
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto here = section(k);
    if (!here || !names) return "the object file is cut short";
    const std::string_view name = elf::nameAt(bytes, *names, here->sh_name);
    if (name.starts_with(".gnu.lto_") || name.starts_with(".gnu.offload_lto_"))
      return "the object file has code for link-time optimisation, and coursework is plain machine "
             "code";
    if (name == ".interp")
      return "the object file names a program to load it with, and coursework is loaded by the "
             "system's";
    if (runsEarly(name, here->sh_type) ||
        (here->sh_type == SHT_SYMTAB && hasEarlyFunction(bytes, *here)))
      return "the coursework has a function that runs before the program begins; only functions "
             "of the contract and what they call are run";
  }
  return std::nullopt;
}

std::optional<std::string> objectComplaint(const fs::path& file) {
  std::error_code error;
  if (const std::uintmax_t size = fs::file_size(file, error); !error && size > kLargestObject)
    return fmt::format(
        "the object file has {} MiB, and at most {} are allowed; an array that begins "
        "with values is part of it, one that a function fills is not",
        (size + kMebibyte - 1) / kMebibyte, kLargestObject / kMebibyte);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  return objectComplaint(std::as_bytes(std::span(bytes)));
}

}  // namespace pathmark
