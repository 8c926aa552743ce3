// How many rays the calling thread has traced: camera, bounce and shadow rays.
//
// A count in each thread, because the coursework's functions are handed a scene that all threads
// share and that nothing may be written to.
#pragma once

#include <cstdint>

namespace pathmark {

std::uint64_t raysOfThisThread();
void countRaysOfThisThread(std::uint64_t rays);
void restartRayCount();

}  // namespace pathmark
