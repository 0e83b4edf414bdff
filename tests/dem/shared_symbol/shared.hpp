#pragma once

/// Not inlined, so that every object that uses it defines it, weakly.
[[gnu::noinline]] inline double sum_of(const double* values, int count) {
  double sum = 0;
  for (int k = 0; k < count; ++k) sum += values[k];
  return sum;
}
