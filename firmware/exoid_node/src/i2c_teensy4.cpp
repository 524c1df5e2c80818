#include "i2c_teensy4.h"

#if defined(__IMXRT1062__)

#include <Arduino.h>
#include <Wire.h>

namespace exoid {

bool I2cMaster::write(uint8_t device, const uint8_t* bytes, uint8_t count) {
  Wire.beginTransmission(device);
  return Wire.write(bytes, count) == count;
}

bool I2cMaster::read(uint8_t device, uint8_t* bytes, uint8_t count) {
  const uint8_t keeps_bus = 0, ends = 1;
  if (Wire.endTransmission(keeps_bus) != 0) return false;
  // What it returns is 4 where it could not begin, too: what has come says how much it was.
  Wire.requestFrom(device, count, ends);
  if (Wire.available() != count) return false;
  for (uint8_t at = 0; at < count; ++at) bytes[at] = static_cast<uint8_t>(Wire.read());
  return true;
}

bool I2cMaster::stop() { return Wire.endTransmission() == 0; }

}  // namespace exoid

#endif
