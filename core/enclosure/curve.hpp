// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <variant>
#include <vector>

#include <seamwright/core/enclosure/spline.hpp>

namespace seamwright {

/// Point and derivatives of a curve along a piece of it, as models.
struct CurveJetModel {
  VectorModel p, d1, d2;
  VectorModel d3 = {};
};

/// origin + t direction.
struct LineEvaluator {
  Eigen::Vector3d origin, direction;
};

/// center + cos t x + sin t y; a circle if x and y are perpendicular and of one length.
struct EllipseEvaluator {
  Eigen::Vector3d center, x, y;
};

/// center + cosh t x + sinh t y.
struct HyperbolaEvaluator {
  Eigen::Vector3d center, x, y;
};

/// vertex + t^2 axis + t tangent.
struct ParabolaEvaluator {
  Eigen::Vector3d vertex, axis, tangent;
};

/// A curve that can be evaluated over pieces of its parameter range. For a curve in the parameter
/// plane of a surface the third coordinate is zero.
class CurveEvaluator {
 public:
  // NOLINTBEGIN(google-explicit-constructor): each of these is a curve
  CurveEvaluator(LineEvaluator line) : form_(line) {}
  CurveEvaluator(EllipseEvaluator ellipse) : form_(ellipse) {}
  CurveEvaluator(HyperbolaEvaluator hyperbola) : form_(hyperbola) {}
  CurveEvaluator(ParabolaEvaluator parabola) : form_(parabola) {}
  /// \pre the spline is of degree 0 in v.
  CurveEvaluator(std::shared_ptr<const SplineEvaluator> spline) : form_(std::move(spline)) {}
  // NOLINTEND(google-explicit-constructor)

  /// Parameters strictly inside the range at which the curve may not be smooth, increasing.
  std::vector<double> knotsInside(const Interval& range) const;
  /// Largest absolute knot, 0 if there are none.
  double parameterSize() const;
  /// Point and derivatives along t.
  /// \param hint a parameter inside the smooth piece to evaluate.
  /// \param order 0 to 3: highest derivative wanted.
  CurveJetModel jet(const ChebyshevModel& t, double hint, int order) const;

 private:
  std::variant<LineEvaluator, EllipseEvaluator, HyperbolaEvaluator, ParabolaEvaluator,
               std::shared_ptr<const SplineEvaluator>>
      form_;
};

}  // namespace seamwright
