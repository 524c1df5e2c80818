/// The filter over a file of measurements, the same on every machine: what comes out is compared
/// bit by bit.

#pragma once

#include "kalman.h"

namespace exoid {

struct Measured {
  float angle, rate;  // rad, rad/s; NaN where nothing was measured
};

/// `Input` and `Output` have `bool read(bytes, size)` and `bool write(bytes, size)`.
template <class Input, class Output>
bool run_filter(Input& input, Output& output) {
  Belief belief = {};
  Measured measured;
  for (bool first = true; input.read(&measured, sizeof measured); first = false) {
    const Measurement angle = {measured.angle, true}, rate = {measured.rate, true};
    belief = first ? begin(angle, rate) : advance(belief, angle, rate);
    if (!output.write(&belief, sizeof belief)) return false;
  }
  return true;
}

}  // namespace exoid
