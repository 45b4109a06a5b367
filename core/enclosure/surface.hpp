// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include <seamwright/core/enclosure/curve.hpp>

namespace seamwright {

/// What is wanted of a surface along a path; each level includes the levels before it.
/// The value is the highest order of derivatives that it needs.
enum class Detail { Position, TangentPlane, Curvature, CurvatureChange };

/// A cubic form of the vectors d of a tangent plane: with x = first.d and y = second.d,
///     xxx x^3 + 3 xxy x^2 y + 3 xyy x y^2 + yyy y^3.
/// first and second are tangent vectors.
struct CubicForm {
  VectorModel first, second;
  ChebyshevModel xxx, xxy, xyy, yyy;

  ChebyshevModel operator()(const VectorModel& d) const;
};

/// The fields of a surface along a path. A field that is not bounded there has an infinite radius,
/// for instance the normal at a pole or a cusp.
struct SurfaceFields {
  VectorModel point;
  VectorModel normal;     ///< unit, in the direction of X_u x X_v
  SymmetricModel tensor;  ///< curvature tensor for that normal, see curvatureTensor()
  /// Whether the curvature is bounded where the normal is known; also without the tensor.
  bool bounds_curvature = false;
  VectorModel u = {}, v = {};  ///< X_u and X_v, only with the change of curvature
  CubicForm change = {};       ///< curvatureChange() for that normal, as a form of the direction
};

/// The fields of a parametrised surface from its jet.
/// Source: docs/theory/enclosures.md E3.1, E3.6; docs/theory/surfaces.md S1.4, S1.6.
SurfaceFields fieldsOf(const JetModel& jet, Detail detail);
/// The fields next to a boundary that is one point. The normal is known up to the boundary where
/// X_tau and Q_s are independent; Q_s is the derivative of the quotient along the boundary. The
/// tensor and its change are known away from the boundary.
/// Source: docs/theory/enclosures.md E5.1, E3.6.
SurfaceFields collapsedFieldsOf(const CollapsedJetModel& jet, Detail detail);

/// A surface that can be evaluated along pieces of paths in its parameter plane.
class SurfaceEvaluator {
 public:
  virtual ~SurfaceEvaluator() = default;
  /// Knots of parameter 0 (u) or 1 (v) strictly inside the range, in increasing order. Derivatives
  /// may jump across the lines at these knots.
  virtual std::vector<double> knotsInside(int /*direction*/, const Interval& /*range*/) const {
    return {};
  }
  /// Largest absolute knot of parameter 0 or 1, 0 if there are none. It sets the size of the
  /// rounding of that parameter.
  virtual double parameterSize(int /*direction*/) const { return 0; }
  /// Whether tangent plane and curvature are known on every short piece of a path: the surface has
  /// neither poles nor an apex. False says nothing.
  virtual bool isRegular() const { return false; }
  /// The fields along (u, v).
  /// \param hint_u, hint_v a point inside the smooth piece to evaluate.
  virtual SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u,
                               double hint_v, Detail detail) const = 0;
};

/// Origin and axes of an analytic surface. The axes are orthonormal columns and may be left-handed.
struct Frame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// The map x -> scale orthogonal x + translation.
struct Placement {
  double scale = 1;  ///< not zero
  Eigen::Matrix3d orthogonal = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// The plane u x + v y.
std::unique_ptr<SurfaceEvaluator> planeEvaluator(const Frame& frame);
/// The cylinder radius e(u) + v z, with e(u) = cos u x + sin u y.
std::unique_ptr<SurfaceEvaluator> cylinderEvaluator(const Frame& frame, double radius);
/// The cone (radius + v sin angle) e(u) + v cos angle z.
std::unique_ptr<SurfaceEvaluator> coneEvaluator(const Frame& frame, double radius,
                                                double half_angle_rad);
/// The sphere radius (cos v e(u) + sin v z). At the poles the tangent plane is that of the sphere,
/// although the parametrisation has none.
std::unique_ptr<SurfaceEvaluator> sphereEvaluator(const Frame& frame, double radius);
/// The torus (major + minor cos v) e(u) + minor sin v z.
std::unique_ptr<SurfaceEvaluator> torusEvaluator(const Frame& frame, double major, double minor);
std::unique_ptr<SurfaceEvaluator> splineEvaluator(std::shared_ptr<const SplineEvaluator> spline);
/// The curve of parameter v, turned about the z axis of the frame by the angle u.
std::unique_ptr<SurfaceEvaluator> revolutionEvaluator(const Frame& frame, CurveEvaluator curve);
/// The curve of parameter u plus v times the direction.
std::unique_ptr<SurfaceEvaluator> extrusionEvaluator(CurveEvaluator curve,
                                                     const Eigen::Vector3d& direction);
/// The points of the basis surface, moved by the distance along its normal.
std::unique_ptr<SurfaceEvaluator> offsetEvaluator(std::unique_ptr<SurfaceEvaluator> basis,
                                                  double distance);
std::unique_ptr<SurfaceEvaluator> placedEvaluator(std::unique_ptr<SurfaceEvaluator> basis,
                                                  const Placement& placement);

}  // namespace seamwright
