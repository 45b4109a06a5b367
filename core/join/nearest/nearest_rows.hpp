// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/join/nearest/nearest.hpp>

/// The poles of two surfaces near their common edge, as the unknowns of a join; not a public
/// header.
namespace seamwright::nearest {

/// A surface along its edge: knots along the seam, derivatives across it by the poles' rows, which
/// are counted from the edge.
struct SeamRows {
  int degree = 0;
  int count = 0;              ///< poles of a row
  std::vector<double> knots;  ///< scaled to 0..1, in the sense of the seam
  int depth = 0;              ///< rows behind the edge that take part
  /// Row k: the k-th derivative by s from rows 0..2; s is 0 at the edge, 1 at the opposite one.
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();

  /// Index of a pole in the surface.
  int pole(int row, int j) const { return origin + row * row_step + j * step; }
  int origin = 0, row_step = 0, step = 0;
};

SeamRows seamRows(const JoinSide& side, int order);

/// The unknowns, in blocks of `count` poles each: the common seam, then the rows of a behind it,
/// then those of b.
///
/// A pole has 3 coordinates, about a centre; of rational surfaces 4, the fourth being the weight
/// times a length of the size of the rows. The squared move of a pole is then |(w dx + (x - centre)
/// dw, size dw)|^2 / w^2: |dx|^2 where the weight stays.
struct Unknowns {
  SeamRows a, b;
  Eigen::MatrixXd
      target;  ///< where the poles want to be, one a row; on the seam the mean of both sides
  Eigen::MatrixXd seam_a, seam_b;  ///< the seam's poles as each side has them
  Eigen::VectorXd pull;            ///< weight of a move, 0: the pole stays
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double size = 1;
  double scale_b =
      1;  ///< homogeneous poles of b are divided by it, so that those of the seams agree
  double seam_cost = 0;  ///< cost of joining the seams alone
  double seam_gap = 0;   ///< largest distance between poles of the seams
  double fixed_gap = 0;  ///< and between those that are fixed on both sides
  double largest = 0;    ///< coordinate, which rounding is measured by
  bool rational = false;

  int count() const { return a.count; }
  int blocks() const { return 1 + a.depth + b.depth; }
};

/// \throws std::invalid_argument as nearestJoin() does.
Unknowns unknowns(const JoinSide& a, const JoinSide& b, int order);

/// Puts the poles back into the surfaces; those that do not move keep every bit.
void place(const Unknowns& unknowns, const Eigen::MatrixXd& poles, const JoinSide& a,
           const JoinSide& b, NearestJoin& result);

}  // namespace seamwright::nearest
