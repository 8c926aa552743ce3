// Whether a sandbox holds: programs that try to get out are sent in.
#pragma once

#include "host/confinement.h"

#include <string>

namespace pathmark::sandbox {

// Empty if it holds; else what could be done in it that must not, or could not that must. Throws
// what the confinement throws.
std::string selfTest(Confinement& confinement);

}  // namespace pathmark::sandbox
