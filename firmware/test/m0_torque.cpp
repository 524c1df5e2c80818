// The torque's command on a Cortex-M0: from in.bin to out.bin in the folder of the emulator.

#include "semihosting.h"
#include "torque_run.h"

int main() {
  semihosting::File input("in.bin", 6, semihosting::READ_BINARY);
  semihosting::File output("out.bin", 7, semihosting::WRITE_BINARY);
  return exoid::run_torque(input, output) ? 0 : 1;
}
