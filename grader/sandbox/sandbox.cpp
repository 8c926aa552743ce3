#include "sandbox/sandbox.h"

#include "host/workshop.h"
#include "sandbox/bubblewrap_tier.h"
#include "sandbox/landlock.h"
#include "sandbox/landlock_tier.h"
#include "sandbox/self_test.h"

#include <fmt/format.h>

#include <array>
#include <exception>

namespace pathmark::sandbox {

namespace {

std::shared_ptr<Confinement> make(Tier tier, const Limits& limits) {
  if (tier == Tier::kBubblewrap) return std::make_shared<BubblewrapTier>(limits);
  if (landlockVersion() == 0)
    throw ConfinementError("the kernel has no Landlock, or not switched on");
  return std::make_shared<LandlockTier>(limits);
}

// The sandbox, or nothing and why. A build folder that cannot be written is no fault of the tier,
// and none would do without it.
std::shared_ptr<Confinement> tryTier(Tier tier, const Limits& limits, std::string& why) {
  std::string failure;
  try {
    const auto confinement = make(tier, limits);
    failure = selfTest(*confinement);
    if (failure.empty()) return confinement;
  } catch (const BuildFolderError&) {
    throw;
  } catch (const std::exception& e) {
    failure = e.what();
  }
  while (!failure.empty() && (failure.back() == '.' || failure.back() == '\n')) failure.pop_back();
  why += fmt::format("{}{}: {}", why.empty() ? "" : "; ", nameOf(tier), failure);
  return nullptr;
}

constexpr std::array kStrongestFirst{Tier::kBubblewrap, Tier::kLandlock};

}  // namespace

std::string_view nameOf(Tier tier) {
  switch (tier) {
    case Tier::kBubblewrap:
      return "bubblewrap";
    case Tier::kLandlock:
      return "Landlock";
    case Tier::kNone:
      break;
  }
  return "none";
}

std::shared_ptr<Confinement> openSandbox(std::optional<Tier> wanted, const Limits& limits) {
  std::string why;
  for (const Tier tier : kStrongestFirst)
    if (!wanted || wanted == tier)
      if (auto confinement = tryTier(tier, limits, why)) return confinement;
  throw ConfinementError(
      fmt::format("Submissions cannot be shut in on this machine ({}). Installing bubblewrap, or a "
                  "kernel with Landlock, helps; with --unsafe they are compiled and run without a "
                  "sandbox, which gives them everything that you may do.",
                  why));
}

Opened openStrongest(bool allowUnsafe, const Limits& limits) {
  try {
    auto confinement = openSandbox(std::nullopt, limits);
    const Tier tier =
        confinement->name() == nameOf(Tier::kBubblewrap) ? Tier::kBubblewrap : Tier::kLandlock;
    return {std::move(confinement), tier};
  } catch (const ConfinementError&) {
    if (!allowUnsafe) throw;
    return {};
  }
}

}  // namespace pathmark::sandbox
