// host_learner INPUT OUTPUT: the learner on this machine.

#include "host_file.h"
#include "learner_run.h"

int main(int count, char** names) {
  if (count != 3) return 2;
  File input(names[1], "rb"), output(names[2], "wb");
  exoid::LegLearner learner;
  return exoid::run_learner(learner, input, output) ? 0 : 1;
}
