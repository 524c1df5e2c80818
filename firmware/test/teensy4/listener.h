/// Who listens to the sketch on the simulated Teensy, and how its scenarios run it.

#pragma once

#include <vector>

#include "board.h"
#include "exo_can.h"
#include "play.h"

using exoid::Frame;

extern std::vector<Frame> on_bus;
extern uint64_t longest_pass_us;  // of the sketch's loop

/// Runs the sketch's setup, once in a process.
void power_on();

/// Runs the sketch's loop for so long.
void run_ms(uint32_t time);

/// The STATE frames of so many ticks from now.
std::vector<Frame> states_of(uint32_t ticks);

/// Bits of a frame, and the status byte of a STATE.
uint32_t field(const Frame& frame, int start, int length);
uint32_t status(const Frame& state);

/// A leg that swings.
chips::Exposure swinging(uint32_t tick);

std::vector<Scenario> wire_scenarios();
std::vector<Scenario> command_scenarios();
