/// The wiring, and how a node is mounted that was not commissioned.

#pragma once

#include <stdint.h>

#include "parts.h"

namespace exoid {
namespace config {

constexpr EncoderPart ENCODER = EncoderPart::AS5600;  // or AS5047P, AS5048A
constexpr ImuPart IMU = ImuPart::LSM6DS3;             // or ICM42688P

constexpr int32_t ENCODER_ZERO = 2048;  // count of the encoder where the knee is fully extended
constexpr int32_t ENCODER_SIGN = 1;     // -1 where the count falls while the knee extends

constexpr uint32_t I2C_FREQUENCY = 400000;  // Hz

constexpr uint8_t ENCODER_SELECT_PIN = 9;   // CSn of an encoder on SPI
constexpr uint8_t CAN_SELECT_PIN = 10;      // CS of the MCP2515
constexpr uint32_t CAN_CRYSTAL = 8000000;   // Hz, as stamped on the module's crystal
constexpr uint32_t CAN_BIT_RATE = 500000;   // bit/s

constexpr uint8_t STATUS_LED_PIN = 2;  // the board's own LED is the clock of the MCP2515

}  // namespace config
}  // namespace exoid
