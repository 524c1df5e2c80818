/// AS5600, the magnetic encoder of the knee: 12 bits a turn, and whether it sees its magnet.

#pragma once

#include <stdint.h>

namespace exoid {

struct EncoderReading {
  uint16_t count;  // 0..TURN - 1 of the encoder
  bool magnet_missing;
  bool magnet_strength;  // too weak or too strong
};

/// `Bus` has `bool write(device, register, value)` and `bool read(device, register, bytes, n)`.
template <class Bus>
class As5600 {
 public:
  static constexpr uint8_t ADDRESS = 0x36;
  static constexpr int32_t TURN = 4096;  // counts

  explicit As5600(Bus& bus) : bus_(bus) {}

  /// Reads angle and magnet, and first sets up an encoder that did not answer before.
  /// On a fault returns false and leaves `reading` alone.
  bool read(EncoderReading& reading) {
    if (!configured_) configured_ = configure();
    uint8_t status = 0;
    uint8_t angle[2] = {0, 0};
    // Two transfers: the chip does not say that one may run on from STATUS into the angle.
    const bool answered = configured_ && bus_.read(ADDRESS, STATUS, &status, 1) &&
                          bus_.read(ADDRESS, RAW_ANGLE, angle, 2) && angle[0] <= HIGHEST;
    configured_ = answered;
    if (!answered) return false;
    reading.count = static_cast<uint16_t>((angle[0] << 8) | angle[1]);
    reading.magnet_missing = (status & MAGNET_DETECTED) == 0;
    reading.magnet_strength = (status & (MAGNET_WEAK | MAGNET_STRONG)) != 0;
    return true;
  }

 private:
  static constexpr uint8_t CONF_HIGH = 0x07;
  static constexpr uint8_t CONF_LOW = 0x08;
  static constexpr uint8_t STATUS = 0x0B;
  static constexpr uint8_t RAW_ANGLE = 0x0C;
  // Of CONF the node owns what touches an angle; output stage, PWM and reserved bits stay.
  static constexpr uint8_t OWNED_HIGH = 0x3F;   // watchdog, fast threshold, slow filter
  static constexpr uint8_t FAST_FILTER = 0x03;  // settles in 0.29 ms in place of 2.2 ms
  static constexpr uint8_t OWNED_LOW = 0x0F;    // hysteresis, power mode
  static constexpr uint8_t ALWAYS_ON = 0x00;
  static constexpr uint8_t MAGNET_STRONG = 0x08;
  static constexpr uint8_t MAGNET_WEAK = 0x10;
  static constexpr uint8_t MAGNET_DETECTED = 0x20;
  static constexpr uint8_t HIGHEST = 0x0F;  // high byte of a count; a bus let go reads 0xFF

  bool configure() {
    uint8_t high = 0;
    uint8_t low = 0;
    return bus_.read(ADDRESS, CONF_HIGH, &high, 1) && bus_.read(ADDRESS, CONF_LOW, &low, 1) &&
           bus_.write(ADDRESS, CONF_HIGH, with(high, OWNED_HIGH, FAST_FILTER)) &&
           bus_.write(ADDRESS, CONF_LOW, with(low, OWNED_LOW, ALWAYS_ON));
  }

  /// The register's byte with the bits of `mask` replaced.
  static constexpr uint8_t with(uint8_t before, uint8_t mask, uint8_t bits) {
    return static_cast<uint8_t>((before & ~mask) | bits);
  }

  Bus& bus_;
  bool configured_ = false;
};

}  // namespace exoid
