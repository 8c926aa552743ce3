// The worker's end of the wire: receiving requests, sending replies, mapping shared memory.
#pragma once

#include "worker/protocol.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace pathmark {

template <class T>
std::span<const std::byte> asBytes(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

struct Message {
  MessageHeader header;
  std::vector<std::byte> body;
  int descriptor = -1;  // received with the message; owned by it

  Message() = default;
  Message(Message&& other) noexcept
      : header(other.header),
        body(std::move(other.body)),
        descriptor(std::exchange(other.descriptor, -1)) {}
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;
  Message& operator=(Message&&) = delete;
  ~Message();

  // The body's first bytes as a T, if it is long enough.
  template <class T>
  const T* as() const {
    return body.size() >= sizeof(T) ? reinterpret_cast<const T*>(body.data()) : nullptr;
  }
};

// The next request; nothing when the host has closed the socket.
std::optional<Message> receiveRequest();

void sendHello();
void sendReply(const Message& request, std::span<const std::byte> body);

// A block of memory that the host has handed over as a descriptor.
class SharedBlock {
 public:
  static std::optional<SharedBlock> map(int descriptor, std::size_t bytes, bool writable);
  SharedBlock(SharedBlock&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(other.size_) {}
  SharedBlock& operator=(SharedBlock&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  SharedBlock(const SharedBlock&) = delete;
  SharedBlock& operator=(const SharedBlock&) = delete;
  ~SharedBlock();

  std::byte* data() const { return data_; }
  std::span<const std::byte> bytes() const { return {data_, size_}; }

 private:
  SharedBlock(std::byte* data, std::size_t size) : data_(data), size_(size) {}

  std::byte* data_;
  std::size_t size_;
};

// The film of one request after the other. It stays mapped as long as it is the same: the kernel
// would look up all its pages again for each step.
class FilmBlock {
 public:
  // Null if it cannot be mapped.
  const SharedBlock* map(int descriptor, std::size_t bytes);
  void reset() { block_.reset(); }

 private:
  std::optional<SharedBlock> block_;
  std::uint64_t device_ = 0, node_ = 0;  // of what is mapped
};

}  // namespace pathmark
