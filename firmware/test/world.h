/// The world around the sketch: the board, the leg, and who listens on CAN and on USB.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "board/board.h"
#include "exo_can.h"

struct World {
  // The leg: what the sensors are exposed to at each tick.
  std::function<chips::Exposure(uint32_t tick)> leg;

  std::vector<exoid::Frame> on_bus;  // CAN frames
  std::string to_host;               // on USB
  uint64_t longest_pass_us = 0;      // of the sketch's loop
};

extern World world;
using simulated::board;

/// Runs the sketch's setup, once in a process.
void power_on();

/// Takes the supply away and gives it back; what is in flash stays.
void power_cycle();

/// Runs the sketch's loop for so long.
void run_ms(uint32_t time);

/// Ends the program with the sentence that does not hold.
void check(bool holds, const char* sentence, int line = __builtin_LINE());

/// The bits of a frame as exoid.dbc lays them out.
uint32_t field(const exoid::Frame& frame, uint32_t start, uint32_t length);
int32_t signed_field(const exoid::Frame& frame, uint32_t start);
bool status(const exoid::Frame& state, uint32_t bit);

/// The frames of a text of slcan lines, all of which must be whole.
std::vector<exoid::Frame> frames_in(const std::string& text);

/// The frames of one identifier.
std::vector<exoid::Frame> only(const std::vector<exoid::Frame>& frames, uint16_t id);

/// A status byte as it is in STATE.
enum Status : uint32_t {
  ENCODER_FAULT, NO_MAGNET, MAGNET_STRENGTH, IMU_FAULT, GYRO_SATURATED, STATE_SATURATED,
  FILTER_RESET, OVERRUN,
};

/// A sensible leg: it swings, its gyro agrees with its encoder.
chips::Exposure swinging(uint32_t tick);

struct Scenario {
  const char* name;
  void (*play)();
};

std::vector<Scenario> sensor_scenarios();
std::vector<Scenario> uplink_scenarios();
std::vector<Scenario> port_scenarios();
std::vector<Scenario> bus_fault_scenarios();
std::vector<Scenario> can_fault_scenarios();
std::vector<Scenario> command_scenarios();
std::vector<Scenario> state_scenarios();
std::vector<Scenario> torque_scenarios();
std::vector<Scenario> part_scenarios();
