/// A covariance as U D U' (Bierman 1977): U has ones on its diagonal and is kept above it.
///
/// Needs no square root, and with positive D is no covariance of rounding's making.

#pragma once

#include <stdint.h>

namespace exoid {

/// Means, D, and U by columns: the element (row, column) with row < column.
template <int32_t SIZE>
struct Factored {
  float mean[SIZE];
  float variance[SIZE];
  float upper[SIZE * (SIZE - 1) / 2];

  float& at(int32_t row, int32_t column) { return upper[column * (column - 1) / 2 + row]; }
  float at(int32_t row, int32_t column) const { return upper[column * (column - 1) / 2 + row]; }
};

/// One element of U D U'.
template <int32_t SIZE>
float covariance(const Factored<SIZE>& belief, int32_t row, int32_t column) {
  float sum = 0.0F;
  for (int32_t k = row > column ? row : column; k < SIZE; ++k) {
    float part = belief.variance[k];
    if (k != row) part = part * belief.at(row, k);
    if (k != column) part = part * belief.at(column, k);
    sum = sum + part;
  }
  return sum;
}

/// What a measurement did.
struct Correction {
  bool used;      // it was believed
  float weighed;  // innovation over its variance
  float square;   // innovation squared over its variance
};

/// One scalar measurement (Bierman's update), in pieces: columns are narrowed one after the other.
template <int32_t SIZE>
class Update {
 public:
  float slope[SIZE];  // of what is measured, of the unknowns; to be set before it begins

  /// It is off by `innovation`, of the variance `noise` and a share of what is not known of it. One
  /// whose chi-square is beyond `gate` changes nothing.
  void begin(const Factored<SIZE>& belief, float innovation, float noise, float share, float gate) {
    float seen = 0.0F;
    for (int32_t k = 0; k < SIZE; ++k) {
      gain_[k] = slope[k] * belief.variance[k];
      seen = seen + slope[k] * gain_[k];
    }
    noise_ = noise + share * seen;
    float sum = noise_;
    for (int32_t k = 0; k < SIZE; ++k) total_[k] = sum = sum + slope[k] * gain_[k];
    innovation_ = innovation;
    used_ = !(innovation * innovation > gate * sum);
    inverse_ = 1.0F / total_[0];
  }

  /// The columns from `first` up to `end`, which follow those before.
  void narrow(Factored<SIZE>& belief, int32_t first, int32_t end) {
    if (!used_) return;
    for (int32_t k = first; k < end; ++k) narrow(belief, k);
  }

  /// All columns are narrowed.
  Correction end(Factored<SIZE>& belief) const {
    if (!used_) return {false, 0.0F, 0.0F};
    const float weighed = innovation_ * inverse_;
    for (int32_t k = 0; k < SIZE; ++k) belief.mean[k] = belief.mean[k] + gain_[k] * weighed;
    return {true, weighed, innovation_ * weighed};
  }

 private:
  void narrow(Factored<SIZE>& belief, int32_t k) {
    if (k == 0) {
      if (slope[0] != 0.0F) belief.variance[0] = belief.variance[0] * noise_ * inverse_;
      return;
    }
    const float own = gain_[k], pull = -slope[k] * inverse_;
    inverse_ = 1.0F / total_[k];
    belief.variance[k] = belief.variance[k] * total_[k - 1] * inverse_;
    float* column = &belief.upper[k * (k - 1) / 2];
    for (int32_t row = 0; row < k; ++row) {
      const float old = column[row];
      column[row] = old + pull * gain_[row];
      gain_[row] = gain_[row] + own * old;
    }
  }

  float gain_[SIZE], total_[SIZE];
  float innovation_, noise_;
  float inverse_;  // of the last column's total
  bool used_;
};

}  // namespace exoid
