// The tier with namespaces, made by bubblewrap.
#pragma once

#include "sandbox/shut_in.h"

#include <filesystem>

namespace pathmark::sandbox {

// Empty if it is not installed.
std::filesystem::path findBubblewrap();

class BubblewrapTier : public ShutIn {
 public:
  explicit BubblewrapTier(const Limits& limits);

  std::string name() const override;

 protected:
  Started start(Launch launch) override;

 private:
  std::filesystem::path bubblewrap_;
  CallFilter workerFilter_, toolFilter_;
};

}  // namespace pathmark::sandbox
