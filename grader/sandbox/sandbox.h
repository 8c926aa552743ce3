// The sandbox in which submitted coursework is compiled, linked and run.
//
//   Tier          how it is shut in
//   openSandbox   the strongest tier that holds on this machine
//
// Bubblewrap: namespaces without network, host paths or other processes. Landlock: the same paths,
// sockets and signals refused by the kernel's access rules. Both with a filter of system calls,
// limits, an empty environment, and, where the host is run by root, an unprivileged user of its own
// for each program. A tier is believed only after programs that try to get out have failed in it.
#pragma once

#include "host/confinement.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace pathmark::sandbox {

enum class Tier { kBubblewrap, kLandlock, kNone };

// "bubblewrap", "Landlock", "none"
std::string_view nameOf(Tier tier);

struct Limits {
  double toolSeconds = 60.0;                       // of one step of compiling or linking
  std::size_t toolBytes = std::size_t{3} << 30;    // of address space
  std::size_t fileBytes = std::size_t{128} << 20;  // of a file that a step writes
};

// With the tier that is wanted, or the strongest. Throws ConfinementError, a sentence that says
// what is missing, if no such tier holds, and BuildFolderError.
std::shared_ptr<Confinement> openSandbox(std::optional<Tier> wanted = std::nullopt,
                                         const Limits& limits = {});

struct Opened {
  std::shared_ptr<Confinement> confinement;  // none with Tier::kNone
  Tier tier = Tier::kNone;
};

// As openSandbox; where nothing holds and `allowUnsafe` is given, none.
Opened openStrongest(bool allowUnsafe, const Limits& limits = {});

}  // namespace pathmark::sandbox
