// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/planar/point_curvature.hpp>
#include <seamwright/core/progress.hpp>

namespace seamwright {

/// Why a method ended. Its points are usable in any case.
enum class PointFairingStatus {
  Converged,    ///< no moves are left, up to the precision of the method
  EnergyGrows,  ///< the next passes of the filter would make the energy grow; they were left out
  NotConverged  ///< its steps ran out, or rounding allows none; fairer points may exist
};

/// Points that were moved to make them fair.
struct FairedPoints {
  PlanarPoints points;
  PointFairness before, after;
  double moved_mm = 0;          ///< the largest distance of a point from where it was
  Eigen::Index most_moved = 0;  ///< the point with that distance
  int steps = 0;
  PointFairingStatus status = PointFairingStatus::NotConverged;
};

struct PointFairingOptions {
  bool closed = false;
  /// Whether the first and the last point of an open sequence stay.
  bool ends_fixed = true;
  int max_steps = 200;
};

/// Points with the least energy (PointFairness) that moves within the tolerances allow, each point
/// along the normal of the chord of its neighbours; in a sequence with neighbours nearer than twice
/// their tolerance, along the normal of a fair curve between them. An interior-point method with
/// Gauss-Newton steps; the cost of a step is O(n). Identities (each has a test of its number):
///   (1) No point moves by more than its tolerance, and a tolerance of 0 fixes a point bitwise.
///   (2) The energy does not grow. Points of a circle stay, with any spacing.
///   (3) At the result the derivative of the energy by the move of a point is 0, or points outwards
///       at a point that moved by its tolerance, up to the precision of the method.
///   (4) Rigid motion, scaling and reversal move the result along, up to that precision.
/// Points whose errors along the curve exceed their distances stand in a wrong order, which no move
/// across the curve mends: thin them out.
/// If the result is not fairer than the input, the input is returned.
/// \param tolerances_mm one for each point; at least 0 and finite.
/// \throws std::invalid_argument as fairnessOf() does, for a wrong number of tolerances and for an
/// invalid one (with its index). Throws Cancelled, see Progress; it is called before each step.
/// Source: docs/theory/planar.md P10.3.
FairedPoints fairPoints(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                        const PointFairingOptions& options = {}, const Progress& progress = {});

struct CurvatureFilterOptions {
  bool closed = false;
  /// Above 0 and at most 1/4; 1/4 extinguishes the shortest waves in one pass.
  double strength = 0.25;
  int max_passes = 100;
};

/// A low-pass filter of the curvature. A pass moves each point between the ends to where the
/// curvature of its segment becomes a mean with those of its neighbours; passes forward and
/// backward alternate. The filter ends when no point moves by more than 1/1000 of the tolerance,
/// and before the energy grows. It is the classical method; it minimises nothing, and fairPoints()
/// finds fairer points.
///   (5) No point moves by more than the tolerance.
///   (6) Points of a circle with equal spacing stay.
///   (7) A pass multiplies small zigzags on equally spaced points of a line by 1 - 4 strength.
/// \throws std::invalid_argument as fairnessOf() does, for a tolerance that is negative or not
/// finite, and for an invalid strength. Throws std::domain_error as tangentsAt() does, and
/// Cancelled, see Progress; it is called before each pair of passes.
/// Source: docs/theory/planar.md P10.4.
FairedPoints filterCurvature(const PlanarPoints& points, double tolerance_mm,
                             const CurvatureFilterOptions& options = {},
                             const Progress& progress = {});

/// One forward pass of filterCurvature() with given tangents. Of n points of an open sequence the
/// points 1 to n - 3 move. A point stays if its new angle would be a right angle or more.
/// \param original where tolerances are counted from.
PlanarPoints curvatureFilterPass(const PlanarPoints& points, const PlanarPoints& original,
                                 const std::vector<double>& directions_rad, double strength,
                                 double tolerance_mm, bool closed = false);

}  // namespace seamwright
