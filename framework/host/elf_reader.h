// Reading object files that nobody vouches for: whatever they say, nothing is read outside of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>

#include <elf.h>

namespace pathmark::elf {

// A table's entry, if all of it lies within the file.
template <class T>
std::optional<T> at(std::span<const std::byte> bytes, std::uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(T)) return std::nullopt;
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// Empty where there is none.
inline std::string_view nameAt(std::span<const std::byte> bytes, const Elf64_Shdr& strings,
                               std::uint32_t index) {
  if (strings.sh_offset > bytes.size() || strings.sh_size > bytes.size() - strings.sh_offset ||
      index >= strings.sh_size)
    return {};
  const char* first = reinterpret_cast<const char*>(bytes.data()) + strings.sh_offset + index;
  return {first, strnlen(first, strings.sh_size - index)};
}

inline bool isRelocatable(const Elf64_Ehdr& header) {
  return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 &&
         header.e_ident[EI_CLASS] == ELFCLASS64 && header.e_type == ET_REL &&
         header.e_shentsize == sizeof(Elf64_Shdr);
}

inline std::optional<Elf64_Shdr> sectionAt(std::span<const std::byte> bytes,
                                           const Elf64_Ehdr& header, std::uint64_t index) {
  return at<Elf64_Shdr>(bytes, header.e_shoff + index * sizeof(Elf64_Shdr));
}

}  // namespace pathmark::elf
