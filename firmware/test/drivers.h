/// Scenarios of single drivers on register models.

#pragma once

#include <vector>

struct Scenario {
  const char* name;
  void (*play)();
};

/// Ends the program with the sentence that does not hold.
void check(bool holds, const char* sentence, int line = __builtin_LINE());

std::vector<Scenario> encoder_scenarios();
std::vector<Scenario> imu_scenarios();
std::vector<Scenario> flexcan_scenarios();
