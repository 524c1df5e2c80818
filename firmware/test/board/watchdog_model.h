/// The watchdog: it counts once it is enabled, and takes 5 ms to notice that it was fed.

#pragma once

#include <stdint.h>

namespace simulated {

class WatchdogModel {
 public:
  explicit WatchdogModel(uint64_t& now_us) : now_us_(now_us) {}

  void enable(bool enabled) {
    enabled_ = enabled;
    fed_us_ = now_us_;
  }

  void feed(uint8_t key) {
    if (is_busy()) now_us_ = busy_us_;  // the write stops the processor until then
    if (key == 0xA5) fed_us_ = now_us_;
    busy_us_ = now_us_ + BUSY_US;
  }

  bool is_busy() const { return now_us_ < busy_us_; }

  /// Whether it has had enough.
  bool barks() const { return enabled_ && now_us_ - fed_us_ > LONGEST_US; }

 private:
  static constexpr uint32_t BUSY_US = 5000;
  static constexpr uint32_t LONGEST_US = 125000;  // 128 counts of 1024 Hz

  uint64_t& now_us_;
  uint64_t fed_us_ = 0, busy_us_ = 0;
  bool enabled_ = false;
};

}  // namespace simulated
