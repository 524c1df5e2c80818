/// The world around the sketch: time, the leg, the wires, the CAN bus and the host on USB.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "chips.h"
#include "exo_can.h"

struct World {
  uint64_t now_us = 0;

  // The leg: what the sensors are exposed to at each tick.
  std::function<chips::Exposure(uint32_t tick)> leg;
  chips::Board board;

  // I2C: clock pulses until the device that holds the data line lets it go.
  int data_held_for = 0;
  bool clock_held = false;
  uint32_t i2c_frequency = 0;

  // CAN.
  bool has_controller = true;
  bool acknowledged = true;
  std::vector<exoid::Frame> on_bus;

  // Commands of a host that are on the bus and not yet taken, in order.
  std::vector<exoid::Frame> to_node;
  uint32_t bit_rate = 0;
  uint8_t transmit_errors = 0;
  bool bus_off = false;

  // The board: its flash, and what of it works.
  uint8_t slots[2][64];
  bool flash_works = true;
  int bytes_until_cut = -1;  // of a write, after which the power goes; -1: it stays
  bool lit = false;

  // The host on USB.
  bool plugged = true;
  bool host_reads = true;
  std::string from_host, to_host;
};

extern World world;

/// Runs the sketch's setup, once in a process.
void power_on();

/// Runs the sketch's loop for so long.
void run_ms(uint32_t time);

/// Ends the program with the sentence that does not hold.
void check(bool holds, const char* sentence, int line = __builtin_LINE());

/// The bits of a frame as exoid.dbc lays them out.
uint32_t field(const exoid::Frame& frame, uint32_t start, uint32_t length);
int32_t signed_field(const exoid::Frame& frame, uint32_t start);
bool status(const exoid::Frame& state, uint32_t bit);

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
std::vector<Scenario> command_scenarios();
std::vector<Scenario> state_scenarios();
