// What a step of the filter costs: `repeats` steps for each record of in.bin, timed by SysTick.
// With one instruction per nanosecond (-icount shift=0) a count of SysTick is 62.5 instructions.

#include "filter_run.h"
#include "semihosting.h"
#include "systick.h"

namespace {
constexpr uint32_t BATCH = 10;  // steps timed together

volatile float keep;
}  // namespace

int main() {
  semihosting::File input("in.bin", 6, semihosting::READ_BINARY);
  semihosting::File output("out.bin", 7, semihosting::WRITE_BINARY);
  exoid::systick_begin(exoid::SYSTICK_LONGEST);
  exoid::Measured measured[BATCH];
  exoid::Belief belief = exoid::begin({0.0F, true}, {0.0F, true});
  while (input.read(measured, sizeof measured)) {
    const uint32_t before = exoid::systick_left();
    for (const exoid::Measured& each : measured) {
      belief = exoid::advance(belief, {each.angle, true}, {each.rate, true});
    }
    const uint32_t counts = before - exoid::systick_left();
    keep = belief.x0;
    if (!output.write(&counts, sizeof counts)) return 1;
  }
  return 0;
}
