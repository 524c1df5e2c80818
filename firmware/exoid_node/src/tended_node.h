/// The node with its settings, put together of its parts.

#pragma once

#include "addressed_uplink.h"
#include "caretaker.h"
#include "mounted_encoder.h"
#include "node.h"
#include "torque_command.h"

namespace exoid {

/// What a node is made of. `Kinds` names the types.
template <class Kinds>
struct Parts {
  typename Kinds::Encoder& encoder;
  typename Kinds::Imu& imu;
  typename Kinds::Link& link;
  typename Kinds::Flash& flash;
  typename Kinds::Board& board;
  const typename Kinds::Clock& clock;
  const typename Kinds::Condition& condition;
};

/// `Kinds` names the types of encoder, inertial sensor, link to the host, flash, board, clock, and
/// of how it all fares.
template <class Kinds>
class TendedNode {
 public:
  explicit TendedNode(const Parts<Kinds>& parts)
      : parts_(parts),
        store_(parts.flash),
        command_(parts.flash),
        encoder_(parts.encoder, store_.settings()),
        uplink_(parts.link, store_.settings()),
        node_(encoder_, parts.imu, uplink_, parts.clock, command_),
        commission_(Kinds::Board::serial(), encoder_, store_, command_),
        caretaker_(parts, node_, uplink_, commission_) {}

  /// Reads what is stored and brings the link up with it.
  void begin() {
    store_.load();
    command_.load();
    parts_.link.begin(store_.settings().bit_rate * BIT_RATE_STEP);
    parts_.board.begin();
  }

  /// Does what is due; returns whether that was a sample. Call it as often as possible.
  bool run(uint32_t now_ms) {
    if (parts_.link.poll(now_ms)) {
      // Whoever begins to listen hears how the node was commissioned, and the filter's start unless
      // somebody on CAN listens already.
      if (!parts_.link.is_on_can()) node_.restart();
      caretaker_.tell_soon();
    }
    const bool sampled = node_.run();
    caretaker_.run();
    return sampled;
  }

 private:
  using Encoder = MountedEncoder<typename Kinds::Encoder>;
  using Uplink = AddressedUplink<typename Kinds::Link>;
  using Command = TorqueCommand<typename Kinds::Flash>;
  using Measuring = Node<Encoder, typename Kinds::Imu, Uplink, typename Kinds::Clock, Command>;
  using Commission = Commissioning<Encoder, typename Kinds::Flash, Command>;

  const Parts<Kinds> parts_;
  SettingsStore<typename Kinds::Flash> store_;
  Command command_;
  Encoder encoder_;
  Uplink uplink_;
  Measuring node_;
  Commission commission_;
  Caretaker<Parts<Kinds>, Measuring, Uplink, Commission> caretaker_;
};

}  // namespace exoid
