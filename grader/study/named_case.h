// NamedCase: what the diagnosis says of a file with known mistakes.
#pragma once

#include <string>

namespace pathmark::study {

// What is said of the functions of a file with a mistake.
enum class Named {
  kRight,    // the mistake, or a pair of which it is one
  kWrong,    // another one, of any of the functions
  kNothing,  // nothing clear
  kUnseen,   // no check fails: the difference has mended the mistake
};

struct NamedCase {
  std::string name;
  std::string mistake;                   // that is made; of two the second
  Named known = Named::kNothing;         // by the whole catalogue
  Named leftOut = Named::kNothing;       // without the mistakes that are made
  Named leftOutAlike = Named::kNothing;  // without those that look the same, either
  std::string words;                     // which names were given, where they are not the right one
};

}  // namespace pathmark::study
