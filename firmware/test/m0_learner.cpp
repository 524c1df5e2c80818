// The learner on a Cortex-M0: from in.bin to out.bin in the folder of the emulator.

#include "learner_run.h"
#include "semihosting.h"

namespace {
exoid::LegLearner learner;
}  // namespace

int main() {
  semihosting::File input("in.bin", 6, semihosting::READ_BINARY);
  semihosting::File output("out.bin", 7, semihosting::WRITE_BINARY);
  return exoid::run_learner(learner, input, output) ? 0 : 1;
}
