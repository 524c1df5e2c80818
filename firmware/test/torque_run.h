/// The torque's command over a file of nodes and ticks, the same on every machine: what comes out is
/// compared bit by bit.

#pragma once

#include "torque_command.h"

namespace exoid {

/// A node: its parameters, and how many ticks follow.
struct Begun {
  TorqueParameters parameters;
  uint32_t ticks;
};

/// A tick, in words of 32 bits.
struct TorqueTick {
  int32_t count, gyro;
  float angle, velocity, bias;
  uint32_t faults;
  uint32_t hears, wish, number, limit;  // of a host
  float acceleration;
};

/// What is compared.
struct TorqueTold {
  float torque;
  uint32_t permit, doubts;
};

/// A flash that takes nothing.
struct NoFlash {
  void read(uint8_t, uint8_t* bytes, uint32_t count) const {
    for (uint32_t at = 0; at < count; ++at) bytes[at] = 0xFF;
  }
  bool write(uint8_t, const uint8_t*, uint32_t) { return false; }
};

/// Hands parameters over as a host does. Returns whether they were taken.
template <class Flash>
bool load_parts(TorqueCommand<Flash>& command, const TorqueParameters& parameters) {
  uint8_t bytes[PARAMETER_BYTES];
  Coding<TorqueParameters>::put(parameters, bytes);
  Reply reply = {};
  for (uint32_t place = 0; place <= PARTS; ++place) {
    const uint32_t pair = place < PARTS ? bytes[2 * place] | bytes[2 * place + 1] << 8
                                        : static_cast<uint32_t>(crc_of(parameters));
    command.hear({0, place, pair, 0}, reply);
    if (reply.not_whole || reply.not_plausible) return false;
  }
  return true;
}

/// `Input` and `Output` have `bool read(bytes, size)` and `bool write(bytes, size)`.
template <class Input, class Output>
bool run_torque(Input& input, Output& output) {
  Begun begun;
  while (input.read(&begun, sizeof begun)) {
    NoFlash flash;
    TorqueCommand<NoFlash> command(flash);
    load_parts(command, begun.parameters);
    for (uint32_t tick = 0; tick < begun.ticks; ++tick) {
      TorqueTick now;
      if (!input.read(&now, sizeof now)) return false;
      if (now.hears) command.hear({0, now.wish, now.number, now.limit, now.acceleration, 0});
      Sample sample = {};
      sample.count = now.count;
      sample.gyro[1] = now.gyro;
      State state = {};
      state.angle = now.angle;
      state.angular_velocity = now.velocity;
      const Torque found = command.update(sample, state, now.faults, now.bias);
      const TorqueTold told = {found.torque, found.permit, found.doubts};
      if (!output.write(&told, sizeof told)) return false;
    }
  }
  return true;
}

}  // namespace exoid
