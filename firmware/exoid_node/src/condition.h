/// How the node fares: why it started, and what it had to set up again.

#pragma once

#include "exo_can.h"

namespace exoid {

/// `Watchdog` has `has_reset()` and `supply_dipped()`, `Bus` has `releases()`, and `Can` has
/// `starts()`, `is_passive()` and `is_off()`.
template <class Watchdog, class Bus, class Can>
class Condition {
 public:
  Condition(const Watchdog& watchdog, const Bus& bus, const Can& can)
      : watchdog_(watchdog), bus_(bus), can_(can) {}

  void describe(Health& health) const {
    health.watchdog_reset = watchdog_.has_reset();
    health.brown_out_reset = watchdog_.supply_dipped();
    health.can_passive = can_.is_passive();
    health.can_off = can_.is_off();
    health.bus_releases = bus_.releases();
    health.can_starts = can_.starts();
  }

 private:
  const Watchdog& watchdog_;
  const Bus& bus_;
  const Can& can_;
};

}  // namespace exoid
