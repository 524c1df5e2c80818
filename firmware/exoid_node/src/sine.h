/// Sine, cosine and square root in float, the same to the bit on every machine: no library's.

#pragma once

#include <stdint.h>

namespace exoid {

struct Turned {
  float sine, cosine;
};

/// Of an angle within some turns [rad]; to 1e-7. Polynomials as in Cephes' sinf and cosf.
inline Turned turned(float angle) {
  constexpr float QUARTERS = 0.63661977F;  // of a turn per rad
  constexpr float MOST = 1.5703125F, REST = 4.8382679e-04F;  // of pi / 2; a few times MOST is exact
  const float quarters = angle * QUARTERS;
  const int32_t whole = static_cast<int32_t>(quarters + (quarters < 0.0F ? -0.5F : 0.5F));
  const float nearest = static_cast<float>(whole);
  const float r = (angle - nearest * MOST) - nearest * REST;
  const float z = r * r;
  const float sine = ((-1.9515296e-04F * z + 8.332161e-03F) * z + -1.6666655e-01F) * z * r + r;
  const float cosine =
      ((2.4433157e-05F * z + -1.3887316e-03F) * z + 4.1666646e-02F) * z * z - 0.5F * z + 1.0F;
  switch (whole & 3) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

/// The root of a positive number, to 6e-7 of it; 0 of any other.
inline float root(float square) {
  if (!(square > 0.0F)) return 0.0F;
  uint32_t bits;
  __builtin_memcpy(&bits, &square, sizeof bits);
  bits = 0x1FBD1DF5U + (bits >> 1);  // halves the exponent: off by 5 % at most
  float found;
  __builtin_memcpy(&found, &bits, sizeof found);
  for (uint8_t k = 0; k < 2; ++k) found = 0.5F * (found + square / found);
  return found;
}

}  // namespace exoid
