// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/fair/fair_hermite.hpp>
#include <seamwright/core/fair/matrix_point.hpp>
#include <seamwright/core/fair/spline_energy.hpp>
#include <seamwright/core/fair/variation_quadrature.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

MatrixPole matrixPole(const HermitePoints& data, Index i, double stiffness) {
  return {.point = data.points.row(i).transpose(),
          .tangent = data.tangents.row(i).transpose(),
          .stiffness = stiffness};
}

void requireHermite(const HermitePoints& data) {
  if (data.points.rows() != data.tangents.rows())
    refuse(fmt::format("{} tangents for {} points", data.tangents.rows(), data.points.rows()));
  for (Index i = 0; i < data.points.rows(); ++i) {
    const Eigen::RowVector3d point = data.points.row(i), tangent = data.tangents.row(i);
    if (!point.allFinite() || !tangent.allFinite() || tangent.isZero(0))
      refuse(fmt::format("point {} is ({}, {}, {}) with the tangent ({}, {}, {})", i, point.x(),
                         point.y(), point.z(), tangent.x(), tangent.y(), tangent.z()));
    if (i > 0 && point == data.points.row(i - 1))
      refuse(fmt::format("points {} and {} are equal", i - 1, i));
  }
}

Eigen::VectorXd polygonLengths(const Poles& points) {
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(points.rows());
  for (Index i = 1; i < points.rows(); ++i)
    lengths(i) = lengths(i - 1) + (points.row(i) - points.row(i - 1)).norm();
  return lengths;
}

/// Inner knots are means of neighbouring parameters. So every basis function is positive at its
/// parameter, and interpolation is possible.
std::vector<double> averagedKnots(int degree, const Eigen::VectorXd& parameters) {
  const Index last = parameters.size() - 1;
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, parameters(0));
  for (Index j = 1; j + degree <= last; ++j) knots.push_back(parameters.segment(j, degree).mean());
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, parameters(last));
  return knots;
}

/// Poles P_j for which the curve has the points at the parameters. With W_j = M_j P_j the equations
/// sum of N_j(t_i) W_j = (sum of N_j(t_i) M_j) D_i are those of a spline.
/// Source: docs/theory/planar.md P13.3.
void interpolate(MatrixCurve& curve, const Poles& points, const Eigen::VectorXd& parameters) {
  const Eigen::SparseMatrix<double> basis =
      basisAt(curve.degree, curve.knots, {parameters.begin(), parameters.end()});
  const Eigen::Vector3d origin = points.colwise().mean().transpose();
  const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = basis;
  Eigen::MatrixXd right(points.rows(), 3);
  for (Index i = 0; i < points.rows(); ++i) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(rows, i); entry; ++entry)
      matrix += entry.value() * curve.poles[entry.col()].matrix();
    right.row(i) = (matrix * (points.row(i).transpose() - origin)).transpose();
  }
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::NaturalOrdering<int>> factor(basis);
  if (factor.info() != Eigen::Success)
    throw std::domain_error(
        fmt::format("the equations of the curve through {} points are singular", points.rows()));
  const Eigen::MatrixXd vectors = factor.solve(right);
  for (Index j = 0; j < points.rows(); ++j) {
    MatrixPole& pole = curve.poles[j];
    pole.point = origin + pole.matrix().ldlt().solve(vectors.row(j).transpose());
  }
}

/// The point and the derivative at the knot of pole j of the uniform cubic curve whose poles are
/// the data. The basis functions have the values 1/6, 4/6, 1/6 and the derivatives -1/2, 0, 1/2
/// there. Source: docs/theory/planar.md P13.5.
struct LocalMinimum {
  Eigen::RowVector3d point, tangent;

  LocalMinimum(const HermitePoints& data, Index j, double stiffness) {
    const Eigen::Vector3d origin = data.points.row(j).transpose();
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero(), matrix_slope = matrix;
    Eigen::Vector3d vector = Eigen::Vector3d::Zero(), vector_slope = vector;
    for (int side = -1; side <= 1; ++side) {
      const MatrixPole pole = matrixPole(data, j + side, stiffness);
      const Eigen::Matrix3d m = pole.matrix();
      const Eigen::Vector3d v = m * (pole.point - origin);
      matrix += (side == 0 ? 4 : 1) * m / 6;
      vector += (side == 0 ? 4 : 1) * v / 6;
      matrix_slope += side * m / 2;
      vector_slope += side * v / 2;
    }
    const Eigen::LDLT<Eigen::Matrix3d> factor(matrix);
    const Eigen::Vector3d found = factor.solve(vector);
    point = (origin + found).transpose();
    tangent = factor.solve(vector_slope - matrix_slope * found).transpose();
  }
};

