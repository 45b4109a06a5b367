// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// A cubic alpha-curve: X(t) = sum_i P_i b_i(t; a) on [0, 1], with the basis of AlphaSurface.
struct AlphaCurve {
  using Polygon = Eigen::Matrix<double, 4, 3, Eigen::RowMajor>;

  Polygon poles = Polygon::Zero();
  double a = 1;  ///< shape, 0..1; with 1 the curve is closest to the polygon
};

/// b_0..b_3 at t.
///
/// Identities (each has a test of its number):
///   (1) b_i >= 0 and they sum to 1 on [0, 1]; b_i(t) = b_{3-i}(1 - t).
///   (2) The quintic Bézier curve of alphaCurveBezier() has the same points.
///   (3) No plane meets the curve more often than the polygon (a in 0..1).
Eigen::Vector4d alphaBasis(double a, double t);

/// The same curve as a quintic Bézier curve, exactly. Use it for derivatives, splitting and
/// conversion.
/// \throws std::invalid_argument for a pole that is not finite, or a shape outside 0..1.
/// Source: docs/theory/curves.md C8.1, C8.2; [TuYanXu2022].
BezierCurve alphaCurveBezier(const AlphaCurve& curve);

/// The rule by which the next alpha-curve continues a given one.
struct AlphaCurveJoin {
  int order = 1;  ///< 1, 2 or 3
  /// 1 and 0 for C^1 and C^2. With order 3 beta2 is determined and not read.
  double beta1 = 1, beta2 = 0;
  double length = 1;       ///< length of the given curve in the common parameter
  double next_length = 1;  ///< length of the next curve
  double next_a = 1;
};

/// The poles Q_0, Q_1 and, for order 2 or 3, Q_2 of the next curve; its other poles are free.
///
///   (4) The joint is G^order with beta1, beta2 (for order 3 with beta2, beta3 of C8.5).
///   (5) A C2 join has continuous curvature and torsion (FC^3), because alpha-curves have zero
///       torsion at their ends. It is G3 only if X'' is parallel to X'. A G2 join is G3 only for
///       beta2 = -2 beta1 (beta1 / h + 1 / k).
/// \throws std::invalid_argument for an order, length, beta1 or shape out of range (shapes of a
/// join are 1e-6 to 1), for given poles P_2 = P_3, and for resulting poles beyond the range of a
/// double (index and value).
/// Source: docs/theory/curves.md C8.3 to C8.5; [TuYanXu2022].
Poles alphaJoinPoles(const AlphaCurve& given, const AlphaCurveJoin& join);

/// The energies: the integral of |X^(k)|^2 over [0, 1], k = 1, 2, 3.
enum class AlphaEnergy { Length = 1, Curvature = 2, CurvatureVariation = 3 };

struct AlphaOptimum {
  double a = 1;       ///< within the bounds
  double free_a = 1;  ///< the shape of least energy without bounds
  double energy = 0;  ///< the energy at a
  bool any = false;   ///< the energy is independent of a: P_0 = P_1 and P_2 = P_3
};

/// The shape of least energy for four poles. It is exact, because the energy is a quadratic
/// polynomial of a.
///   (6) The derivative of the energy vanishes at free_a, and a has the least energy of all shapes
///       within the bounds.
/// \throws std::invalid_argument for poles that are not finite or bounds outside 0 <= a_min <=
/// a_max <= 1.
/// Source: docs/theory/curves.md C8.7 (the printed sign differs); [TuYanXu2022].
AlphaOptimum energyOptimalAlpha(const AlphaCurve::Polygon& poles, AlphaEnergy energy,
                                double a_min = 0.05, double a_max = 1);

}  // namespace seamwright
