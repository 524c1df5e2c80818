// The node's own code on this machine, for Python: a tick's readings and commands in, frames out.

#include <cstring>
#include <vector>

#include "tended_node.h"

namespace {

struct Readings {
  uint16_t count;
  int16_t gyro[3], accel[3];
};

struct Encoder {
  static constexpr int32_t TURN = 4096;
  uint16_t count;
  bool read(exoid::EncoderReading& reading) {
    reading = {count, false, false};
    return true;
  }
};

struct Imu {
  exoid::ImuReading now;
  bool read(exoid::ImuReading& reading) {
    reading = now;
    return true;
  }
};

struct Link {
  std::vector<exoid::Frame> heard, sent;
  void begin(uint32_t) {}
  bool poll(uint32_t) { return false; }
  bool is_on_can() const { return true; }
  bool send(const exoid::Frame& frame) {
    sent.push_back(frame);
    return true;
  }
  bool receive(exoid::Frame& frame) {
    if (heard.empty()) return false;
    frame = heard.front();
    heard.erase(heard.begin());
    return true;
  }
};

struct Flash {
  static constexpr uint32_t SLOTS = 3, SLOT_BYTES = 64;
  uint8_t bytes[SLOTS][SLOT_BYTES];
  void read(uint8_t slot, uint8_t* found, uint32_t count) const {
    std::memcpy(found, bytes[slot], count);
  }
  bool write(uint8_t slot, const uint8_t* given, uint32_t count) {
    std::memcpy(bytes[slot], given, count);
    return true;
  }
};

struct Board {
  static uint32_t serial() { return 1; }
  void begin() {}
  uint32_t supply_mv() const { return 3300; }
  void light(bool) {}
};

struct Clock {
  uint32_t count, age;
  uint32_t ticks() const { return count; }
  uint32_t age_us() const { return age; }
};

struct Condition {
  void describe(exoid::Health& health) const { health.on_can = true; }
};

struct Kinds {
  using Encoder = ::Encoder;
  using Imu = ::Imu;
  using Link = ::Link;
  using Flash = ::Flash;
  using Board = ::Board;
  using Clock = ::Clock;
  using Condition = ::Condition;
};

struct World {
  Encoder encoder = {};
  Imu imu = {};
  Link link = {};
  Flash flash = {};
  Board board = {};
  Clock clock = {};
  Condition condition = {};
  exoid::TendedNode<Kinds> node{{encoder, imu, link, flash, board, clock, condition}};
};

}  // namespace

extern "C" {

World* node_new() {
  World* world = new World();
  world->node.begin();
  return world;
}

void node_free(World* world) { delete world; }

/// A frame of the host's, which the node takes at its next tick.
void node_hear(World* world, const exoid::Frame* frame) { world->link.heard.push_back(*frame); }

/// A tick, with all the passes of the loop that its work needs. Returns how many frames it sent, of
/// which the first `most` are in `sent`.
uint32_t node_tick(World* world, const Readings* readings, exoid::Frame* sent, uint32_t most) {
  constexpr uint32_t PASS_US = 250;
  world->encoder.count = readings->count;
  for (int axis = 0; axis < 3; ++axis) {
    world->imu.now.gyro[axis] = readings->gyro[axis];
    world->imu.now.accel[axis] = readings->accel[axis];
  }
  world->link.sent.clear();
  ++world->clock.count;
  for (uint32_t age = 0; age < exoid::TICK_US; age += PASS_US) {
    world->clock.age = age;
    world->node.run(world->clock.count * (exoid::TICK_US / 1000));
  }
  const uint32_t count = static_cast<uint32_t>(world->link.sent.size());
  for (uint32_t k = 0; k < count && k < most; ++k) sent[k] = world->link.sent[k];
  return count;
}

}
