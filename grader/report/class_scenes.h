// The scenes that a class has made, beside one another, for a person to judge.
#pragma once

#include "report/graded.h"
#include "report/html_text.h"

namespace pathmark::report {

// Nothing if nobody has handed in a scene of which there is a picture.
Markup classScenes(GradedClass graded);

}  // namespace pathmark::report
