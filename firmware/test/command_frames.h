/// Commands to the simulated node, and how to look at its answers.

#pragma once

#include "checksum.h"
#include "constants.h"
#include "world.h"

using exoid::Frame;

constexpr uint32_t SERIAL = 0xC0FFEE01;
constexpr uint32_t SETTLED_MS = 300;
constexpr uint32_t ZERO_PLACE = 32, ZERO_BITS = 12, REVERSED = 44, COMMISSIONED = 45, CHANGES = 56;

/// A command with its check.
inline Frame command(uint16_t id, uint32_t serial, uint32_t value, uint32_t bits) {
  Frame frame = {id, {}};
  put(frame, 0, 32, serial);
  put(frame, 32, bits, value);
  put(frame, 56, 8, exoid::checksum(frame.data, exoid::CHECKED_BYTES) & 255U);
  return frame;
}

/// The frames that the node sends within 100 ms of a command.
inline std::vector<Frame> after(const Frame& frame) {
  world.on_bus.clear();
  board.can.hear(frame);
  run_ms(100);
  return world.on_bus;
}

inline std::vector<Frame> set(uint16_t id, uint32_t value, uint32_t bits) {
  return after(command(id, SERIAL, value, bits));
}

inline Frame one(const std::vector<Frame>& frames, uint16_t id) {
  const std::vector<Frame> found = only(frames, id);
  check(found.size() == 1, "there is one such frame");
  return found.front();
}

inline uint32_t count_of(const std::vector<Frame>& frames) {
  return field(only(frames, exoid::RAW_ID).back(), 0, 12);
}

/// A leg that stands still at this count of the encoder.
inline void hold(uint16_t count) {
  world.leg = [=](uint32_t) {
    chips::Exposure now = {};
    now.count = count;
    return now;
  };
}

inline void still_node(uint16_t count) {
  hold(count);
  power_on();
  run_ms(SETTLED_MS);
}
