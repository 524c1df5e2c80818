/// Scenarios, what they ask for, and their player.

#pragma once

#include <vector>

struct Scenario {
  const char* name;
  void (*play)();
};

/// Ends the program with the sentence that does not hold.
void check(bool holds, const char* sentence, int line = __builtin_LINE());

/// Plays them all, each in a process, tells what they came to, and returns how many failed.
int play(const std::vector<Scenario>& scenarios);
