// Which known mistake a signature shows.
//
//   distance    between two signatures, in standard errors
//   match       what the catalogue says of a signature
//   diagnose    the same in words
//
// A mistake is named only if all features agree with it, what is right is excluded, and every
// other mistake is excluded with a margin. Two mistakes that no probe tells apart are named
// together; where there are more, none is. What answers as the stub does, and as no
// known mistake, is the stub.
#pragma once

#include "diagnosis/catalogue.h"
#include "diagnosis/diagnosis.h"

#include <string>
#include <vector>

namespace pathmark::diagnosis {

// The largest over all features, so that one that disagrees decides.
double distance(const Signature& seen, const KnownSignature& known);

// The same of two known ones: whether no probe tells them apart.
bool looksLike(const KnownSignature& a, const KnownSignature& b);

// The feature that decides the distance, in words.
std::string farthest(const Signature& seen, const KnownSignature& known);

// With this distance at most a mistake explains what is seen; with that at least it does not.
// The first is exceeded by chance in some feature of 1000 once in a thousand probes (Student's
// distribution with 31 degrees of freedom and more).
inline constexpr double kAgrees = 6.0, kExcluded = 12.0;

struct Match {
  std::vector<const KnownSignature*> mistakes;  // one, or a few that look the same; or none
  double distance = 0.0;                        // of the first of them
  double distanceFromRight = 0.0;
};

// Mistakes for which `leftOut` says yes count as unknown.
Match match(const Signature& seen, const FunctionCatalogue& known,
            const std::vector<std::string>& leftOut = {});

Diagnosis diagnose(const Signature& seen, const FunctionCatalogue& known);

}  // namespace pathmark::diagnosis
