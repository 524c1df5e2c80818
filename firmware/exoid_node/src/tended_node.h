/// The node with its settings, put together of its parts.

#pragma once

#include "addressed_uplink.h"
#include "caretaker.h"
#include "mounted_encoder.h"
#include "node.h"

namespace exoid {

/// What is made of the parts of a node.
template <class Parts>
struct Made {
  using Encoder = MountedEncoder<typename Parts::Encoder>;
  using Link = typename Parts::Link;
  using Uplink = AddressedUplink<Link>;
  using Clock = typename Parts::Clock;
  using Board = typename Parts::Board;
  using Node = exoid::Node<Encoder, typename Parts::Imu, Uplink, Clock>;
  using Commission = Commissioning<Encoder, typename Parts::Flash>;
};

/// `Parts` names the types of encoder, inertial sensor, link to the host, flash, board and clock.
template <class Parts>
class TendedNode {
  using Link = typename Parts::Link;
  using Board = typename Parts::Board;
  using Clock = typename Parts::Clock;

 public:
  TendedNode(typename Parts::Encoder& encoder, typename Parts::Imu& imu, Link& link,
             typename Parts::Flash& flash, Board& board, const Clock& clock)
      : link_(link),
        board_(board),
        store_(flash),
        encoder_(encoder, store_.settings()),
        uplink_(link, store_.settings()),
        node_(encoder_, imu, uplink_, clock),
        commission_(Board::serial(), encoder_, store_),
        caretaker_(node_, link, uplink_, commission_, board, clock) {}

  /// Reads the settings and brings the link up with them.
  void begin() {
    store_.load();
    link_.begin(store_.settings().bit_rate * BIT_RATE_STEP);
    board_.begin(!link_.health().on_can);
  }

  /// Does what is due. Call it as often as possible.
  void run() {
    // Whoever begins to listen hears the filter's start, and how the node was commissioned.
    if (link_.poll()) {
      node_.restart();
      caretaker_.tell_soon();
    }
    node_.run();
    caretaker_.run();
  }

 private:
  Link& link_;
  Board& board_;
  SettingsStore<typename Parts::Flash> store_;
  typename Made<Parts>::Encoder encoder_;
  typename Made<Parts>::Uplink uplink_;
  typename Made<Parts>::Node node_;
  typename Made<Parts>::Commission commission_;
  Caretaker<Made<Parts>> caretaker_;
};

}  // namespace exoid
