/// The frame in a line of slcan.

#pragma once

#include <stddef.h>

#include "frame.h"

namespace exoid {

/// The value of a hexadecimal digit; more than 15 for any other character.
inline uint32_t digit_of(char character) {
  if (character >= '0' && character <= '9') return static_cast<uint32_t>(character - '0');
  if (character >= 'a' && character <= 'f') return static_cast<uint32_t>(character - 'a' + 10);
  if (character >= 'A' && character <= 'F') return static_cast<uint32_t>(character - 'A' + 10);
  return 16;
}

/// Reads a line that sends a frame of eight bytes with a standard identifier, as every command is.
/// Returns false where it is anything else.
inline bool read_frame(const char* line, size_t length, Frame& frame) {
  constexpr size_t HEAD = 5, SIZE = HEAD + 2 * sizeof(frame.data);  // t, identifier, length
  if (length != SIZE || line[0] != 't' || line[4] != '8') return false;
  uint32_t id = 0;
  for (size_t at = 1; at < SIZE; ++at) {
    const uint32_t digit = digit_of(line[at]);
    if (digit > 15) return false;
    if (at < HEAD - 1) id = id << 4U | digit;
    if (at < HEAD) continue;
    uint8_t& byte = frame.data[(at - HEAD) / 2];
    byte = static_cast<uint8_t>((at - HEAD) % 2 == 0 ? digit << 4U : byte | digit);
  }
  frame.id = static_cast<uint16_t>(id);
  return id <= 0x7FF;
}

}  // namespace exoid
