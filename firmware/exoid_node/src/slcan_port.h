/// Between slcan and a serial port.

#pragma once

#include "slcan.h"

namespace exoid {

constexpr int LONGEST_INPUT = 64;  // bytes taken at once: a host that floods must not stop a sample

/// Moves bytes between `slcan` and a port with the four functions of Arduino's serial ports, and
/// `hung_up()`: whether a program has let go of it since the last call. The port's `write` returns
/// how much it took, or more where it lost what it had.
template <class Port>
void exchange(Slcan& slcan, Port& port) {
  if (port.hung_up()) slcan.hang_up();
  for (int taken = 0; taken < LONGEST_INPUT && port.available() > 0; ++taken) {
    slcan.receive(static_cast<char>(port.read()));
  }
  const int room = port.availableForWrite();
  const uint8_t* bytes = nullptr;
  const size_t pending = slcan.pending(bytes);
  const size_t count = static_cast<int>(pending) < room ? pending : static_cast<size_t>(room);
  if (room <= 0 || count == 0) return;
  // In one piece: every write is a packet on USB.
  const size_t taken = port.write(bytes, count);
  if (taken <= count) {
    slcan.sent(taken);
  } else {
    slcan.lose();
  }
}

}  // namespace exoid
