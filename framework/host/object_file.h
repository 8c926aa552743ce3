// What comes out of a compiler that has read untrusted files.
//
//   takeFile          moves what a step has made to its place, and follows no link
//   objectComplaint   what is wrong with a file that should be an object of plain machine code
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace pathmark {

// Copies a regular file of at most `largest` bytes; `to` appears as a whole or not at all. Returns
// whether there was one. Throws std::system_error where `to` cannot be written.
bool takeFile(const std::filesystem::path& from, const std::filesystem::path& to,
              std::size_t largest);

// Nothing, of a relocatable ELF file without code for the linker's plug-ins, without a loader of
// its own, and without functions that run before the program has begun: the linker would read
// anything else as a script, and the worker's own locks would come too late. A file may also be too
// large: objects are kept.
std::optional<std::string> objectComplaint(std::span<const std::byte> bytes);
std::optional<std::string> objectComplaint(const std::filesystem::path& file);

}  // namespace pathmark
