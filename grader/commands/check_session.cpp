#include "commands/check_session.h"

#include <utility>

namespace pathmark {

namespace fs = std::filesystem;

namespace {

// An object is named by the hash of what it was made from. What does not compile has none.
std::string identity(const PartBuild& part) {
  return part.compiled ? part.object.string() : part.messages;
}

checks::PartResult* find(checks::CourseworkResults& results, int part) {
  for (checks::PartResult& p : results.parts)
    if (p.part.part == part) return &p;
  return nullptr;
}

}  // namespace

CheckSession::CheckSession(fs::path folder, checks::Selection selection, checks::RunOptions options)
    : folder_(std::move(folder)),
      selection_(std::move(selection)),
      options_(std::move(options)),
      madeOf_(parts().size()) {}

const checks::CourseworkResults& CheckSession::run(const checks::RunEvents& events) {
  const CourseworkBuild build = buildCoursework(folder_, Incomplete::kCompileOnly);
  checks::Selection changed = selection_;
  changed.parts.clear();
  for (const int part : selection_.parts) {
    const auto number = static_cast<std::size_t>(part);
    const std::string now = identity(build.parts[number]);
    if (now != madeOf_[number] || !find(results_, part)) changed.parts.push_back(part);
    madeOf_[number] = now;
  }
  checks::RunOptions options = options_;
  options.known = &results_;
  results_ = checks::runChecks(build, changed, options, events);
  return results_;
}

}  // namespace pathmark
