// Memory that the host shares with a worker.
//
//   SealedBlock   a block that nobody can change any more: the packed scene
//   SharedFilm    the progress board and the film that a worker renders into
#pragma once

#include "render/progress_board.h"
#include "render/render_job.h"

#include <cstddef>
#include <functional>
#include <span>
#include <utility>

namespace pathmark {

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd = -1) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor();

  int get() const { return fd_; }
  void reset() { *this = FileDescriptor(); }

 private:
  int fd_;
};

// Sealed against writing, growing and shrinking. The host writes it piece by piece and does not map
// it, so that the block costs the host no memory of its own.
class SealedBlock {
 public:
  using TakeBytes = std::function<void(std::span<const std::byte>)>;

  SealedBlock() = default;
  // Of all the bytes that `give` hands over, in order. Throws std::system_error.
  explicit SealedBlock(const std::function<void(const TakeBytes&)>& give);

  int descriptor() const { return fd_.get(); }
  std::size_t bytes() const { return bytes_; }

 private:
  void append(std::span<const std::byte> bytes);

  FileDescriptor fd_;
  std::size_t bytes_ = 0;
};

class SharedFilm {
 public:
  // All pixels zero. Throws std::system_error.
  SharedFilm(int width, int height);
  ~SharedFilm();
  SharedFilm(const SharedFilm&) = delete;
  SharedFilm& operator=(const SharedFilm&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  int descriptor() const { return fd_.get(); }
  std::size_t bytes() const { return bytes_; }
  ProgressBoard& board() const;
  std::span<const FilmPixel> pixels() const;
  std::span<FilmPixel> pixels();

  // For jobs with raysByTile: tile by tile.
  std::span<std::uint64_t> tileRays();

 private:
  int width_, height_;
  std::size_t bytes_;
  FileDescriptor fd_;
  std::byte* memory_ = nullptr;
};

}  // namespace pathmark
