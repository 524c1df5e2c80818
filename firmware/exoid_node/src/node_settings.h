/// What is commissioned of a node, and the record that keeps it.

#pragma once

#include "can_clock.h"
#include "can_timing.h"
#include "checksum.h"
#include "config.h"
#include "constants.h"

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

inline bool operator==(const NodeSettings& a, const NodeSettings& b) {
  return a.zero == b.zero && a.reversed == b.reversed && a.node_id == b.node_id &&
         a.bit_rate == b.bit_rate;
}

/// Whether the controller can keep this bit rate, in counts of BIT_RATE_STEP, of which the usual ones
/// are a power of two.
inline bool is_bit_rate(uint32_t count) {
  constexpr uint32_t HIGHEST = 8;
  const bool usual = count > 0 && count <= HIGHEST && (count & (count - 1)) == 0;
  return usual && best_quanta(CAN_CLOCK, count * BIT_RATE_STEP) != 0;
}

/// The bytes that keep settings, with a number that counts the changes.
struct Record {
  static constexpr uint32_t SIZE = 10;
  uint8_t bytes[SIZE];
};

constexpr uint8_t RECORD_FORMAT = 1;
constexpr uint32_t RECORD_CONTENT = Record::SIZE - 2;  // bytes before the checksum

inline Record record_of(const NodeSettings& settings, uint16_t change) {
  Record record = {{RECORD_FORMAT, static_cast<uint8_t>(change),
                    static_cast<uint8_t>(change >> 8), static_cast<uint8_t>(settings.zero),
                    static_cast<uint8_t>(settings.zero >> 8),
                    static_cast<uint8_t>(settings.reversed ? 1 : 0), settings.node_id,
                    settings.bit_rate, 0, 0}};
  const uint16_t crc = checksum(record.bytes, RECORD_CONTENT);
  record.bytes[RECORD_CONTENT] = static_cast<uint8_t>(crc);
  record.bytes[RECORD_CONTENT + 1] = static_cast<uint8_t>(crc >> 8);
  return record;
}

/// Reads a record. Returns false, and leaves both alone, where it is not whole.
inline bool read_record(const Record& record, NodeSettings& settings, uint16_t& change) {
  const uint8_t* bytes = record.bytes;
  const uint16_t crc = static_cast<uint16_t>(bytes[RECORD_CONTENT] |
                                             (bytes[RECORD_CONTENT + 1] << 8));
  if (bytes[0] != RECORD_FORMAT || crc != checksum(bytes, RECORD_CONTENT)) return false;
  change = static_cast<uint16_t>(bytes[1] | (bytes[2] << 8));
  settings.zero = static_cast<uint16_t>(bytes[3] | (bytes[4] << 8));
  settings.reversed = bytes[5] != 0;
  settings.node_id = bytes[6];
  settings.bit_rate = bytes[7];
  return true;
}

}  // namespace exoid
