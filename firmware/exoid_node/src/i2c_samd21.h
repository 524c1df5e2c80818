/// I2C transfers on the SERCOM that Arduino's Wire has set up. Wire's own wait for ever on a clock
/// line that is held down; these end in time.

#pragma once

#include <stdint.h>

namespace exoid {

class I2cMaster {
 public:
  /// Takes over what Wire has set up, with the hardware's time-outs and an idle bus.
  void begin();

  /// Whether no transfer is under way, the last stop included.
  bool is_idle() const;

  /// Sends the bytes to a device and keeps the bus. Returns false where one was not acknowledged.
  bool write(uint8_t device, const uint8_t* bytes, uint8_t count);

  /// Reads one byte or more from a device and ends with a stop. Returns false where it is silent.
  bool read(uint8_t device, uint8_t* bytes, uint8_t count);

  /// Lets the bus go. It is idle a few microseconds later.
  bool stop();

 private:
  bool start(uint8_t address, uint8_t expected);
  bool command(uint32_t command, uint32_t acknowledge);
  bool wait_for(uint8_t flags) const;
  bool is_late() const;

  uint32_t began_us_ = 0;  // of this transfer
};

}  // namespace exoid
