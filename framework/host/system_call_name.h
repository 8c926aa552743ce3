// How system calls are called that coursework has no business with.
#pragma once

#include <string>

namespace pathmark {

// "fork", or "number 400".
std::string systemCallName(int number);

}  // namespace pathmark
