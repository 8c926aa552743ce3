// A process between fork and exec: descriptors, limits, user, rules, filter.
//
//   ChildPlan    what becomes of it, prepared before the fork
//   startChild   forks
#pragma once

#include "host/shared_memory.h"
#include "sandbox/call_filter.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>
#include <sys/types.h>

namespace pathmark::sandbox {

struct Limit {
  decltype(RLIMIT_CORE) what;
  rlim_t value;
};

struct ChildPlan {
  std::vector<std::string> arguments;
  std::vector<std::string> environment;
  std::string folder = "/";
  int program = -1;  // an open file to execute; none: the first argument names it

  // Descriptor here -> number there; all others are closed.
  struct Placed {
    int here, there;
  };
  std::vector<Placed> descriptors;

  std::vector<Limit> limits;
  std::optional<uid_t> user;  // to become, with the group of the same number
  bool powerless = false;     // where it stays root: without root's capabilities, for good
  int rules = -1;             // of Landlock
  CallFilter filter;          // empty: none
};

// Returns when the program has begun; it leads a group of its own and dies with the calling thread.
// Throws ConfinementError if it could not begin, and std::system_error.
pid_t startChild(const ChildPlan& plan);

}  // namespace pathmark::sandbox
