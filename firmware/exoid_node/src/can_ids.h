/// The identifiers of the CAN frames that the node understands.

#pragma once

#include <stdint.h>

namespace exoid {

constexpr uint16_t NO_CAN_ID = 0x7FF;  // ISO 11898 forbids seven recessive bits at the begin

/// The bits in which identifiers differ.
constexpr uint16_t differing() { return 0; }
constexpr uint16_t differing(uint16_t) { return 0; }
template <class... Rest>
constexpr uint16_t differing(uint16_t first, uint16_t next, Rest... rest) {
  return static_cast<uint16_t>((first ^ next) | differing(first, rest...));
}

constexpr uint32_t bits_in(uint32_t word) {
  return word == 0 ? 0 : (word & 1U) + bits_in(word >> 1);
}

/// `CanIds<>` understands nothing.
template <uint16_t... IDS>
struct CanIds {
  static constexpr uint8_t COUNT = sizeof...(IDS);

  /// The bits in which all agree, and whether no other identifier agrees in these.
  static constexpr uint16_t SHARED = static_cast<uint16_t>(NO_CAN_ID & ~differing(IDS...));
  static constexpr bool ARE_ALL_THAT_SHARE = COUNT == 1U << bits_in(differing(IDS...));

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
