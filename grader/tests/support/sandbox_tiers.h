// The tiers of the sandbox that must hold on this machine, each opened once for all tests.
#pragma once

#include "sandbox/sandbox.h"

#include <memory>
#include <vector>

namespace pathmark::test {

// Bubblewrap where it is installed and the kernel gives namespaces to those who are not root;
// Landlock where the kernel has it. At least one of them: a machine without is no place for tests
// of the sandbox.
std::vector<sandbox::Tier> expectedTiers();

// Throws ConfinementError if the tier does not hold.
std::shared_ptr<Confinement> sandboxOf(sandbox::Tier tier);

}  // namespace pathmark::test
