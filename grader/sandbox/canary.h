// What the canary and those who send it in agree on.
#pragma once

#include <string_view>

namespace pathmark::sandbox {

// read and write files outside, open a socket (n), see the environment, reach another process (p),
// find a stray descriptor, lift limits, make a user namespace, fork, start a thread, and write in
// the scratch folder.
inline constexpr std::string_view kAttempts =
    "rwnepdluf"
    "ts";

// What must work.
inline constexpr std::string_view kWorkerMust = "t", kToolMust = "fts";

struct CanaryTask {
  char outside[1024] = {};  // a folder of the host with a file "canary" in it
  char scratch[1024] = {};
  int process = 0;  // the host's
};

// "reading a file outside"
constexpr std::string_view attemptInWords(char what) {
  switch (what) {
    case 'r':
      return "reading a file outside";
    case 'w':
      return "writing a file outside";
    case 'n':
      return "opening a socket";
    case 'e':
      return "seeing the environment";
    case 'p':
      return "reaching another process";
    case 'd':
      return "finding an open file of the host";
    case 'l':
      return "lifting its limits";
    case 'u':
      return "making a namespace";
    case 'f':
      return "starting a process";
    case 't':
      return "starting a thread";
    default:
      return "writing in its own folder";
  }
}

}  // namespace pathmark::sandbox
