/// What a node does beside measuring: it hears commands, tells how it is, and blinks.

#pragma once

#include "blink.h"
#include "commissioning.h"
#include "condition.h"

namespace exoid {

/// `Parts` has `link`, with `bool receive(Frame&)`; `board`, with `supply_mv()` and `light(bool)`;
/// `clock`, as for the node; and `condition`, with `describe(Health&)`. `Node` has `restart()`,
/// `tell_loss()` and `healthy()`; `Uplink` has `bool send(const Frame&)` and `lost()`.
template <class Parts, class Node, class Uplink, class Commission>
class Caretaker {
 public:
  Caretaker(const Parts& parts, Node& node, Uplink& uplink, Commission& commission)
      : parts_(parts), node_(node), uplink_(uplink), commission_(commission) {}

  /// Does what is due. Call it as often as possible.
  void run() {
    // To store settings holds the processor for 10 ms, at most one tick: begun in the first half of
    // a tick it is over in that of the next, whose sample is late by that much and not missed.
    if (parts_.clock.age_us() < TICK_US / 2) return hear();
    // In the second half neither sensors nor their frames wait.
    const uint32_t now = parts_.clock.ticks();
    if (now == tick_) return;
    tick_ = now;
    if (answering_) send(pack(outcome_.reply));
    if (answering_ || telling_ || now - told_ >= TICKS_PER_HEARTBEAT) tell();
    answering_ = false;
    parts_.board.light(is_lit(blink(), now));
  }

  /// Tells how the node is at the next opportunity: somebody has just begun to listen.
  void tell_soon() { telling_ = true; }

 private:
  void hear() {
    Frame frame = {};
    if (answering_ || !parts_.link.receive(frame)) return;
    answering_ = commission_.hear(frame, outcome_);
    if (!answering_) return;
    if (outcome_.remounted) node_.restart();
    if (outcome_.reply.command == IDENTIFY_ID) {
      blink_until_ = tick_ + outcome_.blinking * (1000000 / TICK_US);
    }
  }

  void tell() {
    telling_ = false;
    told_ = tick_;
    health_.counter = tick_ & 255U;
    parts_.condition.describe(health_);
    const Heartbeat heartbeat = {FIRMWARE_VERSION[0],     FIRMWARE_VERSION[1],
                                 FIRMWARE_VERSION[2],     parts_.board.supply_mv() / SUPPLY_STEP_MV,
                                 uplink_.lost() & 255U,   !node_.healthy()};
    send(pack(commission_.settings()));
    send(pack(heartbeat));
    send(pack(health_));
  }

  void send(const Frame& frame) {
    if (!uplink_.send(frame)) node_.tell_loss();
  }

  Blink blink() const {
    if (static_cast<int32_t>(blink_until_ - tick_) > 0) return Blink::IDENTIFY;
    if (is_bus_ill(health_)) return Blink::BUS_FAULT;
    if (!node_.healthy()) return Blink::SENSOR_FAULT;
    return commission_.settings().commissioned ? Blink::WELL : Blink::NOT_COMMISSIONED;
  }

  const Parts parts_;
  Node& node_;
  Uplink& uplink_;
  Commission& commission_;
  Health health_ = {};  // as it was told last
  Outcome outcome_ = {};
  uint32_t tick_ = 0;
  uint32_t told_ = 0U - TICKS_PER_HEARTBEAT;  // tick
  uint32_t blink_until_ = 0;                  // tick
  bool answering_ = false;
  bool telling_ = false;
};

}  // namespace exoid
