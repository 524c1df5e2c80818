/// What is commissioned of a node, and how it is kept.

#pragma once

#include "can_clock.h"
#include "can_timing.h"
#include "config.h"
#include "constants.h"
#include "record.h"

namespace exoid {

struct NodeSettings {
  uint16_t zero;     // own count of the encoder where the knee is fully extended
  bool reversed;     // the count falls while the knee extends
  uint8_t node_id;   // which of the nodes of a bus this is
  uint8_t bit_rate;  // of the CAN bus, counts of BIT_RATE_STEP
};

/// Those of a node that has stored none.
constexpr NodeSettings BUILT_IN = {static_cast<uint16_t>(config::ENCODER_ZERO),
                                   config::ENCODER_SIGN < 0, 0,
                                   static_cast<uint8_t>(config::CAN_BIT_RATE / BIT_RATE_STEP)};

static_assert(CanTiming<CAN_CLOCK, config::CAN_BIT_RATE>::QUANTA > 0,
              "the built-in bit rate is one that the controller can do");

/// Whether the controller can keep this bit rate, in counts of BIT_RATE_STEP, of which the usual ones
/// are a power of two.
inline bool is_bit_rate(uint32_t count) {
  constexpr uint32_t HIGHEST = 8;
  const bool usual = count > 0 && count <= HIGHEST && (count & (count - 1)) == 0;
  return usual && best_quanta(CAN_CLOCK, count * BIT_RATE_STEP) != 0;
}

/// The bytes that keep settings.
template <>
struct Coding<NodeSettings> {
  static constexpr uint8_t FORMAT = 1;
  static constexpr uint32_t SIZE = 5;
  static constexpr uint16_t SEED = CRC_SEED;

  static void put(const NodeSettings& settings, uint8_t* bytes) {
    bytes[0] = static_cast<uint8_t>(settings.zero);
    bytes[1] = static_cast<uint8_t>(settings.zero >> 8);
    bytes[2] = static_cast<uint8_t>(settings.reversed ? 1 : 0);
    bytes[3] = settings.node_id;
    bytes[4] = settings.bit_rate;
  }

  static NodeSettings get(const uint8_t* bytes) {
    return {static_cast<uint16_t>(bytes[0] | (bytes[1] << 8)), bytes[2] != 0, bytes[3], bytes[4]};
  }
};

}  // namespace exoid