/// The point, or one on the way back that is certainly within the tolerance of the original.
Eigen::RowVector3d withinTolerance(Eigen::RowVector3d point, const Eigen::RowVector3d& original,
                                   double tolerance_mm) {
  const double distance_mm = (point - original).norm();
  if (distance_mm <= tolerance_mm) return point;
  point = original + tolerance_mm / distance_mm * (point - original);
  for (double back = 0x1p-50; (point - original).norm() > tolerance_mm && back < 1; back *= 2)
    point = original + (1 - back) * (point - original);
  return (point - original).norm() <= tolerance_mm ? point : original;
}

HermitePoints limited(HermitePoints data, const Poles& original, double tolerance_mm) {
  for (Index i = 0; i < original.rows(); ++i)
    data.points.row(i) = withinTolerance(data.points.row(i), original.row(i), tolerance_mm);
  return data;
}

int extremaOf(const CurvatureVariation& variation) {
  return variation.extrema + variation.extrema_at_joints;
}

}  // namespace

MatrixFit fitHermite(const HermitePoints& data, const MatrixFitOptions& options) {
  if (options.degree < 1 || data.points.rows() <= options.degree)
    refuse(fmt::format("{} points make no curve of degree {}", data.points.rows(), options.degree));
  requireHermite(data);
  MatrixFit result;
  result.parameters = polygonLengths(data.points);
  result.curve.degree = options.degree;
  result.curve.knots = averagedKnots(options.degree, result.parameters);
  for (Index i = 0; i < data.points.rows(); ++i)
    result.curve.poles.push_back(matrixPole(data, i, options.stiffness));
  requireValid(result.curve);
  interpolate(result.curve, data.points, result.parameters);
  const MatrixCurve& curve = result.curve;
  for (Index i = 0; i < data.points.rows(); ++i) {
    const CurveDerivatives at = pointAndTangentOfValid(curve, result.parameters(i));
    const Eigen::Vector3d direction = at.row(1), tangent = data.tangents.row(i);
    result.missed_mm = std::max(result.missed_mm, (at.row(0) - data.points.row(i)).norm());
    result.missed_tangent_rad =
        std::max(result.missed_tangent_rad,
                 std::atan2(direction.cross(tangent).norm(), direction.dot(tangent)));
  }
  return result;
}

HermitePoints matrixPass(const HermitePoints& data, double stiffness, bool fair_tangents) {
  requireHermite(data);
  if (!(stiffness >= 0 && stiffness <= max_stiffness))
    refuse(fmt::format("the stiffness is {}: it must be in [0, {}]", stiffness, max_stiffness));
  HermitePoints result = data;
  for (Index i = 1; i + 1 < data.points.rows(); ++i) {
    const LocalMinimum found(data, i, stiffness);
    result.points.row(i) = found.point;
    if (fair_tangents && found.tangent.norm() > 0)
      result.tangents.row(i) = found.tangent.normalized();
  }
  return result;
}

int FairedHermite::addedExtrema() const {
  return std::max(0, extremaOf(after) - extremaOf(before));
}

int FairedHermite::addedInflections() const {
  return std::max(0, after.inflections - before.inflections);
}

FairedHermite fairHermite(const HermitePoints& data, double tolerance_mm,
                          const HermiteFairingOptions& options) {
  if (!(tolerance_mm >= 0) || tolerance_mm == infinite)
    refuse(fmt::format("the tolerance is {} mm: it must be at least 0 and finite", tolerance_mm));
  if (options.most_passes < 0)
    refuse(fmt::format("{} passes: the number must be at least 0", options.most_passes));
  FairedHermite result;
  result.data = data;
  result.fit = fitHermite(data, options.fit);
  result.before = result.after = variationOf(bezierSpline(result.fit.curve));
  while (tolerance_mm > 0 && result.passes < options.most_passes) {
    const HermitePoints next =
        limited(matrixPass(result.data, options.fit.stiffness, options.fair_tangents), data.points,
                tolerance_mm);
    MatrixFit fit = fitHermite(next, options.fit);
    const CurvatureVariation variation = variationOf(bezierSpline(fit.curve));
    // Both figures have an error of this share.
    if (!(variation.energy_per_mm3 < (1 - 2 * variation_accuracy) * result.after.energy_per_mm3))
      break;
    result.data = next;
    result.fit = std::move(fit);
    result.after = variation;
    ++result.passes;
  }
  result.moved_mm = (result.data.points - data.points).rowwise().norm().maxCoeff();
  return result;
}

}  // namespace seamwright
