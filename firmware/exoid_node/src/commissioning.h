/// What the commands of exoid.dbc do to a node.

#pragma once

#include "exo_can.h"
#include "settings_store.h"

namespace exoid {

/// What came of a command.
struct Outcome {
  Reply reply;
  bool remounted;     // the angle is measured otherwise from now on
  uint32_t blinking;  // s for which somebody wants to see this node; 0 for no such wish
  bool silent;        // nothing is to be said of it
};

/// `Encoder` has `bool zero_for(angle, zero)` and `told_zero(zero)`; `Flash` as for the store.
/// `Torque` has `hear(load, reply)` and `hear(allow)`.
template <class Encoder, class Flash, class Torque>
class Commissioning {
 public:
  Commissioning(uint32_t serial, const Encoder& encoder, SettingsStore<Flash>& store,
                Torque& torque)
      : serial_(serial), encoder_(encoder), store_(store), torque_(torque) {}

  /// Does what a frame commands; returns whether that is to be answered. Does nothing where it is
  /// no command, is one to another node, or asks for what no node can do.
  bool hear(const Frame& frame, Outcome& outcome) {
    if (!is_command(frame)) return false;
    switch (frame.id) {
      case TELL_ID: return take<Tell>(frame, outcome);
      case SET_ZERO_ID: return take<SetZero>(frame, outcome);
      case SET_DIRECTION_ID: return take<SetDirection>(frame, outcome);
      case SET_NODE_ID_ID: return take<SetNodeId>(frame, outcome);
      case SET_BIT_RATE_ID: return take<SetBitRate>(frame, outcome);
      case IDENTIFY_ID: return take<Identify>(frame, outcome);
      case LOAD_ID: return take<Load>(frame, outcome);
      case ALLOW_ID: return take<Allow>(frame, outcome);
      default: return false;
    }
  }

  /// What the node tells of itself.
  Settings settings() const {
    const NodeSettings& now = store_.settings();
    return {serial_,      Encoder::told_zero(now.zero), now.reversed, store_.stored(),
            now.bit_rate, store_.changes() & 255U};
  }

 private:
  template <class Command>
  bool take(const Frame& frame, Outcome& outcome) {
    Command command;
    unpack(frame, command);
    if (!is_for_me(command) || !is_valid(command)) return false;
    outcome = {};
    outcome.reply.serial = serial_;
    outcome.reply.command = frame.id;
    obey(command, outcome);
    return !outcome.silent;
  }

  template <class Command>
  bool is_for_me(const Command& command) const {
    return command.serial == serial_;
  }

  bool is_for_me(const Tell& tell) const { return tell.serial == 0 || tell.serial == serial_; }

  void obey(const Tell&, Outcome&) {}

  void obey(const SetZero& set, Outcome& outcome) {
    NodeSettings wanted = store_.settings();
    if (!encoder_.zero_for(set.angle, wanted.zero)) {
      outcome.reply.no_angle = true;
      return;
    }
    save(wanted, outcome);
  }

  void obey(const SetDirection& set, Outcome& outcome) {
    NodeSettings wanted = store_.settings();
    wanted.reversed = set.reversed;
    save(wanted, outcome);
  }

  void obey(const SetNodeId& set, Outcome& outcome) {
    NodeSettings wanted = store_.settings();
    wanted.node_id = static_cast<uint8_t>(set.node_id);
    save(wanted, outcome);
  }

  void obey(const SetBitRate& set, Outcome& outcome) {
    if (!is_bit_rate(set.bit_rate)) {
      outcome.reply.not_possible = true;
      return;
    }
    NodeSettings wanted = store_.settings();
    wanted.bit_rate = static_cast<uint8_t>(set.bit_rate);
    save(wanted, outcome);
  }

  void obey(const Identify& identify, Outcome& outcome) { outcome.blinking = identify.duration; }

  void obey(const Load& load, Outcome& outcome) { torque_.hear(load, outcome.reply); }

  void obey(const Allow& allow, Outcome& outcome) {
    torque_.hear(allow);
    outcome.silent = true;
  }

  void save(const NodeSettings& wanted, Outcome& outcome) {
    const NodeSettings before = store_.settings();
    outcome.remounted = wanted.zero != before.zero || wanted.reversed != before.reversed;
    outcome.reply.not_stored = !store_.save(wanted);
  }

  const uint32_t serial_;
  const Encoder& encoder_;
  SettingsStore<Flash>& store_;
  Torque& torque_;
};

}  // namespace exoid
