// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/differential/jet.hpp>

namespace seamwright {

/// What a point of a space curve is.
enum class CurvePoint {
  Regular,     ///< speed and curvature are not zero (the curvature only if it is known)
  Inflection,  ///< regular, without curvature: a straight piece, or a point of it
  Cusp,  ///< without speed; the tangent is that of the first derivative that is not zero, leaving
  Point  ///< all derivatives given are zero to rounding: no tangent
};

/// Frenet frame, curvature, torsion of a curve at a point, each with a bound of its error: what
/// rounding, and the noise of the derivatives, may have changed. The bounds are proved up to
/// rounding in themselves.
///
/// Where the curvature is zero to its bound, it is 0 and normal, binormal, torsion and change of
/// curvature are nothing; at a cusp curvature and what follows from it are nothing. Torsion and
/// change of curvature are nothing, too, where they or their bounds are beyond the range of a
/// double. So a regular point has a curvature that is certainly not zero; its torsion may still be
/// smaller than the bound of it.
struct FrenetFrame {
  CurvePoint kind = CurvePoint::Point;
  double speed = 0;  ///< |X'|
  double speed_error = 0;
  std::optional<Eigen::Vector3d> tangent;  ///< T
  std::optional<double> tangent_error_rad;
  std::optional<Eigen::Vector3d>
      normal;  ///< N, towards the centre of curvature; turned by no more than T and B are
  std::optional<Eigen::Vector3d> binormal;  ///< B = T x N
  std::optional<double> binormal_error_rad;
  std::optional<double> curvature_per_mm;  ///< kappa >= 0
  std::optional<double> curvature_error_per_mm;
  std::optional<double> torsion_per_mm;  ///< tau
  std::optional<double> torsion_error_per_mm;
  std::optional<double> curvature_change_per_mm2;  ///< d kappa / ds
  std::optional<double> curvature_change_error_per_mm2;
};

/// Identities (each has a test of its number):
///   (1) Frenet-Serret: T_s = kappa N, N_s = -kappa T + tau B, B_s = -tau N.
///   (2) A circle of radius r: 1 / r, torsion 0; a helix of radius r, pitch 2 pi b: r / (r^2 +
///       b^2), b / (r^2 + b^2).
///   (3) Independent of the parameter; run backwards T and B change sign (N does not), kappa and
///       tau stay, d kappa / ds changes sign.
///   (4) A rigid motion moves the frame; a scale s divides kappa and tau by s; a mirror changes the
///       sign of tau.
/// \param derivatives orders 0..n, n >= 1; torsion and change of curvature need n >= 3.
/// \param speed_noise, acceleration_noise what rounding may have added to the first, and to each of
/// the higher derivatives.
/// \throws std::invalid_argument for fewer than two rows, a number that is not finite, a negative
/// noise.
/// Source: docs/theory/curves.md C1.1, C1.3; [doCarmo1976].
FrenetFrame frenetFrame(const CurveDerivatives& derivatives, double speed_noise = 0,
                        double acceleration_noise = 0);
/// Of a curve, whose homogeneous poles count as exact (where weights and poles were given apart,
/// their products have been rounded): backward stable, that is exact for poles moved by a few units
/// in the last place of their distances, whatever the weights and however near t is to an end.
/// Orders above 3 are looked at where the lower ones are zero.
/// \throws std::invalid_argument for a parameter that is not finite, or where the curve is not.
FrenetFrame frenetFrame(const BezierCurve& curve, double t);

/// Places of a Bézier curve where the frame is lost, as intervals [first, last] of the parameter
/// that are certain to hold all of them.
struct CurveDegeneracies {
  struct Place {
    CurvePoint kind;
    double first, last;
  };
  std::vector<Place> places;  ///< in order of the parameter
  bool straight =
      false;  ///< the whole curve lies on a line (or is a point), to rounding of its poles
  /// A positive lower bound of |X'| over [0, 1]; 0 if there are cusps or none is proved.
  double speed_lower = 0;
};

/// All cusps (X' = 0) and inflections (X' x X'' = 0, X' != 0) of a curve: by subdivision of the
/// Bernstein forms of X' and X' x X'' (rational curves: of their numerators) until an interval is
/// free of zeros, or shorter than
/// \p resolution, or within rounding of zero throughout. It is free if all coefficients have
/// positive components along their mean: that sees speeds of 1e-15 of the largest, where squares
/// would end at 1e-8.
///
/// What is not reported is proved free; a reported place is no proof that there is something.
/// Places that touch are one, a cusp if a cusp may be in it. A cusp's place is wider than the
/// resolution, as a rule by 1e-7: X' x X'' has a double zero there, so rounding hides an inflection
/// that is near. On a line the places of cusps are short, and all the rest is a place without
/// curvature.
/// \throws std::invalid_argument for a resolution outside 1e-12..1.
/// Source: docs/theory/curves.md C1.4.
CurveDegeneracies findDegeneracies(const BezierCurve& curve, double resolution = 1e-9);

/// A frame that does not turn about the tangent: rotation minimising, by double reflection.
struct MovingFrame {
  double t = 0;
  Eigen::Vector3d point, tangent, normal, binormal;
};

/// Frames at the parameters given, increasing; the first normal is \p normal made orthogonal to the
/// tangent (nothing: any). Goes on through inflections and straight pieces; error of the twist
/// O(step^4). Steps in which the tangent turns by more than a right angle are halved.
/// \throws std::invalid_argument for parameters that do not increase; for a normal along the
/// tangent or not finite; at a cusp (as findDegeneracies() sees it), also between the parameters,
/// with the parameter.
/// Source: docs/theory/curves.md C1.6; [WangEtAl2008].
std::vector<MovingFrame> rotationMinimizingFrames(
    const BezierCurve& curve, const std::vector<double>& parameters,
    std::optional<Eigen::Vector3d> normal = std::nullopt);

}  // namespace seamwright
