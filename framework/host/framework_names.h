// What coursework must not reach by its name: the inside of the framework that it is linked with,
// such as the count of its rays.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace pathmark {

// The first name of the framework that this object uses, as a person reads it, and that no header
// of framework/include/pathmark/ declares; nothing if there is none. What no one offers is found by
// the linker. Throws std::system_error if the framework's own objects cannot be read.
std::optional<std::string> hiddenNameUsedBy(std::span<const std::byte> object);

}  // namespace pathmark
