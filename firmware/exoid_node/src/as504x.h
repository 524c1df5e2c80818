/// AS5047P and AS5048A, magnetic encoders on SPI: 14 bits a turn, each frame under a parity bit.
///
/// Frames and registers: ams AS5047P, DS000324 (v1-01: Figure 15, the read in a pipeline), as
/// AS5047P_Types.h of jonas-merkle/AS5047P has them; ams AS5048A/AS5048B v1-06 (2014-Jun-05), SPI
/// register map, as as5048a.h of NuttX has it; ams application note "AS5048 SPI Sensor Readout",
/// revision 1.1: parity, and the read with NOP.

#pragma once

#include "as5600.h"

namespace exoid {

/// Where the diagnostics lie. Their bits are the same: bit 11 MAGL or Comp High, 10 MAGH or Comp
/// Low, 9 COF, 8 LF or OCF.
struct As5047pMap {
  static constexpr uint16_t DIAGNOSTICS = 0x3FFC;
};

struct As5048aMap {
  static constexpr uint16_t DIAGNOSTICS = 0x3FFD;
};

/// Whether a word has an odd number of ones.
inline bool is_odd(uint16_t word) {
  bool odd = false;
  for (; word != 0; word = static_cast<uint16_t>(word & (word - 1))) odd = !odd;
  return odd;
}

/// `Link` has `uint16_t exchange(word)`, one frame of 16 bits under its own chip select.
template <class Link, class Map>
class As504x {
 public:
  static constexpr int32_t TURN = 16384;  // counts

  explicit As504x(Link& link) : link_(link) {}

  /// Reads angle and magnet. The chip answers a frame with the next: three answers take four
  /// frames, and the angle is of this read. On a fault returns false and leaves `reading` alone.
  bool read(EncoderReading& reading) {
    link_.exchange(command(ERRORS));  // which clears what was wrong since the last read
    const uint16_t errors = link_.exchange(command(Map::DIAGNOSTICS));
    const uint16_t diagnostics = link_.exchange(command(ANGLE));
    const uint16_t angle = link_.exchange(command(NOTHING));
    // Lines held low answer 0 under a right parity, but a chip that runs has OFFSETS_DONE set. Its
    // answers held high tell an error; its commands held high ask for the angle in place of errors.
    const bool answered = errors == 0 && is_whole(diagnostics) && is_whole(angle) &&
                          (diagnostics & OFFSETS_DONE) != 0;
    if (!answered) return false;
    reading.count = angle & DATA;
    // The chip has no bit for a magnet that is gone: it is one too weak for the highest gain. After
    // an overflow the angle means nothing, either.
    reading.magnet_missing = (diagnostics & (FIELD_LOW | OVERFLOW)) != 0;
    reading.magnet_strength = (diagnostics & (FIELD_LOW | FIELD_HIGH)) != 0;
    return true;
  }

 private:
  static constexpr uint16_t NOTHING = 0x0000;
  static constexpr uint16_t ERRORS = 0x0001;
  static constexpr uint16_t ANGLE = 0x3FFF;  // of the AS5047P: with its error at speed compensated
  static constexpr uint16_t READ = 0x4000;
  static constexpr uint16_t PARITY = 0x8000;
  static constexpr uint16_t ERROR = 0x4000;
  static constexpr uint16_t DATA = 0x3FFF;
  static constexpr uint16_t FIELD_LOW = 0x0800;
  static constexpr uint16_t FIELD_HIGH = 0x0400;
  static constexpr uint16_t OVERFLOW = 0x0200;
  static constexpr uint16_t OFFSETS_DONE = 0x0100;

  static uint16_t command(uint16_t address) {
    const uint16_t word = READ | address;
    return is_odd(word) ? word | PARITY : word;
  }

  /// Whether a frame came as it was sent, to a command that the chip understood.
  static bool is_whole(uint16_t word) { return !is_odd(word) && (word & ERROR) == 0; }

  Link& link_;
};

}  // namespace exoid
