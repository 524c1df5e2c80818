/// CRC-16/CCITT-FALSE, of commands and of what is kept in flash.

#pragma once

#include "exo_commands.h"

namespace exoid {

inline uint16_t checksum(const uint8_t* bytes, uint32_t count, uint16_t seed = CRC_SEED) {
  uint32_t crc = seed;
  for (uint32_t at = 0; at < count; ++at) {
    crc ^= static_cast<uint32_t>(bytes[at]) << 8U;
    for (uint32_t bit = 0; bit < 8; ++bit) {
      crc = (crc & 0x8000U) != 0 ? (crc << 1U) ^ CRC_POLYNOMIAL : crc << 1U;
    }
  }
  return static_cast<uint16_t>(crc);
}

/// Whether a frame has a command's identifier and a command's check.
inline bool is_command(const Frame& frame) {
  constexpr uint32_t KEPT = (1U << CHECK_LENGTH) - 1U;
  return CommandIds::has(frame.id) &&
         get(frame, CHECKED_BYTES * 8, CHECK_LENGTH) ==
             (checksum(frame.data, CHECKED_BYTES) & KEPT);
}

}  // namespace exoid
