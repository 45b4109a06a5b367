// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/differential/jet.hpp>

namespace seamwright {

/// The kind of a point of a space curve.
enum class CurvePoint {
  Regular,     ///< speed and curvature are not zero (the curvature only if it is known)
  Inflection,  ///< speed without curvature: a point, or part of a straight piece
  Cusp,        ///< without speed; the tangent leaves it along the first derivative that is not zero
  Point        ///< all given derivatives are zero within rounding: no tangent
};

/// Frenet frame, curvature and torsion at a point, with proven bounds of rounding and noise.
///
/// Where the curvature is zero within its bound it is 0, and normal, binormal, torsion and change
/// of curvature are nothing; at a cusp the curvature too. Figures beyond the range of a double are
/// nothing.
struct FrenetFrame {
  CurvePoint kind = CurvePoint::Point;
  double speed = 0;  ///< |X'|
  double speed_error = 0;
  std::optional<Eigen::Vector3d> tangent;  ///< T
  std::optional<double> tangent_error_rad;
  std::optional<Eigen::Vector3d> normal;    ///< N, towards the centre of curvature; its error is
                                            ///< at most that of T plus that of B
  std::optional<Eigen::Vector3d> binormal;  ///< B = T x N
  std::optional<double> binormal_error_rad;
  std::optional<double> curvature_per_mm;  ///< kappa >= 0
  std::optional<double> curvature_error_per_mm;
  std::optional<double> torsion_per_mm;  ///< tau
  std::optional<double> torsion_error_per_mm;
  std::optional<double> curvature_change_per_mm2;  ///< d kappa / ds
  std::optional<double> curvature_change_error_per_mm2;
};

///     const FrenetFrame frame = frenetFrame(curve, 0.5);
///     if (frame.kind == CurvePoint::Regular) use(*frame.curvature_per_mm);
///
/// Identities (each has a test of its number):
///   (1) Frenet-Serret: T_s = kappa N, N_s = -kappa T + tau B, B_s = -tau N.
///   (2) A circle of radius r: 1 / r, torsion 0; a helix of radius r, pitch 2 pi b: r / (r^2 +
///       b^2), b / (r^2 + b^2).
///   (3) Independent of the parameter. On the reversed curve T, B and d kappa / ds change sign; N,
///       kappa and tau stay.
///   (4) A rigid motion moves the frame; a scale s divides kappa and tau by s; a mirror changes the
///       sign of tau.
/// \param derivatives orders 0..n, n >= 1; torsion and change of curvature need n >= 3.
/// \param speed_noise, acceleration_noise bounds of the rounding in the first derivative, and in
/// each of the higher derivatives.
/// \throws std::invalid_argument for fewer than two rows, a number that is not finite, a negative
/// noise.
/// Source: docs/theory/curves.md C1.1, C1.3; [doCarmo1976].
FrenetFrame frenetFrame(const CurveDerivatives& derivatives, double speed_noise = 0,
                        double acceleration_noise = 0);
/// The frame of a curve at the parameter t, of homogeneous poles that count as exact. Backward
/// stable: the result is exact for poles moved by a few units in the last place of their distances.
/// \throws std::invalid_argument if the parameter or the curve there is not finite.
FrenetFrame frenetFrame(const BezierCurve& curve, double t);

/// Intervals [first, last] that certainly contain all parameters at which the frame is lost.
struct CurveDegeneracies {
  struct Interval {
    CurvePoint kind;
    double first, last;
  };
  std::vector<Interval> intervals;  ///< in increasing order of the parameter
  bool straight = false;  ///< the curve lies on a line, or is a point, within rounding of its poles
  /// A positive lower bound of |X'| over [0, 1]; 0 if there are cusps or no bound is proved.
  double speed_lower = 0;
};

/// Finds all cusps (X' = 0) and inflections (X' x X'' = 0, X' != 0) of a curve, in intervals that
/// are shorter than \p resolution or zero within rounding throughout.
///
/// What is not reported is proved free of cusps and inflections; what is reported need not be one.
/// Intervals that touch are merged, into a cusp if one may be among them. A curve that is one point
/// has one interval of kind Point.
/// \throws std::invalid_argument for a resolution outside 1e-12..1.
/// Source: docs/theory/curves.md C1.4.
CurveDegeneracies findDegeneracies(const BezierCurve& curve, double resolution = 1e-9);

/// A frame that does not turn about the tangent (rotation minimising), by double reflection.
struct MovingFrame {
  double t = 0;
  Eigen::Vector3d point, tangent, normal, binormal;
};

/// Frames at the given parameters, which increase, also through inflections and straight pieces.
/// The first normal is \p normal made orthogonal to the tangent, or any. The error of the twist is
/// O(step^4); steps in which the tangent turns by more than a right angle are halved.
/// \throws std::invalid_argument for parameters that do not increase; for a normal that is along
/// the tangent or not finite; and, with the parameter, for a cusp (as findDegeneracies() finds it)
/// at or between the parameters.
/// Source: docs/theory/curves.md C1.6; [WangEtAl2008].
std::vector<MovingFrame> rotationMinimizingFrames(
    const BezierCurve& curve, const std::vector<double>& parameters,
    std::optional<Eigen::Vector3d> normal = std::nullopt);

}  // namespace seamwright
