// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fair/fair_curve.hpp>

/// Curves whose curvature varies least: the energy of variationOf() does not depend on the
/// parametrisation, so circles and lines are fair whatever their poles are.
namespace seamwright {

struct PolishedCurve {
  BSplineCurve curve;
  double moved_mm = 0;  ///< upper bound of the distance of points of the same parameter
  CurveFairness before, after;
  /// CurvatureVariation::energy_per_mm3.
  double variation_before_per_mm3 = 0, variation_after_per_mm3 = 0;
  double weight_per_mm5 = 0;  ///< of the squared distance against the variation
  int steps = 0;              ///< of Gauss-Newton
};

/// The curve D with the knots of the curve C for which the variation of the curvature plus weight
/// times the integral of |D - C|^2 is least, with the smallest weight that moves no point by more
/// than the tolerance. The variation is that of variationOf(), with its error; its steps have the
/// nodes of Gauss' quadrature on the same pieces, and each is shortened until the sum falls. The
/// variation is not convex: the result is the local minimum that Gauss-Newton steps reach from C as
/// the weight falls. Identities (each has a test of its number):
///   (1) No point moves by more than moved_mm <= tolerance_mm; the bound is the one of the Bézier
///       poles of D - C.
///   (2) The variation does not grow: a curve whose variation is not less by more than the error
///       of both figures is returned as it is. A tolerance of 0 returns the curve bitwise.
///   (3) Held ends stay bitwise, so D and C have equal points, tangents and curvatures there. A
///       curve in the plane z = 0 stays there.
///   (4) Rigid motion and scaling of poles and tolerance move the result along, up to where the
///       steps end.
///   (5) The result for a curve near an arc, held at its tangents, has at most the variation of the
///       arc as a spline with these knots.
/// The cost of a step is O(poles).
/// \throws std::invalid_argument as fairCurve() does, for a degree below 3, and for an inner knot
/// of a multiplicity above degree - 2 (with the knot), where the curvature may jump. Throws
/// std::domain_error if the curve may stop, so that the variation is not finite.
/// Source: docs/theory/planar.md P13.4, P13.6, P11.3.
PolishedCurve polishCurve(const BSplineCurve& curve, double tolerance_mm,
                          const CurveFairingOptions& options = {});

}  // namespace seamwright
