// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <seamwright/core/join/nearest/nearest.hpp>

/// The poles of two surfaces near their common edge, as the unknowns of a join; not a public
/// header.
namespace seamwright::nearest {

/// A surface at its edge: the knots along the seam, and the cross-boundary derivatives as
/// combinations of the rows of poles. Rows are counted from the edge.
struct SeamRows {
  int degree = 0;
  int count = 0;              ///< poles of a row
  std::vector<double> knots;  ///< scaled to 0..1, in the sense of the seam
  int depth = 0;              ///< rows behind the edge that take part
  /// Row k holds the coefficients of the k-th derivative by s for the rows of poles 0..3. s is 0 at
  /// the edge and 1 at the opposite edge.
  Eigen::Matrix4d across = Eigen::Matrix4d::Zero();

  /// Index of pole j of a row among the poles of the surface.
  int pole(int row, int j) const { return origin + row * row_step + j * step; }
  int origin = 0, row_step = 0, step = 0;
};

/// \param name of the surface in messages.
/// \throws std::invalid_argument as nearestJoin() does.
void requireSide(const JoinSide& side, const std::string& name);

SeamRows seamRows(const JoinSide& side, int order);

/// The unknowns, in blocks of `count` poles: first the common seam, then the rows of a behind it,
/// then those of b.
///
/// A pole has 3 coordinates, relative to a centre. For rational surfaces it has 4; the fourth one
/// is the weight times a length of the size of the rows. The squared move of such a pole is |(w dx
/// + (x - centre) dw, size dw)|^2 / w^2, which is |dx|^2 if the weight stays.
struct Unknowns {
  SeamRows a, b;
  Eigen::MatrixXd target;  ///< the given poles, one per row; on the seam the mean of both sides
  Eigen::MatrixXd seam_a, seam_b;  ///< the poles of the seam on each side
  Eigen::VectorXd move_weights;    ///< weight of a move; 0: the pole stays
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double size = 1;
  /// Divisor of the homogeneous poles of b, by which the seams' poles agree.
  double scale_b = 1;
  double seam_cost = 0;  ///< cost of joining the seams alone
  double seam_gap = 0;   ///< largest distance between poles of the seams
  double fixed_gap = 0;  ///< the same for poles that are fixed on both sides
  double largest = 0;    ///< largest coordinate, by which rounding is measured
  bool rational = false;

  int count() const { return a.count; }
  int blocks() const { return 1 + a.depth + b.depth; }
};

/// \pre both sides are valid, and have the same degree and knots along the seam.
/// \throws std::invalid_argument as nearestJoin() does.
Unknowns unknowns(const JoinSide& a, const JoinSide& b, int order);

/// Puts the poles back into the surfaces; poles that do not move stay bitwise.
void place(const Unknowns& unknowns, const Eigen::MatrixXd& poles, const JoinSide& a,
           const JoinSide& b, NearestJoin& result);

}  // namespace seamwright::nearest
