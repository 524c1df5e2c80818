/// What the node says of a leg: its ratios, their errors, and how far to believe them.

#pragma once

#include "leg_learner.h"

namespace exoid {

enum class Trust : uint8_t { WAITING, LEARNING, GOOD, ENOUGH, UNEXPLAINED, CHANGED, FAULTY };

/// m l g / J, c / J, d / J, and over J the constant torque at the encoder's zero and dry friction.
enum Ratio : int32_t {
  GRAVITY_RATIO,
  STIFFNESS_RATIO,
  DAMPING_RATIO,
  TORQUE_RATIO,
  FRICTION_RATIO,
  RATIOS
};

struct Learned {
  float ratio[RATIOS];  // 1/s^2, 1/s^2, 1/s, 1/s^2
  float error[RATIOS];  // standard
  float surprise;       // mean square of the innovations; 1 of a leg that is explained
};

/// What a node knows at a tick: the beginning of the work.
struct ReadOff {
  float square;         // of m l g / J
  float ratio[RATIOS];  // but for that
  float variance[RATIOS];
  float squares;
  uint32_t counted;
  Phase phase;
  uint32_t drops;
  bool faulty, changed, unexplained;
};

inline ReadOff read_off(const LegLearner& learner) {
  const Leg& leg = learner.leg();
  const Factored<UNKNOWNS>& is = leg.belief;
  const float level = is.mean[LEVEL], upright = is.mean[UPRIGHT];
  const float square = level * level + upright * upright;
  const float along = level * level * covariance(is, LEVEL, LEVEL) +
                      2.0F * level * upright * covariance(is, LEVEL, UPRIGHT) +
                      upright * upright * covariance(is, UPRIGHT, UPRIGHT);
  return {square,
          {0.0F, is.mean[STIFFNESS], is.mean[DAMPING], is.mean[TORQUE], is.mean[FRICTION]},
          {along / square, covariance(is, STIFFNESS, STIFFNESS), covariance(is, DAMPING, DAMPING),
           covariance(is, TORQUE, TORQUE), covariance(is, FRICTION, FRICTION)},
          leg.squares,
          leg.counted,
          learner.phase(),
          learner.drops(),
          learner.is_faulty(),
          learner.has_changed(),
          learner.is_unexplained()};
}

/// The rest of it. Errors grow with innovations that are larger than they should be, and never become
/// smaller than anybody could believe.
inline Learned learned(const ReadOff& read) {
  const float mean = read.squares / static_cast<float>(read.counted > 0 ? read.counted : 1);
  const float wider = learning::CAUTION * (mean > 1.0F ? mean : 1.0F);
  Learned found = {};
  found.surprise = mean;
  for (int32_t k = 0; k < RATIOS; ++k) {
    const float error = root(wider * read.variance[k]);
    found.ratio[k] = read.ratio[k];
    found.error[k] = error > learning::LEAST_ERROR[k] ? error : learning::LEAST_ERROR[k];
  }
  found.ratio[GRAVITY_RATIO] = root(read.square);
  return found;
}

/// Are the errors within that share of gravity, that of damping beside the leg's own frequency?
inline bool is_within(const Learned& found, float share) {
  const float gravity = found.ratio[GRAVITY_RATIO], damping = found.error[DAMPING_RATIO];
  return found.error[GRAVITY_RATIO] < share * gravity &&
         found.error[STIFFNESS_RATIO] < share * gravity &&
         damping * damping < share * share * gravity;
}

/// How far to believe it; the worst that is to be said counts.
inline Trust trust(const ReadOff& read, const Learned& found) {
  if (read.faulty) return Trust::FAULTY;
  if (read.changed) return Trust::CHANGED;
  if (read.unexplained) return Trust::UNEXPLAINED;
  if (read.drops > 0 && is_within(found, learning::ENOUGH)) return Trust::ENOUGH;
  if (is_within(found, learning::GOOD)) return Trust::GOOD;
  const bool begun = read.drops > 0 || read.phase == Phase::MOVING;
  return begun ? Trust::LEARNING : Trust::WAITING;
}

}  // namespace exoid
