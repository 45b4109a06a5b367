// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// A segment of a conic: the rational quadratic Bézier curve with the weights 1, weight, 1. Below 1
/// it is an ellipse, at 1 a parabola, above 1 a hyperbola. It turns by less than pi. If the corner
/// lies on the chord, it is a line.
struct PlanarConic {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< where the tangents at both ends meet
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  double weight = 1;

  /// Turn of the tangent, above 0 to the left, within (-pi, pi).
  double turn_rad() const;
  double startCurvature_per_mm() const;
  double endCurvature_per_mm() const;
  Eigen::Vector2d point(double t) const;
  /// Of the tangent, in [-pi, pi].
  double directionAt_rad(double t) const;
  /// With the sign of the turn. Source: docs/theory/planar.md P7.3, P8.2.
  double curvatureAt_per_mm(double t) const;
  /// Enclosed by arcLength(BezierCurve) to 1e-10 of it, unless rounding of weights that are far
  /// from 1 hides more.
  ///   (7) It is that of circles and parabolas in closed form; reversal keeps it, and the halves
  ///       add up to it.
  /// \throws std::invalid_argument for numbers that are not finite and a weight that is not
  /// positive. Source: docs/theory/curves.md C1.5.
  double length_mm() const;
  bool operator==(const PlanarConic& other) const = default;
};

/// The same points in the other direction.
PlanarConic reversed(const PlanarConic& conic);

/// The segment divided at t = 1/2. Source: docs/theory/planar.md P7.2.
std::array<PlanarConic, 2> halves(const PlanarConic& conic);

/// In the plane z = 0.
BezierCurve bezierCurve(const PlanarConic& conic);

/// An arc as a conic, exactly. \throws std::domain_error if it turns by pi or more.
PlanarConic conicOf(const PlanarArc& arc);

/// What two conics between two points have to meet. Both end tangents pass through the apex. The
/// tangent at the joint cuts start-apex and end-apex in these shares of their lengths.
struct TwoConicsEnds {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d apex = Eigen::Vector2d::Zero();
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  double start_curvature_per_mm = 0;  ///< with the sign of the turn from start to end
  double end_curvature_per_mm = 0;
  double start_share = 0.5;  ///< in (0, 1)
  double end_share = 0.5;    ///< in (0, 1)
};

/// The only two conics that join G2 and have the given curvatures at the ends. Identities (each has
/// a test of its number):
///   (1) The pieces share point, tangent and curvature at the joint, and have those given at the
///       ends.
///   (2) Mirrored, reversed, moved and scaled ends give the mirrored, reversed, moved and scaled
///       conics.
/// \throws std::invalid_argument if a number is not finite, if the three points lie on a line, if a
/// share is not in (0, 1), and if a curvature is 0 or has not the sign of the turn.
/// Source: docs/theory/planar.md P7.1.
std::array<PlanarConic, 2> twoConics(const TwoConicsEnds& ends);

struct G2ConicOptions {
  bool closed = false;
  /// Curvature at the start of an open chain; that of the first segment if there is no value.
  std::optional<double> start_curvature_per_mm = {};
  /// Largest gap and kink between segments.
  double gap_mm = 1e-9;
  double angle_rad = 1e-9;
};

/// A chain of conics and the joints at which it is not G2.
struct G2Conics {
  std::vector<PlanarConic> conics;
  /// Joints that stay G1, as the turn changes its sign or a segment is a line. Joint i is the start
  /// of conics[i]; only a closed chain has joint 0.
  std::vector<int> g1_joints;
  int divisions = 0;  ///< each adds one segment
  double least_weight = 1, largest_weight = 1;
  /// Largest distance of the new corners from the given ones, of segments that were not divided.
  double largest_move_mm = 0;
};

/// A G1 chain of conics made G2: tangents at the joints are rotated, and weights adapted. The
/// joints stay where they are. Identities (each has a test of its number):
///   (3) At all joints except those listed, segments share point, tangent and curvature.
///   (4) The points between segments, the tangents at the ends and the curvature at the end of an
///       open chain are kept; the one at the start has the value given.
///   (5) A chain that is G2 is returned as it is, up to rounding.
/// A segment is divided where two neighbours turn by pi or more together, or if it is the only one
/// and a start curvature is given. On long chains weights may be far from 1.
/// \throws std::invalid_argument for an empty chain, numbers that are not finite, weights that are
/// not positive, a corner equal to an end, a gap or kink (with the joint), and a start curvature of
/// the wrong sign or for a closed chain.
/// \throws std::domain_error if 1000 divisions do not bring neighbours below pi (with the joint).
/// Source: docs/theory/planar.md P7.2.
G2Conics g2Conics(const std::vector<PlanarConic>& chain, const G2ConicOptions& options = {});

/// Arcs as conics. An arc that turns by 2 pi / 3 or more is divided into equal parts.
std::vector<PlanarConic> conicsOf(const std::vector<PlanarArc>& arcs);

/// Extrema of the size of the curvature inside of a segment.
enum class ConicCurvature { Monotone, OneMaximum, OneMinimum, MaximumAndMinimum };

/// Up to rounding; planarCurvatureProfile() finds the parameters with certainty.
///   (6) The number is that of the sign changes found by planarCurvatureProfile().
/// Source: docs/theory/planar.md P7.3.
ConicCurvature curvatureKind(const PlanarConic& conic);

/// A chain as rational quadratic segments in the plane z = 0, with the lengths of the control
/// polygons as knots. \throws as g2Conics() for an empty chain.
BezierSpline bezierSpline(const std::vector<PlanarConic>& chain, bool closed);

}  // namespace seamwright
