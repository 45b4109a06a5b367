// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/seam/side_evaluator.hpp>

namespace seamwright {

/// Lengths of intervals of a seam's side, in mm.
class SideLength {
 public:
  /// Refers to the evaluator.
  explicit SideLength(const SideEvaluator& side) : side_(side) {}

  /// Bounds of the length over an interval of the seam's parameter: chords and control polygons.
  /// Across knot lines as if the side went all the way along each; infinite above if there are too
  /// many of them.
  Interval of(double from, double to) const { return of(from, to, 6); }

  /// At least so long is the side: a polygon of those of its points that are known.
  double whole_mm() const;

  /// Whether an interval is no longer than a share of the seam, by length as by parameter.
  bool isShort(double from, double to, double share) const;

 private:
  Interval of(double from, double to, int halvings) const;

  const SideEvaluator& side_;
  mutable std::optional<double> whole_mm_;
};

}  // namespace seamwright
