// host_filter INPUT OUTPUT: the filter on this machine.

#include "filter_run.h"
#include "host_file.h"

int main(int count, char** names) {
  if (count != 3) return 2;
  File input(names[1], "rb"), output(names[2], "wb");
  return exoid::run_filter(input, output) ? 0 : 1;
}
