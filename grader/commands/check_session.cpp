#include "commands/check_session.h"

#include <algorithm>
#include <utility>

namespace pathmark {

namespace {

// An object is named by the hash of what it was made from. What does not compile has none.
std::string identity(const PartBuild& part) {
  return part.compiled ? part.object.string() : part.messages;
}

bool hasPart(const checks::CourseworkResults& results, int part) {
  return std::any_of(results.parts.begin(), results.parts.end(),
                     [&](const checks::PartResult& p) { return p.part.part == part; });
}

}  // namespace

CheckSession::CheckSession(checks::Selection selection, checks::RunOptions options)
    : selection_(std::move(selection)),
      options_(std::move(options)),
      madeOf_(parts().size()),
      lastRun_(parts().size()) {}

std::vector<int> CheckSession::changedParts(const CourseworkBuild& build) const {
  std::vector<int> changed;
  for (const int part : selection_.parts) {
    const std::size_t place = placeOfPart(part);
    if (identity(build.parts[place]) != madeOf_[place] || !hasPart(results_, part))
      changed.push_back(part);
  }
  std::stable_partition(changed.begin(), changed.end(), [&](int part) {
    const std::size_t place = placeOfPart(part);
    return identity(build.parts[place]) != lastRun_[place];
  });
  return changed;
}

const checks::CourseworkResults& CheckSession::run(const CourseworkBuild& build,
                                                   const checks::RunEvents& events) {
  checks::Selection changed = selection_;
  changed.parts = changedParts(build);
  for (std::size_t place = 0; place < lastRun_.size(); ++place)
    lastRun_[place] = identity(build.parts[place]);
  checks::RunOptions options = options_;
  options.known = &results_;
  results_ = checks::runChecks(build, changed, options, events);
  for (const int part : changed.parts) {
    const std::size_t place = placeOfPart(part);
    madeOf_[place] = identity(build.parts[place]);
  }
  return results_;
}

}  // namespace pathmark
