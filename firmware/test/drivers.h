/// Scenarios of single drivers on register models.

#pragma once

#include "play.h"

std::vector<Scenario> encoder_scenarios();
std::vector<Scenario> imu_scenarios();
std::vector<Scenario> flexcan_scenarios();
