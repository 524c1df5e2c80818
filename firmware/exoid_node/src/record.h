/// A thing as flash keeps it, with a number that counts its changes.

#pragma once

#include "checksum.h"

namespace exoid {

/// How a thing becomes bytes: `FORMAT` of them, their `SIZE`, the `SEED` of their checksum,
/// `put(thing, bytes)` and `get(bytes)`.
template <class Thing>
struct Coding;

template <class Thing>
inline bool are_equal(const Thing& one, const Thing& other) {
  uint8_t bytes[2][Coding<Thing>::SIZE];
  Coding<Thing>::put(one, bytes[0]);
  Coding<Thing>::put(other, bytes[1]);
  for (uint32_t at = 0; at < sizeof bytes[0]; ++at) {
    if (bytes[0][at] != bytes[1][at]) return false;
  }
  return true;
}

template <class Thing>
struct Record {
  static constexpr uint32_t HEAD = 3;  // bytes before the thing: format and changes
  static constexpr uint32_t CONTENT = HEAD + Coding<Thing>::SIZE;
  static constexpr uint32_t SIZE = CONTENT + 2;
  uint8_t bytes[SIZE];
};

template <class Thing>
inline Record<Thing> record_of(const Thing& thing, uint16_t change) {
  Record<Thing> record = {{Coding<Thing>::FORMAT, static_cast<uint8_t>(change),
                           static_cast<uint8_t>(change >> 8)}};
  Coding<Thing>::put(thing, record.bytes + Record<Thing>::HEAD);
  const uint16_t crc = checksum(record.bytes, Record<Thing>::CONTENT, Coding<Thing>::SEED);
  record.bytes[Record<Thing>::CONTENT] = static_cast<uint8_t>(crc);
  record.bytes[Record<Thing>::CONTENT + 1] = static_cast<uint8_t>(crc >> 8);
  return record;
}

/// Reads a record. Returns false, and leaves both alone, where it is not whole.
template <class Thing>
inline bool read_record(const Record<Thing>& record, Thing& thing, uint16_t& change) {
  const uint8_t *bytes = record.bytes, *told = bytes + Record<Thing>::CONTENT;
  const uint16_t crc = static_cast<uint16_t>(told[0] | (told[1] << 8));
  if (bytes[0] != Coding<Thing>::FORMAT) return false;
  if (crc != checksum(bytes, Record<Thing>::CONTENT, Coding<Thing>::SEED)) return false;
  change = static_cast<uint16_t>(bytes[1] | (bytes[2] << 8));
  thing = Coding<Thing>::get(bytes + Record<Thing>::HEAD);
  return true;
}

}  // namespace exoid
