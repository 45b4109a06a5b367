// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/fill/three_sided_fill.hpp>

/// The space of all fills of a three-sided hole by triangles; not a public header.
namespace seamwright::fill {

/// Derivatives of the fill from each side to the centre, of one degree less than the triangles.
struct CentreFields {
  std::vector<std::optional<Poles>> sides;  ///< nothing: position alone
  std::vector<std::optional<ConnectionFunctions>> joins;
  std::vector<FillCorner> corners;
  Poles spokes;  ///< from corner k to the centre: S' in the corner, one per row
};

/// \throws as threeSidedFill() does for corners.
/// Source: docs/theory/fills.md F4.1.
CentreFields centreFields(const std::vector<FillSide>& sides, int degree, double tolerance_rad);

/// The poles of the three triangles as affine functions of unknown points: coefficients * unknowns
/// + constants.
struct TriangleSpace {
  int degree = 0;
  Eigen::MatrixXd coefficients;  ///< #P by #U
  Poles constants;               ///< #P by 3

  Eigen::Index count() const { return BezierTriangle::row(degree, degree, 0) + 1; }
  Eigen::Index row(int triangle, int i, int j) const {
    return triangle * count() + BezierTriangle::row(degree, i, j);
  }
};

TriangleSpace triangleSpace(const std::vector<FillSide>& sides, const CentreFields& fields,
                            int degree);

/// One row for each entry of the tensors of derivatives of order \p order, of poles or of their
/// coefficients. The sum of squares is fairness.
Eigen::MatrixXd tensorsOf(const TriangleSpace& space, const Eigen::MatrixXd& poles, int order);

/// Poles of neighbours along a spoke are bitwise the same.
std::vector<BezierTriangle> trianglesOf(const TriangleSpace& space, const Poles& unknowns);

}  // namespace seamwright::fill
