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
    const auto number = static_cast<std::size_t>(part);
    if (identity(build.parts[number]) != madeOf_[number] || !hasPart(results_, part))
      changed.push_back(part);
  }
  std::stable_partition(changed.begin(), changed.end(), [&](int part) {
    const auto number = static_cast<std::size_t>(part);
    return identity(build.parts[number]) != lastRun_[number];
  });
  return changed;
}

const checks::CourseworkResults& CheckSession::run(const CourseworkBuild& build,
                                                   const checks::RunEvents& events) {
  checks::Selection changed = selection_;
  changed.parts = changedParts(build);
  for (std::size_t part = 0; part < lastRun_.size(); ++part)
    lastRun_[part] = identity(build.parts[part]);
  checks::RunOptions options = options_;
  options.known = &results_;
  results_ = checks::runChecks(build, changed, options, events);
  for (const int part : changed.parts) {
    const auto number = static_cast<std::size_t>(part);
    madeOf_[number] = identity(build.parts[number]);
  }
  return results_;
}

}  // namespace pathmark
