/// The torque that the node commands once a tick. Emulated and simulated only; no safety function.

#pragma once

#include "angle_watch.h"
#include "permission.h"
#include "received_parameters.h"

namespace exoid {

/// `Flash` as for what is kept.
template <class Flash>
class TorqueCommand {
 public:
  explicit TorqueCommand(Flash& flash) : kept_(flash) {}

  /// Takes over the parameters that were stored last.
  void load() { kept_.load(); }

  /// A part of new parameters. The last one puts them in the place of those before.
  void hear(const Load& load, Reply& reply) {
    if (load.place < PARTS) {
      reply.not_whole = !received_.take(load.place, load.data);
      return;
    }
    TorqueParameters found;
    reply.not_whole = !received_.end(load.data, found);
    if (reply.not_whole) return;
    reply.not_plausible = !is_plausible(found);
    if (reply.not_plausible) return;
    permission_.forbid(NO_PARAMETERS);
    reply.not_stored = !kept_.save(found);
  }

  /// What a host wishes.
  void hear(const Allow& allow) {
    const Wish wish = static_cast<Wish>(allow.wish);
    asked_ = true;
    if (!permission_.hear(wish, allow.number)) return;
    acceleration_ = allow.acceleration;
    if (wish == Wish::ARM) allowed_ = static_cast<float>(allow.limit) * LIMIT_STEP;
  }

  /// The torque at a tick, of what was measured and what the filter made of it: `faults` are the
  /// bits of EXO_STATE, `bias` [rad/s] is the gyro's.
  Torque update(const Sample& sample, const State& state, uint32_t faults, float bias) {
    watch_.see(sample.count, static_cast<float>(sample.gyro[1]) * GYRO_STEP - bias, faults == 0);
    const TorqueParameters& leg = kept_.now();
    const float wanted = wanted_torque(leg, state.angle, state.angular_velocity, acceleration_);
    const uint32_t doubts = faults | (watch_.is_trusted() ? 0U : ANGLE_STALE) |
                            (kept_.are_whole() ? 0U : NO_PARAMETERS) |
                            (is_finite(wanted) ? 0U : NOT_FINITE);
    const Permit permit = permission_.judge(doubts);
    const float limit = leg.limit < allowed_ ? leg.limit : allowed_;
    torque_ = permit == Permit::ENABLED
                  ? limited(wanted, torque_, limit, leg.rate_limit * TIME_STEP)
                  : 0.0F;
    return {torque_, state.counter, static_cast<uint32_t>(permit), permission_.cut_by(),
            kept_.crc()};
  }

  /// Whether the torque is to be told: a node that nobody asks for one sends what it always sent.
  bool is_asked() const { return asked_ || kept_.are_held(); }

  /// The next of the parameters, one after the other. Returns false where there are none.
  bool tell(Parameter& told) {
    if (!kept_.are_held()) return false;
    told = {place_, kept_.are_stored(), parameter(kept_.now(), place_), kept_.crc()};
    place_ = place_ + 1 < PARAMETERS ? place_ + 1 : 0;
    return true;
  }

 private:
  KeptParameters<Flash> kept_;
  ReceivedParameters received_;
  Permission permission_;
  AngleWatch watch_;
  float torque_ = 0.0F;        // N m, at the last tick
  float acceleration_ = 0.0F;  // rad/s^2, by which the leg is to be accelerated
  float allowed_ = 0.0F;       // N m, by the host
  uint32_t place_ = 0;         // of the parameter that is told next
  bool asked_ = false;
};

}  // namespace exoid
