/// Do samples come as they should? Lost ones are forgotten after a while.

#pragma once

#include "learning.h"

namespace exoid {

class StreamHealth {
 public:
  void see(int32_t gyro, bool sees_angle, bool sees_rate, uint32_t missed) {
    if (!sees_angle || !sees_rate || missed > 0) {
      faults_ += learning::FAULT_WEIGHT;
      if (faults_ > 2 * learning::FAULTS) faults_ = 2 * learning::FAULTS;
    } else if (faults_ > 0) {
      --faults_;
    }
    if (!sees_rate) {
      if (silent_ <= learning::LONGEST_SILENT) ++silent_;
      return;
    }
    silent_ = 0;
    if (gyro != gyro_) {
      same_ = 0;
    } else if (same_ < learning::FROZEN) {
      ++same_;
    }
    gyro_ = gyro;
  }

  /// Has the gyro been silent for longer than a movement can do without it?
  bool is_silent() const { return silent_ > learning::LONGEST_SILENT; }

  bool is_faulty() const { return faults_ > learning::FAULTS || same_ >= learning::FROZEN; }

 private:
  int32_t faults_ = 0;
  int32_t gyro_ = 0;    // count
  int32_t same_ = 0;    // ticks for which it has not changed
  int32_t silent_ = 0;  // ticks for which there was none
};

}  // namespace exoid
