// The folder where compiled coursework is kept, so that it does not grow without end.
#pragma once

#include <filesystem>

namespace pathmark {

// Notes that an entry has been used just now.
void markUsed(const std::filesystem::path& entry);

// Removes entries of the folder beyond the newest few hundred, unless they were used within the
// last hour, and beyond the newest few gigabytes, unless they were used within the last quarter of
// one: a run that goes on, in this process or another, may be about to link or start them.
void pruneCache(const std::filesystem::path& folder);

}  // namespace pathmark
