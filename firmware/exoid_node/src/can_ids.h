/// The identifiers of the CAN frames that the node understands.

#pragma once

#include <stdint.h>

namespace exoid {

constexpr uint16_t NO_CAN_ID = 0x7FF;  // ISO 11898 forbids seven recessive bits at the begin

/// `CanIds<>` understands nothing.
template <uint16_t... IDS>
struct CanIds {
  static constexpr uint8_t COUNT = sizeof...(IDS);

  /// The identifier of one of a controller's filters; those beyond the list repeat its first.
  static uint16_t filter(uint8_t at) {
    const uint16_t ids[] = {IDS..., NO_CAN_ID};
    return ids[at < COUNT ? at : 0];
  }

  static bool has(uint16_t id) {
    const uint16_t ids[] = {IDS..., NO_CAN_ID};
    for (uint8_t at = 0; at < COUNT; ++at) {
      if (ids[at] == id) return true;
    }
    return false;
  }
};

}  // namespace exoid
