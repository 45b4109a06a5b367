// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/planar/biarc.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// Points of the plane, one per row: #P by 2.
using PlanarPoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// What the tangents at the points of a biarc spline minimise. alpha and beta are the angles of the
/// tangents at a segment against its chord, see ChordAngles; l is the length of the chord.
enum class TangentRule {
  /// sum (alpha - beta)^2: every biarc is close to one circle. The influence of an end tangent does
  /// not decay along the curve, and a closed polygon with an even number of points has no solution.
  NearCircles,
  /// sum (alpha^2 + beta^2) / l + lambda sum (alpha - beta)^2 / l. With lambda = 1 this is half of
  /// the linearised bending energy.
  LinearEnergy,
  /// The bending energy of the biarcs with equal chords, the integral of k^2 by arc length. The
  /// minimum is found by Gauss-Newton steps from LinearEnergy.
  Energy,
};

struct TangentOptions {
  TangentRule rule = TangentRule::LinearEnergy;
  double lambda = 1;    ///< for LinearEnergy; at least 0
  bool closed = false;  ///< a segment joins the last point with the first one
  /// Tangents at the ends of an open curve. Without a value the tangent of a natural end is part of
  /// the minimisation; with NearCircles it is that of the circle through the three end points.
  std::optional<double> start_direction_rad = {}, end_direction_rad = {};
};

struct Tangents {
  std::vector<double> directions_rad;  ///< at each point
  int steps = 0;                       ///< Gauss-Newton steps
};

/// Tangent directions at points, for biarcs between neighbours, in O(n) for each step.
/// Identities (each has a test of its number):
///   (1) The derivative of what the rule minimises by each free direction is 0 up to rounding (for
///       Energy: up to 1e-9 of its terms).
///   (2) Points on one circle get the tangents of that circle, for NearCircles with any spacing,
///   for
///       the other rules with equal spacing.
///   (3) Reversed points get reversed tangents; rigid motion and scaling move them along.
/// \throws std::invalid_argument for fewer than 2 points (closed: 3), numbers that are not finite,
/// neighbours that are equal, end directions of a closed curve, and lambda below 0. Throws
/// std::domain_error if the polygon reverses its direction at a point (with its index), if an angle
/// between tangent and chord exceeds 2 pi / 3 (a point has to be inserted), and if the equations
/// are singular.
/// Source: docs/theory/planar.md P3.1 to P3.3.
Tangents tangentsAt(const PlanarPoints& points, const TangentOptions& options = {});

/// Biarcs through points, G1.
struct BiarcSpline {
  std::vector<PlanarArc> arcs;  ///< two for each segment
  std::vector<double> directions_rad;
  double energy_per_mm = 0;  ///< integral of k^2 by arc length
  bool closed = false;
};

/// \param rule of the joint in each segment. \throws as tangentsAt() and biarc() do.
/// Source: docs/theory/planar.md P2.1, P3.1 to P3.3.
BiarcSpline biarcSpline(const PlanarPoints& points, const TangentOptions& options = {},
                        BiarcRule rule = BiarcRule::EqualChords);

/// Integral of the squared curvature by arc length.
double bendingEnergy_per_mm(const std::vector<PlanarArc>& arcs);

/// A chain of arcs as rational quadratic segments with the arc length as knots. The end of each arc
/// is replaced by the start of the next one, so the curve has no gaps.
/// \throws std::invalid_argument if an arc ends further than \p gap_mm from the start of the next
/// one, or if the chain is empty.
BezierSpline bezierSpline(const std::vector<PlanarArc>& arcs, bool closed, double gap_mm);

}  // namespace seamwright
