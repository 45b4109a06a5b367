// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/SparseCore>
#include <vector>

/// The poles of a spline over more knots, or of a higher degree; not a public header. Knots are
/// flat and clamped.
namespace seamwright::bspline {

/// A row for each new pole: its shares of the given poles. No share is negative, and they add up
/// to 1.
using PoleShares = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The shares of the poles over \p finer, which has all the knots and more, by the Oslo algorithm.
/// A pole none of whose knots is new has one share, which is 1. The cost is linear in the knots.
/// Source: [CohenEtAl1980].
PoleShares insertionShares(int degree, const std::vector<double>& knots,
                           const std::vector<double>& finer);

/// Each knot once more, as the degree + 1 needs it.
std::vector<double> elevatedKnots(const std::vector<double>& knots);

/// The shares of the poles of the degree + 1, over elevatedKnots(): the mean of the blossom at
/// degree of the degree + 1 knots of a pole.
/// Source: [Ramshaw1989].
PoleShares elevationShares(int degree, const std::vector<double>& knots);

/// The combinations of the poles, one a row. Where all poles of a combination have one coordinate
/// in common, so has the new one, bitwise: weights of 1 stay 1.
Eigen::MatrixXd combined(const PoleShares& shares, const Eigen::MatrixXd& poles);

}  // namespace seamwright::bspline
