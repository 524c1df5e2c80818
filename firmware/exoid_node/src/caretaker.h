/// What a node does beside measuring: it hears commands, tells how it is, and blinks.

#pragma once

#include "blink.h"
#include "bus_health.h"
#include "commissioning.h"

namespace exoid {

/// `Parts` names the types; of their objects it wants: `Node` restart() and healthy(); `Link`
/// bool receive(Frame&) and BusHealth health(); `Uplink` send(Frame) and lost(); `Board`
/// supply_mv() and light(bool); `Clock` as for the node.
template <class Parts>
class Caretaker {
 public:
  Caretaker(typename Parts::Node& node, typename Parts::Link& link, typename Parts::Uplink& uplink,
            typename Parts::Commission& commission, typename Parts::Board& board,
            const typename Parts::Clock& clock)
      : node_(node),
        link_(link),
        uplink_(uplink),
        commission_(commission),
        board_(board),
        clock_(clock) {}

  /// Does what is due. Call it as often as possible.
  void run() {
    Frame frame = {};
    if (!answering_ && link_.receive(frame)) hear(frame);
    const uint32_t now = clock_.ticks();
    // Between the samples, when neither sensors nor their frames wait.
    if (now == tick_ || clock_.age_us() < TICK_US / 2) return;
    tick_ = now;
    if (answering_) uplink_.send(pack(outcome_.reply));
    if (answering_ || telling_ || now - told_ >= TICKS_PER_HEARTBEAT) tell();
    answering_ = false;
    board_.light(is_lit(blink(), now));
  }

  /// Tells how the node is at the next opportunity: somebody has just begun to listen.
  void tell_soon() { telling_ = true; }

 private:
  void hear(const Frame& frame) {
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
    bus_ = link_.health();
    const Heartbeat heartbeat = {FIRMWARE_VERSION[0],     FIRMWARE_VERSION[1],
                                 FIRMWARE_VERSION[2],     board_.supply_mv() / SUPPLY_STEP_MV,
                                 bus_.transmit_errors,    bus_.receive_errors,
                                 uplink_.lost() & 255U,   !node_.healthy(),
                                 bus_.off,                bus_.on_can};
    uplink_.send(pack(commission_.settings()));
    uplink_.send(pack(heartbeat));
  }

  Blink blink() const {
    if (static_cast<int32_t>(blink_until_ - tick_) > 0) return Blink::IDENTIFY;
    if (is_ill(bus_)) return Blink::BUS_FAULT;
    if (!node_.healthy()) return Blink::SENSOR_FAULT;
    return commission_.settings().commissioned ? Blink::WELL : Blink::NOT_COMMISSIONED;
  }

  typename Parts::Node& node_;
  typename Parts::Link& link_;
  typename Parts::Uplink& uplink_;
  typename Parts::Commission& commission_;
  typename Parts::Board& board_;
  const typename Parts::Clock& clock_;
  BusHealth bus_ = {};
  Outcome outcome_ = {};
  uint32_t tick_ = 0;
  uint32_t told_ = 0U - TICKS_PER_HEARTBEAT;  // tick
  uint32_t blink_until_ = 0;                  // tick
  bool answering_ = false;
  bool telling_ = false;
};

}  // namespace exoid
