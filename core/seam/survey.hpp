// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <seamwright/core/seam/tolerance.hpp>

namespace seamwright {

/// The largest value of a quantity along a seam: lower <= true maximum <= upper.
struct Figure {
  double lower = 0;             ///< a value attained at \p at
  std::optional<double> upper;  ///< nothing if no bound is known: the maximum may be larger
  double at = 0;                ///< position along the seam, 0..1 of its parameter range
};

/// What a figure leaves out of the seam.
struct LeftOut {
  std::vector<Interval> intervals;  ///< intervals of 0..1 that do not touch, in increasing order
  /// Upper bound of the quantity in these intervals. Points within 2^-30 of the seam, in parameter
  /// and in length, of a point without a tangent plane are not covered: they count as that point.
  /// Nothing if no bound is known.
  std::optional<double> upper = 0;
  double longest_mm = std::numeric_limits<double>::infinity();  ///< no interval is longer

  /// Whether nothing that counts exceeds the limit. Intervals no longer than the accepted gap do
  /// not count: to the user they are points.
  bool isWithin(double limit, const ContinuityTolerance& tolerance) const {
    return longest_mm <= tolerance.gap_mm || (upper && *upper <= limit);
  }
};

/// A point of the seam where a side has no tangent plane.
struct DegeneratePoint {
  double at = 0;  ///< 0..1
  Degeneracy side_a = Degeneracy::None;
  Degeneracy side_b = Degeneracy::None;
};

/// The figures of a seam over its whole length.
struct SeamFigures {
  /// Nothing if not measured, or if a point is not finite; in that case no figure has a value.
  std::optional<Figure> gap_mm;
  std::optional<Figure> angle_rad;  ///< nothing if no point has two tangent planes
  /// Nothing if the angle is above the crease angle, or if not measured.
  std::optional<Figure> curvature_per_mm;
  std::optional<Figure> curvature_rel;
  /// Nothing if the angle is above the crease angle, or if not asked for.
  std::optional<Figure> curvature_change_per_mm2;
  std::optional<Figure> curvature_change_rel;
  LeftOut angle_left_out;      ///< what angle_rad leaves out; the bound is in rad
  LeftOut curvature_left_out;  ///< what both curvature figures leave out; the bound is one of
                               ///< curvature_rel
  std::optional<double>
      fold_at;  ///< a point where the faces fold back at less than the crease angle
  double below_crease_share =
      0;  ///< share of the length over which the angle is within the crease angle, 0..1
  double plane_share = 1;  ///< share of the length over which both sides have a tangent plane, 0..1
  bool shares_known = false;  ///< proven: whether below_crease_share is above a half, and
                              ///< whether the faces fold
  /// Every upper bound is known; if only the verdict was wanted, every one that counts for it.
  bool certified = false;
  std::string uncertified;  ///< why not certified, if an enclosure was tried
  bool settled = true;      ///< false: figures still changed when the limit of points was reached
  std::vector<DegeneratePoint> degenerate;
  int points = 0;

  /// What the figures of the change of curvature leave out: the same as those of the curvature, but
  /// without a bound.
  LeftOut curvatureChangeLeftOut() const {
    LeftOut left_out = curvature_left_out;
    if (!left_out.intervals.empty()) left_out.upper.reset();
    return left_out;
  }
};

struct SurveyOptions {
  int points_per_span = 5;  ///< Chebyshev-Lobatto points to begin with, >= 3
  int first_points = 25;    ///< least number of points to begin with, over all spans
  int max_points = 4000;    ///< points <= max_points, unless the spans alone need more
  int max_halvings =
      14;  ///< no piece is shorter than 2^-max_halvings of the share of a span for one point
};

/// A function that measures the pair of points at parameter t of the seam.
using PairAt = std::function<PairMeasure(double t)>;

/// Finds the largest gap, angle and curvature difference along a seam by adaptive sampling. Where
/// the pairs have it, it also finds the largest difference of the change of curvature.
///
/// Between two \p breaks both sides must be smooth. Every span starts with Chebyshev-Lobatto
/// points; at inner breaks, where derivatives may jump, they lie just inside the span. The span is
/// refined where two conditions hold: linear interpolation of a figure between neighbours may be
/// off by more than 1 % of its maximum or a hundredth of its tolerance, whichever is larger; and
/// the figure may exceed the maximum seen so far. Sampling proves nothing: every upper bound is
/// unknown, and certified is false.
///
/// \param breaks increasing, at least two; the first and the last are the ends of the seam.
/// \throws std::invalid_argument if the breaks are fewer than two or do not increase.
SeamFigures surveySeam(const PairAt& pair_at, std::span<const double> breaks,
                       const ContinuityTolerance& tolerance, const SurveyOptions& options = {});

}  // namespace seamwright
