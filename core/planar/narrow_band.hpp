// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

/// Not a public header.
namespace seamwright {

/// The order in which unknowns of a sequence or a ring are eliminated: that of a sequence is its
/// own, that of a ring is 0, n-1, 1, n-2, .. . Unknowns 3 apart in the ring are at most 6 apart
/// there.
struct NarrowOrder {
  Eigen::Index count = 0;
  bool closed = false;

  Eigen::Index placeOf(Eigen::Index unknown) const {
    if (!closed) return unknown;
    return 2 * unknown < count ? 2 * unknown : 2 * (count - 1 - unknown) + 1;
  }
  Eigen::Index unknownAt(Eigen::Index place) const {
    if (!closed) return place;
    return place % 2 == 0 ? place / 2 : count - 1 - place / 2;
  }
};

/// Linear least squares whose rows couple unknowns at most 3 apart: a QR decomposition in O(n), row
/// by row with Givens' rotations. It keeps twice the digits of the normal equations.
class NarrowLeastSquares {
 public:
  explicit NarrowLeastSquares(const NarrowOrder& order)
      : order_(order),
        factor_(Factor::Zero(order.count, order.closed ? widest : 4)),
        right_(Eigen::VectorXd::Zero(order.count)) {}

  struct Term {
    Eigen::Index unknown;
    double factor;
  };
  /// Adds the square of (sum of factor x(unknown)) - right. The cost is O(1) if rows come in the
  /// order of the first place of their unknowns.
  template <std::size_t count>
  void add(const std::array<Term, count>& terms, double right) {
    Eigen::Index first = order_.count;
    for (const Term& term : terms) first = std::min(first, order_.placeOf(term.unknown));
    Row row{};
    for (const Term& term : terms) {
      const Eigen::Index place = order_.placeOf(term.unknown);
      // In a ring of three, two terms can have one unknown.
      row[static_cast<std::size_t>(place - first)] += term.factor;
      last_ = std::max(last_, place);
    }
    if (order_.closed)
      rotateIn<widest>(first, row, right);
    else
      rotateIn<4>(first, row, right);
  }

  /// \pre the rows determine all unknowns.
  Eigen::VectorXd solve() const;

 private:
  static constexpr std::size_t widest = 7;
  using Row = std::array<double, widest>;
  /// Entry k of row i belongs to column i + k.
  using Factor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  template <std::size_t width>
  void rotateIn(Eigen::Index column, Row row, double right);

  NarrowOrder order_;
  Eigen::Index last_ = 0;  ///< the last column of all rows
  Factor factor_;
  Eigen::VectorXd right_;
};

}  // namespace seamwright
