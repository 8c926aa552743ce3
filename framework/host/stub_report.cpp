#include "host/stub_report.h"

#include <algorithm>
#include <string_view>

namespace pathmark {

bool StubReport::isUnwritten(CourseworkFunction f) const {
  return std::any_of(unwritten.begin(), unwritten.end(),
                     [f](const FunctionContract& c) { return c.function == f; });
}

bool isUsed(const FunctionContract& f, Estimator estimator, LightSampling lights) {
  if ((f.part == 0) != (estimator == Estimator::kWarmUp)) return false;
  // Other ways of rendering than renderPixel make the camera rays themselves.
  if (f.part == 1) return estimator == Estimator::kPath;
  if (f.function == CourseworkFunction::kTracePath) return estimator != Estimator::kMis;
  if (f.part == 8) return estimator == Estimator::kMis;
  if (f.part == 9) return lights == LightSampling::kBySolidAngle;
  return true;
}

StubReport makeStubReport(std::span<const StubRecord> records) {
  StubReport report;
  for (const FunctionContract& c : contract()) {
    const bool marked = std::any_of(records.begin(), records.end(), [&](const StubRecord& r) {
      return std::string_view(r.function) == c.name;
    });
    if (marked) report.unwritten.push_back(c);
  }
  return report;
}

}  // namespace pathmark
