/// How an MCP2515 divides a bit into quanta. The built-in bit rate is refused where the program is
/// compiled if the crystal cannot do it exactly, and one of a command where that is heard.

#pragma once

#include <stdint.h>

namespace exoid {

constexpr uint32_t FEWEST_QUANTA = 5;   // of a bit: 1 + 1 + 1 + 2
constexpr uint32_t MOST_QUANTA = 25;    // 1 + 8 + 8 + 8
constexpr uint32_t SAMPLE_POINT = 875;  // thousandths of a bit, as CiA advises

/// Quanta after the sample point: the chip's second phase segment is two at least.
constexpr uint32_t quanta_after(uint32_t quanta) {
  return (quanta + 4) / 8 < 2 ? 2 : (quanta + 4) / 8;
}

/// Quanta between the first, which synchronises, and the sample point: two segments of 1 to 8.
constexpr uint32_t quanta_before(uint32_t quanta) { return quanta - 1 - quanta_after(quanta); }

/// Whether a bit has just so many quanta at a prescaler that the chip has.
constexpr bool is_exact(uint32_t crystal, uint32_t rate, uint32_t quanta) {
  return crystal % (2 * rate * quanta) == 0 && crystal / (2 * rate * quanta) <= 64 &&
         quanta_before(quanta) <= 16;
}

constexpr uint32_t sample_point(uint32_t quanta) {
  return 1000 * (quanta - quanta_after(quanta)) / quanta;
}

constexpr uint32_t off_sample_point(uint32_t quanta) {
  return sample_point(quanta) > SAMPLE_POINT ? sample_point(quanta) - SAMPLE_POINT
                                             : SAMPLE_POINT - sample_point(quanta);
}

/// Of two numbers of quanta the one that samples nearer to SAMPLE_POINT; 0 is none.
constexpr uint32_t better_quanta(uint32_t one, uint32_t other) {
  return one == 0 ? other
                  : other == 0 || off_sample_point(one) <= off_sample_point(other) ? one : other;
}

/// The best number of quanta from `quanta` on; 0 where the crystal can do none exactly.
constexpr uint32_t best_quanta(uint32_t crystal, uint32_t rate, uint32_t quanta = FEWEST_QUANTA) {
  return quanta > MOST_QUANTA
             ? 0
             : better_quanta(is_exact(crystal, rate, quanta) ? quanta : 0,
                             best_quanta(crystal, rate, quanta + 1));
}

constexpr uint32_t phase_1_of(uint32_t quanta) { return quanta_before(quanta) / 2; }

/// Quanta by which the chip may shift a bit's end: less than those after the sample point.
constexpr uint32_t jump_of(uint32_t quanta) {
  return quanta_after(quanta) - 1 < 4 ? quanta_after(quanta) - 1 : 4;
}

/// The registers CNF3 to CNF1, in the order of their addresses.
struct CanRegisters {
  uint8_t cnf3, cnf2, cnf1;
};

constexpr CanRegisters registers_of(uint32_t prescaler, uint32_t quanta) {
  return {static_cast<uint8_t>(quanta_after(quanta) - 1),
          static_cast<uint8_t>(0x80 | (phase_1_of(quanta) - 1) << 3 |
                               (quanta_before(quanta) - phase_1_of(quanta) - 1)),
          static_cast<uint8_t>((jump_of(quanta) - 1) << 6 | (prescaler - 1))};
}

/// Those of a bit rate that the crystal can do.
constexpr CanRegisters can_registers(uint32_t crystal, uint32_t rate) {
  return registers_of(crystal / (2 * rate * best_quanta(crystal, rate)),
                      best_quanta(crystal, rate));
}

/// A bit rate that is known where the program is compiled.
template <uint32_t CRYSTAL, uint32_t RATE>
struct CanTiming {
  static constexpr uint32_t QUANTA = best_quanta(CRYSTAL, RATE);
  static_assert(QUANTA != 0, "the crystal of the MCP2515 cannot do this bit rate");
};

}  // namespace exoid
