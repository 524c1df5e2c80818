/// Register model of the AS5047P and the AS5048A: what a driver sends to and gets from a real one.
///
/// After ams DS000324 (AS5047P) and the AS5048A/AS5048B data sheet v1-06. A command is parity,
/// read, 14 bits of address; an answer is parity, error flag, 14 bits, and belongs to the command
/// before. ERRFL: bit 0 framing, 1 invalid command, 2 parity; its read clears it. The flag of an
/// answer stays set until then.

#pragma once

#include <stdint.h>

#include "exposure.h"

namespace chips {

class As504xModel {
 public:
  enum Line : uint8_t { FREE, HELD_LOW, HELD_HIGH };

  /// `diagnostics` is the address of DIAAGC: 0x3FFC of an AS5047P, 0x3FFD of an AS5048A.
  explicit As504xModel(uint16_t diagnostics) : diagnostics_(diagnostics) {}

  Line to_chip = FREE, from_chip = FREE;
  uint16_t flips_to_chip = 0, flips_from_chip = 0;  // bits of the next frame that a glitch turns
  bool offsets_done = true;
  bool overflows = false;

  void expose(const Exposure& now) {
    from_chip = now.faults & ENCODER_SILENT ? HELD_LOW : FREE;
    missing_ = (now.faults & (MAGNET_MISSING | MAGNET_WEAK)) != 0;
    strong_ = (now.faults & MAGNET_STRONG) != 0;
    count_ = now.count & DATA;
  }

  /// What comes with the next frame.
  uint16_t answer() const { return seen(answer_, from_chip, flips_from_chip); }

  /// One frame under its chip select.
  uint16_t exchange(uint16_t word) {
    const uint16_t sent = answer();
    take(seen(word, to_chip, flips_to_chip));
    flips_to_chip = flips_from_chip = 0;
    return sent;
  }

  /// The chip select rose after a number of bits that is no frame.
  void cut() { errors_ |= 1; }

 private:
  static constexpr uint16_t DATA = 0x3FFF;

  static uint16_t seen(uint16_t word, Line line, uint16_t flips) {
    return line == FREE ? word ^ flips : line == HELD_LOW ? 0 : 0xFFFF;
  }

  static bool is_even(uint16_t word) { return __builtin_popcount(word) % 2 == 0; }

  void take(uint16_t word) {
    if (!is_even(word)) errors_ |= 4;
    const uint16_t at = word & DATA;
    const bool reads = (word & 0x4000) != 0;
    const uint16_t value = is_even(word) && reads ? stored(at) : 0;
    const uint16_t flagged = errors_ != 0 ? value | 0x4000 : value;
    answer_ = is_even(flagged) ? flagged : flagged | 0x8000;
    if (is_even(word) && reads && at == 0x0001) errors_ = 0;
  }

  uint16_t stored(uint16_t at) {
    if (at == 0x0000) return 0;
    if (at == 0x0001) return errors_;
    if (at == 0x3FFF) return count_;
    if (at == diagnostics_) {
      const uint16_t gain = missing_ ? 0xFF : strong_ ? 0x00 : 0x80;
      return static_cast<uint16_t>(gain | offsets_done << 8 | overflows << 9 | strong_ << 10 |
                                   missing_ << 11);
    }
    const bool is_magnitude = at == diagnostics_ + 1;
    if (!is_magnitude) errors_ |= 2;
    return is_magnitude ? 0x1000 : 0;
  }

  const uint16_t diagnostics_;
  bool missing_ = false, strong_ = false;
  uint16_t count_ = 0, answer_ = 0;
  uint8_t errors_ = 0;
};

}  // namespace chips
