/// How the node fares: why it started, what it had to set up again, and its CAN controller.

#pragma once

#include "exo_can.h"

namespace exoid {

/// `Watchdog` has `has_reset()` and `supply_dipped()`, `Bus` has `releases()`, and `Can` has
/// `is_up()`, `starts()`, `is_off()`, `transmit_errors()` and `receive_errors()`.
template <class Watchdog, class Bus, class Can>
class Condition {
 public:
  Condition(const Watchdog& watchdog, const Bus& bus, const Can& can)
      : watchdog_(watchdog), bus_(bus), can_(can) {}

  void describe(Health& health) const {
    health.watchdog_reset = watchdog_.has_reset();
    health.brown_out_reset = watchdog_.supply_dipped();
    health.on_can = can_.is_up();
    health.can_off = can_.is_off();
    health.bus_releases = bus_.releases();
    health.can_starts = can_.starts();
    health.transmit_errors = can_.transmit_errors();
    health.receive_errors = can_.receive_errors();
  }

 private:
  const Watchdog& watchdog_;
  const Bus& bus_;
  const Can& can_;
};

constexpr uint32_t ERROR_PASSIVE = 127;  // above it a controller no longer stops others' frames

/// Whether a CAN controller that was there is gone, off the bus, or nearly.
inline bool is_bus_ill(const Health& health) {
  const bool gone = health.can_starts > 0 && !health.on_can;
  return gone || health.can_off || health.transmit_errors > ERROR_PASSIVE ||
         health.receive_errors > ERROR_PASSIVE;
}

}  // namespace exoid
