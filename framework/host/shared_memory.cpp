#include "host/shared_memory.h"

#include "worker/protocol.h"

#include <cerrno>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace pathmark {

namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

[[noreturn]] void failToShare() {
  fail(errno == EFBIG
           ? "sharing memory with the worker (the limit on files, ulimit -f, holds for it)"
           : "sharing memory with the worker");
}

FileDescriptor createMemory(const char* name, std::size_t bytes) {
  FileDescriptor fd(memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (fd.get() < 0) failToShare();
  if (ftruncate(fd.get(), static_cast<off_t>(bytes)) != 0) failToShare();
  return fd;
}

std::byte* mapMemory(const FileDescriptor& fd, std::size_t bytes) {
  void* memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, fd.get(), 0);
  if (memory == MAP_FAILED) failToShare();
  return static_cast<std::byte*>(memory);
}

}  // namespace

FileDescriptor::~FileDescriptor() {
  if (fd_ >= 0) close(fd_);
}

SealedBlock::SealedBlock(const std::function<void(const TakeBytes&)>& give)
    : fd_(createMemory("pathmark-scene", 0)) {
  give([this](std::span<const std::byte> bytes) { append(bytes); });
  if (fcntl(fd_.get(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) != 0)
    fail("sealing the scene");
}

void SealedBlock::append(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(fd_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) failToShare();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    bytes_ += static_cast<std::size_t>(written);
  }
}

// The size is sealed, so that a worker cannot pull the memory away from under the host.
SharedFilm::SharedFilm(int width, int height)
    : width_(width),
      height_(height),
      bytes_(kFilmOffset +
             static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                 sizeof(FilmPixel) +
             tileCount(width, height) * sizeof(std::uint64_t)),
      fd_(createMemory("pathmark-film", bytes_)) {
  if (fcntl(fd_.get(), F_ADD_SEALS, F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) != 0)
    fail("sealing the film");
  memory_ = mapMemory(fd_, bytes_);
  new (memory_) ProgressBoard;
}

SharedFilm::~SharedFilm() { munmap(memory_, bytes_); }

ProgressBoard& SharedFilm::board() const { return *reinterpret_cast<ProgressBoard*>(memory_); }

std::span<const FilmPixel> SharedFilm::pixels() const {
  return {reinterpret_cast<const FilmPixel*>(memory_ + kFilmOffset),
          static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)};
}

std::span<FilmPixel> SharedFilm::pixels() {
  return {reinterpret_cast<FilmPixel*>(memory_ + kFilmOffset),
          static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)};
}

std::span<std::uint64_t> SharedFilm::tileRays() {
  return {reinterpret_cast<std::uint64_t*>(pixels().data() + pixels().size()),
          tileCount(width_, height_)};
}

}  // namespace pathmark
