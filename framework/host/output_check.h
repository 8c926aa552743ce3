// refuseOutput: what can be known before the work begins must not cost a picture afterwards.
#pragma once

#include <cstdint>
#include <filesystem>

namespace pathmark {

// Throws UsageError for a name that cannot be meant, and ImageError where the machine would not
// take such a picture: a folder that cannot be written to, a full file system.
void refuseOutput(const std::filesystem::path& output, std::uint64_t pixels);

}  // namespace pathmark
