/// How the CAN controller fares.

#pragma once

#include <stdint.h>

namespace exoid {

struct BusHealth {
  bool on_can;  // else there is no controller, and frames go over USB
  uint8_t transmit_errors;
  uint8_t receive_errors;
  bool off;  // the controller has left the bus
};

/// Above it a controller no longer stops the frames of others.
constexpr uint8_t ERROR_PASSIVE = 127;

inline bool is_ill(const BusHealth& bus) {
  return bus.off || bus.transmit_errors > ERROR_PASSIVE || bus.receive_errors > ERROR_PASSIVE;
}

}  // namespace exoid
