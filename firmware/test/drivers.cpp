// drivers: plays every scenario of a single driver.

#include "drivers.h"

int main() {
  int failed = 0;
  for (const auto& scenarios : {encoder_scenarios(), imu_scenarios(), flexcan_scenarios()}) {
    failed += play(scenarios);
  }
  return failed;
}
