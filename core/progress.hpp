// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>

namespace seamwright {

/// Called from time to time during long work with the share that is done, 0..1, always from the
/// caller's thread. If it returns false the work stops and throws Cancelled.
using Progress = std::function<bool(double share)>;

/// Progress of a part of longer work, which runs from one share of the whole to another.
inline Progress partOf(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [&progress, from, to](double share) { return progress(from + share * (to - from)); };
}

/// The work was stopped by its Progress; nothing was changed.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Tells the progress what share is done. \throws Cancelled if it returns false.
inline void checkProgress(const Progress& progress, double share) {
  if (progress && !progress(share)) throw Cancelled();
}

/// A share for work of an unknown number of steps: it grows with the steps and stays below 1.
inline double shareAfter(int steps) {
  // A choice: ten steps, about as many as most searches take, are half of the bar.
  constexpr double half = 10;
  return 1 - std::exp2(-steps / half);
}

}  // namespace seamwright
