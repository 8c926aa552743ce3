#include "diagnosis/probes.h"

#include <array>

namespace pathmark::diagnosis {

Signature probe(WorkerProcess& worker, CourseworkFunction function, ProbeSeed seed) {
  constexpr std::array kParts{probePart0, probePart1, probePart2, probePart3, probePart4,
                              probePart5, probePart6, probePart8, probePart9};
  const std::size_t place = placeOfPart(contractOf(function).part);
  return kParts.at(place)({worker, function, static_cast<std::uint64_t>(seed)});
}

}  // namespace pathmark::diagnosis
