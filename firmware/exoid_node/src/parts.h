/// The parts of which config.h chooses: what the firmware has a driver for.

#pragma once

#include <stdint.h>

namespace exoid {

enum class EncoderPart : uint8_t { AS5600, AS5047P, AS5048A };

enum class ImuPart : uint8_t { LSM6DS3, ICM42688P };

}  // namespace exoid
