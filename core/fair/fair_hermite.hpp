// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fair/curvature_variation.hpp>
#include <seamwright/core/fair/matrix_curve.hpp>

/// Curves through points with tangents, and points with tangents that are made fair, by matrix
/// weights.
namespace seamwright {

/// Points with tangents of any length other than 0, one per row.
struct HermitePoints {
  Poles points, tangents;
};

struct MatrixFitOptions {
  int degree = 3;
  /// Of all poles. 0 ignores the tangents; with 1 points of circles are met best.
  double stiffness = 1;
};

/// A matrix-weighted curve through points, whose poles have the tangents of the points.
struct MatrixFit {
  MatrixCurve curve;
  Eigen::VectorXd parameters;     ///< of the points: lengths of the polygon
  double missed_mm = 0;           ///< largest distance of a point from its point of the curve
  double missed_tangent_rad = 0;  ///< largest angle between a tangent and that of the curve
};

/// Identities (each has a test of its number):
///   (1) The curve meets the points up to rounding. The cost is O(points).
///   (2) Rigid motion and scaling move the curve along.
/// Tangents are met approximately: missed_tangent_rad states how well.
/// \throws std::invalid_argument for fewer points than degree + 1, tangents that do not match or
/// are 0, numbers that are not finite, equal neighbours (with the index), and a stiffness that
/// requireValid(MatrixCurve) refuses. Source: docs/theory/planar.md P13.3; [Yang2016].
MatrixFit fitHermite(const HermitePoints& data, const MatrixFitOptions& options = {});

struct HermiteFairingOptions {
  int most_passes = 10;
  /// Whether the tangents are replaced by those of the curve in each pass.
  bool fair_tangents = true;
  /// Of fairing and of the curve through the points.
  MatrixFitOptions fit = {};
};

struct FairedHermite {
  HermitePoints data;
  MatrixFit fit;                     ///< through the faired points
  double moved_mm = 0;               ///< the largest distance of a point from where it was
  CurvatureVariation before, after;  ///< of the curves through the points
  int passes = 0;

  /// By how much the numbers of extrema (with those at joints) and of inflections grew.
  int addedExtrema() const;
  int addedInflections() const;
};

/// Moves each point between the ends to where the sum of the squared distances from it and its
/// neighbours and from their tangent lines is least, with the weights of a uniform cubic B-spline
/// at a knot, again and again. A pass that would raise the energy ends the fairing.
///   (3) No point moves by more than the tolerance; the ends stay. Tolerance 0 returns the data
///       bitwise.
///   (4) The energy does not grow: a pass has to lower it by more than the error of variationOf().
///   (5) Points of a circle at equal angles h with its tangents stay for the stiffness 1 / cos h;
///       with stiffness 0 a pass takes the mean with the weights 1/6, 4/6 and 1/6.
/// \throws std::invalid_argument as fitHermite() does, for a tolerance that is negative or not
/// finite, and a negative number of passes. Source: docs/theory/planar.md P13.5; [Yang2016].
FairedHermite fairHermite(const HermitePoints& data, double tolerance_mm,
                          const HermiteFairingOptions& options = {});

/// One pass of fairHermite() without tolerance.
/// \throws std::invalid_argument for tangents that do not match or are 0, numbers that are not
/// finite, equal neighbours (with the index), and a stiffness that requireValid(MatrixCurve)
/// refuses. Source: docs/theory/planar.md P13.5.
HermitePoints matrixPass(const HermitePoints& data, double stiffness, bool fair_tangents);

}  // namespace seamwright
