/// Ends a test program of this machine with the sentence that does not hold.

#pragma once

#include <cstdio>
#include <cstdlib>

inline void check(bool holds, const char* sentence, int line = __builtin_LINE()) {
  if (holds) return;
  std::fprintf(stderr, "line %d: it does not hold that %s\n", line, sentence);
  std::exit(1);
}
