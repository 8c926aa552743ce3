// Compiling one part of a coursework.
#pragma once

#include "host/coursework_builder.h"

#include <memory>

namespace pathmark {

// Fills in what becomes of the part's source: its object, or what the compiler says. In the
// confinement, where there is one, nothing of whose work is believed.
void buildPart(PartBuild& part, const std::shared_ptr<Confinement>& confinement);

}  // namespace pathmark
