#include "diagnosis/probes.h"

#include <array>

namespace pathmark::diagnosis {

Signature probe(WorkerProcess& worker, CourseworkFunction function, ProbeSeed seed) {
  constexpr std::array kParts{probePart0, probePart1, probePart2, probePart3,
                              probePart4, probePart5, probePart6};
  const auto part = static_cast<std::size_t>(contractOf(function).part);
  return kParts.at(part)({worker, function, static_cast<std::uint64_t>(seed)});
}

}  // namespace pathmark::diagnosis
