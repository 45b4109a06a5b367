// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include <seamwright/core/enclosure/curve.hpp>

namespace seamwright {

/// How much of a surface is wanted along a path; each level holds those before it.
enum class Detail { Position, TangentPlane, Curvature };

/// What a surface shows along a path. A field that is not bounded there (no tangent plane at a pole
/// or a cusp) has an infinite radius.
struct SurfaceFields {
  VectorModel point;
  VectorModel normal;     ///< unit, in the direction of X_u x X_v
  SymmetricModel tensor;  ///< curvature tensor to that normal, see curvatureTensor()
};

/// The fields of a parametrised surface from its jet.
/// Source: docs/theory/enclosures.md E3.1; docs/theory/surfaces.md S1.4.
SurfaceFields fieldsOf(const JetModel& jet, Detail detail);
/// The same next to a boundary that is one point: the normal is known up to it where X_tau and Q_s,
/// the derivative of the quotient along the boundary, are independent; the tensor off it.
/// Source: docs/theory/enclosures.md E5.1.
SurfaceFields collapsedFieldsOf(const CollapsedJetModel& jet, Detail detail);

/// A surface for evaluation along pieces of paths in its parameter plane.
class SurfaceEvaluator {
 public:
  virtual ~SurfaceEvaluator() = default;
  /// Knots of parameter 0 (u) or 1 (v) strictly inside the range: lines across which derivatives
  /// may jump. Increasing.
  virtual std::vector<double> knotsInside(int /*direction*/, const Interval& /*range*/) const {
    return {};
  }
  /// Largest absolute knot of parameter 0 or 1, 0 if there are none: the size by which places in it
  /// can be told apart.
  virtual double parameterSize(int /*direction*/) const { return 0; }
  /// \param hint_u, hint_v a point of the smooth piece that is meant.
  virtual SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u,
                               double hint_v, Detail detail) const = 0;
};

/// Origin and axes (columns, orthonormal, of either hand) of an analytic surface.
struct Frame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// x -> scale orthogonal x + translation.
struct Placement {
  double scale = 1;  ///< not zero
  Eigen::Matrix3d orthogonal = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// u x + v y.
std::unique_ptr<SurfaceEvaluator> planeEvaluator(const Frame& frame);
/// radius e(u) + v z, with e(u) = cos u x + sin u y.
std::unique_ptr<SurfaceEvaluator> cylinderEvaluator(const Frame& frame, double radius);
/// (radius + v sin angle) e(u) + v cos angle z.
std::unique_ptr<SurfaceEvaluator> coneEvaluator(const Frame& frame, double radius,
                                                double half_angle_rad);
/// radius (cos v e(u) + sin v z). The tangent plane at the poles is taken from the sphere, not from
/// the parametrisation.
std::unique_ptr<SurfaceEvaluator> sphereEvaluator(const Frame& frame, double radius);
/// (major + minor cos v) e(u) + minor sin v z.
std::unique_ptr<SurfaceEvaluator> torusEvaluator(const Frame& frame, double major, double minor);
std::unique_ptr<SurfaceEvaluator> splineEvaluator(std::shared_ptr<const SplineEvaluator> spline);
/// The curve of parameter v turned about the z axis of the frame by u.
std::unique_ptr<SurfaceEvaluator> revolutionEvaluator(const Frame& frame, CurveEvaluator curve);
/// The curve of parameter u plus v times the direction.
std::unique_ptr<SurfaceEvaluator> extrusionEvaluator(CurveEvaluator curve,
                                                     const Eigen::Vector3d& direction);
/// Points of the basis moved by the distance along its normal.
std::unique_ptr<SurfaceEvaluator> offsetEvaluator(std::unique_ptr<SurfaceEvaluator> basis,
                                                  double distance);
std::unique_ptr<SurfaceEvaluator> placedEvaluator(std::unique_ptr<SurfaceEvaluator> basis,
                                                  const Placement& placement);

}  // namespace seamwright
