// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/core/enclosure/chebyshev_model.hpp>

namespace seamwright {

/// A vector function on [-1, 1], each coordinate a model.
using VectorModel = std::array<ChebyshevModel, 3>;

/// A symmetric 3 by 3 matrix function on [-1, 1]: xx, yy, zz, xy, yz, zx.
using SymmetricModel = std::array<ChebyshevModel, 6>;

VectorModel constantModel(const Eigen::Vector3d& vector);
VectorModel operator+(const VectorModel& a, const VectorModel& b);
VectorModel operator-(const VectorModel& a, const VectorModel& b);
VectorModel operator-(const VectorModel& a);
VectorModel operator*(const ChebyshevModel& factor, const VectorModel& vector);
VectorModel operator*(double factor, const VectorModel& vector);
ChebyshevModel dot(const VectorModel& a, const VectorModel& b);
/// Adds the factor times a.b to the sum.
ProductSum& addDot(ProductSum& sum, const VectorModel& a, const VectorModel& b, double factor = 1);
VectorModel cross(const VectorModel& a, const VectorModel& b);
/// A matrix times a vector; the entries of the matrix count as exact.
VectorModel operator*(const Eigen::Matrix3d& matrix, const VectorModel& vector);

SymmetricModel operator+(const SymmetricModel& a, const SymmetricModel& b);
SymmetricModel operator-(const SymmetricModel& a, const SymmetricModel& b);
SymmetricModel operator-(const SymmetricModel& a);
SymmetricModel operator*(const ChebyshevModel& factor, const SymmetricModel& matrix);
SymmetricModel operator*(double factor, const SymmetricModel& matrix);
VectorModel operator*(const SymmetricModel& matrix, const VectorModel& vector);
/// The symmetric matrix (a b^T + b a^T) / 2.
SymmetricModel symmetricProduct(const VectorModel& a, const VectorModel& b);
ChebyshevModel trace(const SymmetricModel& matrix);
/// tr(A B), the sum of the products of corresponding entries of two symmetric matrices.
ChebyshevModel contraction(const SymmetricModel& a, const SymmetricModel& b);

/// Points whose convex hull, widened by \p radius in every direction, holds the function.
template <int Dimension>
struct ControlPolygon {
  std::array<Eigen::Matrix<double, Dimension, 1>, ChebyshevModel::size> points;
  int degree = 0;  ///< there are degree + 1 points
  double radius = 0;
};

/// The radius of the control polygon of a model: Euclidean over the stored entries.
template <std::size_t Dimension>
double polygonRadius(const std::array<ChebyshevModel, Dimension>& model) {
  double square = 0;
  for (const ChebyshevModel& entry : model) {
    const double radius = entry.radius() + entry.bernsteinRounding();
    square += radius * radius;
  }
  // The factor covers the rounding of the sum of some squares and of the root: below 45 units of
  // 2^-52.
  return std::sqrt(square) * (1 + 1e-14);
}

/// The control polygon of a model, of the degree of the model or a higher one.
/// \tparam Dimension 3 for a VectorModel, 6 for a SymmetricModel.
template <std::size_t Dimension>
ControlPolygon<static_cast<int>(Dimension)> controlPolygon(
    const std::array<ChebyshevModel, Dimension>& model, int least_degree = 0) {
  ControlPolygon<static_cast<int>(Dimension)> polygon;
  polygon.degree = least_degree;
  for (const ChebyshevModel& entry : model)
    polygon.degree = std::max(polygon.degree, entry.degree());
  for (std::size_t d = 0; d < Dimension; ++d) {
    const ChebyshevModel::Coefficients control = model[d].bernstein(polygon.degree);
    for (int i = 0; i <= polygon.degree; ++i) polygon.points[i][static_cast<int>(d)] = control[i];
  }
  polygon.radius = polygonRadius(model);
  return polygon;
}

}  // namespace seamwright
