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

/// One scalar measurement that shows `slope` of the unknowns, off by `innovation`, of the variance
/// `noise` (Bierman's update). One whose chi-square is beyond `gate` changes nothing.
template <int32_t SIZE>
Correction correct(Factored<SIZE>& belief, const float (&slope)[SIZE], float innovation,
                   float noise, float gate) {
  float gain[SIZE], total[SIZE], sum = noise;
  for (int32_t k = 0; k < SIZE; ++k) {
    gain[k] = slope[k] * belief.variance[k];
    total[k] = sum = sum + slope[k] * gain[k];
  }
  if (innovation * innovation > gate * sum) return {false, 0.0F, 0.0F};
  float inverse = 1.0F / total[0];
  if (slope[0] != 0.0F) belief.variance[0] = belief.variance[0] * noise * inverse;
  for (int32_t k = 1; k < SIZE; ++k) {
    const float own = gain[k], pull = -slope[k] * inverse;
    inverse = 1.0F / total[k];
    belief.variance[k] = belief.variance[k] * total[k - 1] * inverse;
    float* column = &belief.upper[k * (k - 1) / 2];
    for (int32_t row = 0; row < k; ++row) {
      const float old = column[row];
      column[row] = old + pull * gain[row];
      gain[row] = gain[row] + own * old;
    }
  }
  const float weighed = innovation * inverse;
  for (int32_t k = 0; k < SIZE; ++k) belief.mean[k] = belief.mean[k] + gain[k] * weighed;
  return {true, weighed, innovation * weighed};
}

}  // namespace exoid
