#include "record/record.h"

#include <algorithm>
#include <iterator>

namespace pathmark::record {

namespace {

struct VerdictName {
  Verdict verdict;
  std::string_view name;
};

constexpr VerdictName kVerdicts[] = {
    {Verdict::kOk, "ok"},
    {Verdict::kUndecided, "undecided"},
    {Verdict::kBlocked, "blocked"},
    {Verdict::kNotWritten, "not written"},
    {Verdict::kWrong, "wrong"},
    {Verdict::kDoesNotCompile, "does not compile"},
    {Verdict::kCrashed, "crashed"},
    {Verdict::kTimeLimit, "time limit"},
    {Verdict::kMemoryLimit, "memory limit"},
    {Verdict::kOutputLimit, "output limit"},
    {Verdict::kForbiddenCall, "forbidden call"},
    {Verdict::kInternalError, "internal error"},
};

struct DomainName {
  SampleDomain domain;
  std::string_view name;
};

constexpr DomainName kDomains[] = {
    {SampleDomain::kSphere, "sphere"},
    {SampleDomain::kHemisphere, "hemisphere"},
    {SampleDomain::kPlane, "plane"},
};

}  // namespace

std::string_view nameOf(Verdict verdict) {
  for (const VerdictName& v : kVerdicts)
    if (v.verdict == verdict) return v.name;
  return {};
}

std::optional<Verdict> verdictNamed(std::string_view name) {
  for (const VerdictName& v : kVerdicts)
    if (v.name == name) return v.verdict;
  return std::nullopt;
}

bool worseThan(Verdict a, Verdict b) { return a > b; }

std::string_view nameOf(SampleDomain domain) {
  for (const DomainName& d : kDomains)
    if (d.domain == domain) return d.name;
  return {};
}

std::optional<SampleDomain> domainNamed(std::string_view name) {
  for (const DomainName& d : kDomains)
    if (d.name == name) return d.domain;
  return std::nullopt;
}

}  // namespace pathmark::record
