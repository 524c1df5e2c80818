// What each tick of the learner costs, of the ticks of in.bin. With one instruction per nanosecond
// (-icount shift=0) a count of SysTick is 62.5 instructions. Out: counts of the tick's pieces of
// work together, of the longest piece, and of the longer part of what is told.

#include "learner_run.h"
#include "semihosting.h"
#include "systick.h"

namespace {

exoid::LegLearner learner;
volatile float keep;

uint32_t since(uint32_t before) { return before - exoid::systick_left(); }

struct Cost {
  uint32_t whole, longest, telling;
};

Cost cost_of(const exoid::Tick& tick) {
  Cost cost = {0, 0, 0};
  uint32_t before = exoid::systick_left();
  learner.take({tick.count, tick.gyro, tick.sees_angle != 0, tick.sees_rate != 0, tick.missed});
  cost.whole = since(before);
  for (bool works = true; works;) {
    before = exoid::systick_left();
    works = learner.work();
    const uint32_t piece = since(before);
    cost.whole += piece;
    if (piece > cost.longest) cost.longest = piece;
  }
  before = exoid::systick_left();
  const exoid::ReadOff read = exoid::read_off(learner);
  const uint32_t reading = since(before);
  before = exoid::systick_left();
  const exoid::Learned found = exoid::learned(read);
  keep = static_cast<float>(exoid::trust(read, found)) + found.error[0];
  cost.telling = since(before);
  if (reading > cost.telling) cost.telling = reading;
  return cost;
}

}  // namespace

int main() {
  semihosting::File input("in.bin", 6, semihosting::READ_BINARY);
  semihosting::File output("out.bin", 7, semihosting::WRITE_BINARY);
  exoid::systick_begin(exoid::SYSTICK_LONGEST);
  exoid::Tick tick;
  while (input.read(&tick, sizeof tick)) {
    const Cost cost = cost_of(tick);
    if (!output.write(&cost, sizeof cost)) return 1;
  }
  return 0;
}
