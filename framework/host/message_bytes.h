// Structures of the protocol as the bytes of messages.
#pragma once

#include <cstddef>
#include <cstring>
#include <span>

namespace pathmark {

template <class T>
std::span<const std::byte> bytesOf(const T& value) {
  return std::as_bytes(std::span(&value, 1));
}

// There must be as many.
template <class T>
T valueOf(std::span<const std::byte> bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

}  // namespace pathmark
