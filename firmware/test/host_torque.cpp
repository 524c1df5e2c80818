// host_torque INPUT OUTPUT: the torque's command on this machine.

#include "host_file.h"
#include "torque_run.h"

int main(int count, char** names) {
  if (count != 3) return 2;
  File input(names[1], "rb"), output(names[2], "wb");
  return exoid::run_torque(input, output) ? 0 : 1;
}
