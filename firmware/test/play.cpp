// Plays scenarios, each in a process of its own.

#include "play.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

void check(bool holds, const char* sentence, int line) {
  if (holds) return;
  std::fprintf(stderr, "line %d: it does not hold that %s\n", line, sentence);
  std::exit(1);
}

namespace {

/// Returns whether the scenario held. It has a process of its own.
bool held(const Scenario& scenario) {
  const pid_t child = fork();
  if (child == 0) {
    scenario.play();
    std::exit(0);
  }
  int ended = -1;
  waitpid(child, &ended, 0);
  std::printf("%s: %s\n", ended == 0 ? "ok" : "FAILED", scenario.name);
  return ended == 0;
}

}  // namespace

int play(const std::vector<Scenario>& scenarios) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  int failed = 0;
  for (const Scenario& each : scenarios) failed += held(each) ? 0 : 1;
  return failed;
}
