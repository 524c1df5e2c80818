/// Frames under the identifiers of this node, of which a bus may have several.

#pragma once

#include "node_settings.h"

namespace exoid {

/// `Uplink` has `bool send(const Frame&)`, false where a frame was lost.
template <class Uplink>
class AddressedUplink {
 public:
  AddressedUplink(Uplink& uplink, const NodeSettings& settings)
      : uplink_(uplink), settings_(settings) {}

  bool send(const Frame& frame) {
    Frame addressed = frame;
    addressed.id = static_cast<uint16_t>(frame.id + settings_.node_id * NODE_STRIDE);
    const bool sent = uplink_.send(addressed);
    if (!sent) ++lost_;
    return sent;
  }

  /// Frames that were lost so far.
  uint32_t lost() const { return lost_; }

 private:
  Uplink& uplink_;
  const NodeSettings& settings_;
  uint32_t lost_ = 0;
};

}  // namespace exoid
