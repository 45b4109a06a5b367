// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

/// Not a public header.
namespace seamwright {

/// Linear least squares with rows that couple unknowns of a sequence, or of a ring, that are at most
/// 3 apart: a QR decomposition in O(n), row by row with Givens' rotations. It keeps twice the digits
/// of the normal equations.
///
/// The unknowns of a ring are taken in the order 0, n-1, 1, n-2, ..: there those 3 apart in the ring
/// are at most 6 apart.
class NarrowLeastSquares {
 public:
  NarrowLeastSquares(Eigen::Index count, bool closed)
      : closed_(closed),
        width_(closed ? 7 : 4),
        factor_(Rows::Zero(count, width_)),
        right_(Eigen::VectorXd::Zero(count)) {}

  struct Term {
    Eigen::Index unknown;
    double factor;
  };
  /// Adds the square of (sum of factor x(unknown)) - right. To keep the band, rows are added by their
  /// first place, see placeOf().
  template <std::size_t count>
  void add(const std::array<Term, count>& terms, double right) {
    Eigen::Index first = factor_.rows();
    for (const Term& term : terms) first = std::min(first, placeOf(term.unknown));
    Row row{};
    for (const Term& term : terms) {
      const Eigen::Index place = placeOf(term.unknown);
      row[static_cast<std::size_t>(place - first)] += term.factor;
      last_ = std::max(last_, place);
    }
    rotateIn(first, row, right);
  }

  /// The unknown at a place of the order of elimination, and back.
  Eigen::Index placeOf(Eigen::Index unknown) const {
    const Eigen::Index last = factor_.rows() - 1;
    if (!closed_) return unknown;
    return 2 * unknown <= last ? 2 * unknown : 2 * (last - unknown) + 1;
  }

  /// \pre the rows determine all unknowns.
  Eigen::VectorXd solve() const;

 private:
  using Row = std::array<double, 7>;
  /// Entry k of row i belongs to column i + k.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  void rotateIn(Eigen::Index column, Row row, double right);

  bool closed_;
  std::size_t width_;
  Eigen::Index last_ = 0;  ///< the last column of all rows
  Rows factor_;
  Eigen::VectorXd right_;
};

}  // namespace seamwright
