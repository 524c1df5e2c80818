/// The watchdog, which resets a node that has taken no sample for 125 ms; and why the node started.

#pragma once

#include <stdint.h>

namespace exoid {

class Watchdog {
 public:
  void begin();
  /// A sample was taken. Never waits.
  void feed();
  /// Whether it has started the node.
  bool has_reset() const { return has_reset_; }
  /// The processor does not tell a dip of its supply from its start.
  bool supply_dipped() const { return false; }

 private:
  bool has_reset_ = false;
};

}  // namespace exoid
