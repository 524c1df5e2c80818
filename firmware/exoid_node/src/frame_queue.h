/// The frames that wait for a controller, in their order.

#pragma once

#include "frame.h"

namespace exoid {

class FrameQueue {
 public:
  bool is_empty() const { return head_ == tail_; }

  /// Returns false where there is no room.
  bool push(const Frame& frame) {
    if (head_ - tail_ == SIZE) return false;
    ring_[head_++ % SIZE] = frame;
    return true;
  }

  const Frame& front() const { return ring_[tail_ % SIZE]; }

  void pop() { ++tail_; }

  void clear() { tail_ = head_; }

 private:
  static constexpr uint32_t SIZE = 16;  // frames of 50 ms; must divide 2^32

  Frame ring_[SIZE] = {};
  uint32_t head_ = 0, tail_ = 0;  // frames ever queued, ever taken
};

}  // namespace exoid
