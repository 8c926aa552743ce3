// writeStressChapter: what bench stress has found, as a chapter of the handouts.
#pragma once

#include "bench/report.h"

#include <filesystem>

namespace pathmark::bench {

// Throws ImageError if the file cannot be written.
void writeStressChapter(const std::filesystem::path& file, const Report& report);

}  // namespace pathmark::bench
