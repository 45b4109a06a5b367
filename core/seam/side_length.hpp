// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/seam/side_evaluator.hpp>

namespace seamwright {

/// Lengths, in mm, of intervals of one side of a seam.
class SideLength {
 public:
  /// Keeps a reference to the evaluator.
  explicit SideLength(const SideEvaluator& side) : side_(side) {}

  /// Bounds of the length over an interval of the parameter of the seam. Chords give the lower
  /// bound and control polygons the upper one. Where a short interval lies across a knot line, the
  /// lower bound is that of the shortest alternative and the upper bound that of the longest one.
  /// The upper bound is infinite if there are too many knot lines.
  Interval of(double from, double to) const { return of(from, to, 6); }

  /// A lower bound of the length of the side: the length of a polygon through those points that are
  /// known.
  double whole_mm() const;

  /// Whether an interval is no longer than the given share of the seam, both by length and by
  /// parameter.
  bool isShort(double from, double to, double share) const;

 private:
  Interval of(double from, double to, int halvings) const;

  const SideEvaluator& side_;
  mutable std::optional<double> whole_mm_;
};

}  // namespace seamwright
