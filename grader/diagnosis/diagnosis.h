// Which known mistake a wrong function makes.
//
//   Diagnosis      the mistake that is named, or none, with the evidence
//   kStub          the name of the mistake to hand in a stub as it is, but for its marker
#pragma once

#include <string>

namespace pathmark::diagnosis {

inline constexpr char kStub[] = "stub";

// Nothing is named where nothing matches clearly: a wrong name is worse than none.
struct Diagnosis {
  std::string mistake;   // its name in the catalogue, such as part3_angle_uniform; empty: none
  std::string what;      // in words: "the polar angle is uniform instead of the squared cosine"
  std::string evidence;  // what agrees: "mean of cos(theta) is 0.6366, as with this mistake; ..."
  std::string read;      // handout and section
};

}  // namespace pathmark::diagnosis
