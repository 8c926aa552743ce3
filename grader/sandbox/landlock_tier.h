// The tier without namespaces.
#pragma once

#include "sandbox/shut_in.h"

namespace pathmark::sandbox {

class LandlockTier : public ShutIn {
 public:
  explicit LandlockTier(const Limits& limits);

  std::string name() const override;

 protected:
  Started start(Launch launch) override;

 private:
  CallFilter workerFilter_, toolFilter_;
};

}  // namespace pathmark::sandbox
