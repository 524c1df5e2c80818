/// The watchdog: resets a node that has taken no sample for 125 ms.

#pragma once

#include <stdint.h>

namespace exoid {

class Watchdog {
 public:
  void begin();
  /// A sample was taken. Never waits.
  void feed();
};

}  // namespace exoid
