/// A CAN frame, and how values become its bits: limited to their range, half away from zero.

#pragma once

#include <stdint.h>

namespace exoid {

/// A classic CAN frame of eight bytes with a standard identifier.
struct Frame {
  uint16_t id;
  uint8_t data[8];
};

/// Writes the low `length` bits of `value` from bit `start`; the frame must be 0 there.
inline void put(Frame& frame, uint32_t start, uint32_t length, uint32_t value) {
  while (length > 0) {
    const uint32_t shift = start % 8;
    const uint32_t taken = 8 - shift < length ? 8 - shift : length;
    const uint32_t bits = value & ((1U << taken) - 1U);
    frame.data[start / 8] = static_cast<uint8_t>(frame.data[start / 8] | (bits << shift));
    value >>= taken;
    start += taken;
    length -= taken;
  }
}

/// The `length` bits from bit `start` on.
inline uint32_t get(const Frame& frame, uint32_t start, uint32_t length) {
  uint32_t value = 0;
  for (uint32_t at = 0; at < length; ++at) {
    const uint32_t from = start + at;
    value |= ((frame.data[from / 8] >> (from % 8)) & 1U) << at;
  }
  return value;
}

/// The signed number whose low `length` bits, at most 31, these are.
inline int32_t with_sign(uint32_t bits, uint32_t length) {
  const int32_t value = static_cast<int32_t>(bits);
  return (bits >> (length - 1)) == 0 ? value : value - (INT32_C(1) << length);
}

inline uint32_t at_most(uint32_t value, uint32_t upper) { return value < upper ? value : upper; }

inline uint32_t within(int32_t value, int32_t lower, int32_t upper) {
  return static_cast<uint32_t>(value < lower ? lower : value < upper ? value : upper);
}

/// The nearest count, half away from zero; the limit beyond the range, the lower one for NaN.
inline uint32_t quantise(float counts, int32_t lower, int32_t upper) {
  if (!(counts > static_cast<float>(lower))) return static_cast<uint32_t>(lower);
  if (counts >= static_cast<float>(upper)) return static_cast<uint32_t>(upper);
  const int32_t whole = static_cast<int32_t>(counts);
  const float rest = counts - static_cast<float>(whole);
  return static_cast<uint32_t>(whole + (rest >= 0.5F ? 1 : 0) - (rest <= -0.5F ? 1 : 0));
}

/// A float32 as it is sent whole.
inline uint32_t float_bits(float value) {
  uint32_t bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// Whether `quantise` does not cut the value off. The limits and a half must be exact in float.
inline bool fits(float counts, int32_t lower, int32_t upper) {
  return counts > static_cast<float>(lower) - 0.5F && counts < static_cast<float>(upper) + 0.5F;
}

}  // namespace exoid
