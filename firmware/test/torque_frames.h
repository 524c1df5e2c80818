/// A host that downloads parameters to the simulated node, and lets it command a torque.

#pragma once

#include <cstring>

#include "command_frames.h"
#include "received_parameters.h"

constexpr uint32_t OFF = 0, ARM = 1, ENABLE = 2;
constexpr uint32_t DISABLED = 0, ARMED = 1, ENABLED = 2;

/// A leg of 8 N m, all of whose gravity is taken off.
constexpr exoid::TorqueParameters LEG = {8.0F, 0.1F, 2.0F, 0.3F, 0.2F, 0.3F,
                                         1.0F, 0.0F, 0.0F, 0.0F, 5.0F, 50.0F};

/// The frame of a part; that behind the last holds the CRC.
inline Frame part(const exoid::TorqueParameters& leg, uint32_t place) {
  uint8_t bytes[exoid::PARAMETER_BYTES];
  std::memcpy(bytes, &leg, sizeof bytes);
  const uint32_t data = place < exoid::PARTS ? bytes[2 * place] | bytes[2 * place + 1] << 8
                                             : exoid::crc_of(leg);
  return command(exoid::LOAD_ID, SERIAL, place | data << 8, 24);
}

/// The bits of the reply to a frame, from NoAngle on.
inline uint32_t refused(const Frame& frame) {
  return field(one(after(frame), exoid::REPLY_ID), 43, 5);
}

constexpr uint32_t NOT_WHOLE = 1U << 3, NOT_PLAUSIBLE = 1U << 4;

inline void download(const exoid::TorqueParameters& leg) {
  for (uint32_t place = 0; place <= exoid::PARTS; ++place) {
    check(refused(part(leg, place)) == 0, "each part is taken");
  }
}

/// A host that says something every 20 ms.
class Insisting {
 public:
  explicit Insisting(uint32_t limit = 63) : limit_(limit) {}

  /// Says it for so long; the torques that the node then tells.
  std::vector<Frame> says(uint32_t wish, uint32_t time_ms) {
    world.on_bus.clear();
    for (uint32_t ms = 0; ms < time_ms; ms += 20) {
      number_ = (number_ + 1) & 15U;
      board.can.hear(frame(wish));
      run_ms(20);
    }
    return only(world.on_bus, exoid::TORQUE_ID);
  }

  /// Once more what it said last.
  Frame frame(uint32_t wish) const {
    const uint32_t value = wish | number_ << 2 | limit_ << 6;
    return command(exoid::ALLOW_ID, SERIAL, value, 24);
  }

 private:
  uint32_t limit_;  // counts of 0.25 N m
  uint32_t number_ = 0;
};

inline double torque_of(const Frame& told) { return signed_field(told, 0) / 1024.0; }
inline uint32_t permit_of(const Frame& told) { return field(told, 24, 2); }
inline uint32_t doubts_of(const Frame& told) { return field(told, 32, 16); }
