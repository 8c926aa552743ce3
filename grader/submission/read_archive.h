// readArchive: the entries of a zip or tar, one after the other, nothing of it written anywhere.
//
// An archive is hostile until it is read: one compressed a thousand to one, one within itself, one
// that is cut off. Bytes are counted where they leave the decompressor, skipped ones included.
#pragma once

#include "submission/entry.h"

#include <filesystem>
#include <functional>
#include <string_view>

namespace pathmark::submission {

using TakeEntry = std::function<void(const Entry& entry, const ReadEntry& read)>;

// Throws Refusal if it cannot be read to its end, or is beyond the limits.
void readArchive(const std::filesystem::path& file, const Limits& limits, const TakeEntry& take);

// Whether a file's first bytes are those of a zip, a tar, or a compressed file.
inline constexpr std::size_t kMagicBytes = 512;
bool looksLikeArchive(std::string_view firstBytes);

}  // namespace pathmark::submission
