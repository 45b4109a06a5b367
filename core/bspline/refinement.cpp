// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include <seamwright/core/bspline/refinement.hpp>

namespace seamwright::bspline {

namespace {

/// Index of the last knot that is not above t.
int lastNotAbove(const std::vector<double>& knots, double t) {
  return static_cast<int>(std::ranges::upper_bound(knots, t) - knots.begin()) - 1;
}

/// The shares of the poles span - degree to span in the blossom at the arguments: the recurrence of
/// B-splines, with one argument a step. \p arguments are consecutive knots of a refined spline,
/// increasing, and the knot before them is in the span: so shares are not negative, and where a
/// factor would leave 0..1 its share is 0.
Eigen::VectorXd sharesAt(int degree, const std::vector<double>& knots, int span,
                         const std::vector<double>& arguments) {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(degree + 1);
  shares(0) = 1;
  for (int r = 1; r <= degree; ++r)
    for (int j = r; j-- > 0;) {
      const double share = shares(j);
      shares(j) = 0;
      if (share == 0) continue;
      const double lower = knots[span - r + 1 + j], upper = knots[span + 1 + j];
      const double right = (arguments[r - 1] - lower) / (upper - lower);
      shares(j + 1) += right * share;
      shares(j) = (1 - right) * share;
    }
  return shares;
}

PoleShares sharesOf(Eigen::Index given, Eigen::Index count, int degree, const auto& row) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < count; ++i) {
    const auto [span, shares] = row(i);
    for (int j = 0; j <= degree; ++j)
      if (shares(j) != 0) entries.emplace_back(i, span - degree + j, shares(j));
  }
  PoleShares result(count, given);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

PoleShares insertionShares(int degree, const std::vector<double>& knots,
                           const std::vector<double>& finer) {
  return sharesOf(
      std::ssize(knots) - degree - 1, std::ssize(finer) - degree - 1, degree, [&](int i) {
        const int span = lastNotAbove(knots, finer[i]);
        const std::vector<double> arguments(finer.begin() + i + 1, finer.begin() + i + 1 + degree);
        return std::pair(span, sharesAt(degree, knots, span, arguments));
      });
}

std::vector<double> elevatedKnots(const std::vector<double>& knots) {
  std::vector<double> result;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    result.push_back(knots[i]);
    if (i + 1 == knots.size() || knots[i] != knots[i + 1]) result.push_back(knots[i]);
  }
  return result;
}

PoleShares elevationShares(int degree, const std::vector<double>& knots) {
  const std::vector<double> higher = elevatedKnots(knots);
  return sharesOf(
      std::ssize(knots) - degree - 1, std::ssize(higher) - degree - 2, degree, [&](int i) {
        const int span = lastNotAbove(knots, higher[i]);
        const std::vector<double> all(higher.begin() + i + 1, higher.begin() + i + 2 + degree);
        Eigen::VectorXd shares = Eigen::VectorXd::Zero(degree + 1);
        for (int without = 0; without <= degree; ++without) {
          std::vector<double> arguments = all;
          arguments.erase(arguments.begin() + without);
          shares += sharesAt(degree, knots, span, arguments);
        }
        return std::pair<int, Eigen::VectorXd>(span, shares / (degree + 1));
      });
}

Eigen::MatrixXd combined(const PoleShares& shares, const Eigen::MatrixXd& poles) {
  Eigen::MatrixXd result(shares.rows(), poles.cols());
  for (Eigen::Index i = 0; i < shares.rows(); ++i) {
    // Differences to the pole of the largest share: equal coordinates have none.
    Eigen::Index nearest = 0;
    double largest = 0;
    for (PoleShares::InnerIterator entry(shares, i); entry; ++entry)
      if (entry.value() > largest) {
        largest = entry.value();
        nearest = entry.col();
      }
    result.row(i) = poles.row(nearest);
    for (PoleShares::InnerIterator entry(shares, i); entry; ++entry)
      if (entry.col() != nearest)
        result.row(i) += entry.value() * (poles.row(entry.col()) - poles.row(nearest));
  }
  return result;
}

}  // namespace seamwright::bspline
