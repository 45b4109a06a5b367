// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include <seamwright/occ_adapter/convert/spline_surface.hpp>

/// Points of a side and derivatives across it as sums over poles. Not a public header.
namespace seamwright::occ {

/// G2 needs derivatives of orders 0 to 2 across a side: that of order k depends on rows 0 to k.
constexpr int most_rows = 3;

/// X^(k) = sum over rows r <= k and columns j of share[k](r, j - first) pole(r, j): the k-th
/// derivative by the parameter across the side, which increases into the face.
struct Blend {
  int first = 0;
  std::array<Eigen::MatrixXd, most_rows> share;
};

/// The shares of poles along a side. The surface must outlive it.
class SideBasis {
 public:
  explicit SideBasis(const EdgeRows& rows);

  Blend at(double t) const;
  /// Share of the first pole of row \p order in that derivative, without weights.
  double leading(int order) const { return across_(order, order); }

 private:
  const EdgeRows& rows_;
  std::vector<double> along_;
  Eigen::MatrixXd across_;
};

/// X^(order) of the blend with the poles of \p rows.
Eigen::Vector3d derivative(const EdgeRows& rows, const Blend& blend, int order);

/// Flat knots across the side, from 0 at the side, increasing into the face.
std::vector<double> knotsFromSide(const EdgeRows& rows);

/// Chebyshev-Lobatto points of each span of flat knots from 0 to 1: \p per_span + 1 in each span,
/// with the ends shared.
std::vector<double> parametersInSpans(const std::vector<double>& knots, int per_span);

}  // namespace seamwright::occ
