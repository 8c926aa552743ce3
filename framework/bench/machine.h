// What a measurement was made on, in one line; how much memory is free.
#pragma once

#include <cstdint>
#include <string>

namespace pathmark::bench {

// Processor, processors, vector instructions, compiler, build, Embree.
std::string machineLine();

// What the system could still give to a program; nothing is known of it: a lot.
std::uint64_t availableMemory();

}  // namespace pathmark::bench
