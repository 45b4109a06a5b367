// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <stdexcept>

namespace seamwright::occ {

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

}  // namespace seamwright::occ
