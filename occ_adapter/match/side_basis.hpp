// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include <seamwright/occ_adapter/convert/spline_surface.hpp>

/// Points and derivatives across a side as sums over poles; not a public header.
namespace seamwright::occ {

constexpr int most_rows = 3;

/// X^(k) = sum over rows r <= k and columns of share[k](r, j - first) pole(r, j): the k-th
/// derivative by the parameter across, which grows into the face.
struct Blend {
  int first = 0;
  std::array<Eigen::MatrixXd, most_rows> share;
};

/// The surface must outlive it.
class SideBasis {
 public:
  explicit SideBasis(const EdgeRows& rows);

  Blend at(double t) const;
  /// Share of the first pole of row \p order in that derivative, weights apart.
  double leading(int order) const { return across_(order, order); }

 private:
  const EdgeRows& rows_;
  std::vector<double> along_;
  Eigen::MatrixXd across_;
};

Eigen::Vector3d derivative(const EdgeRows& rows, const Blend& blend, int order);

/// Flat knots across that begin at the side with 0 and grow into the face.
std::vector<double> knotsFromSide(const EdgeRows& rows);

/// Ends and points of each span of flat knots from 0 to 1, Chebyshev-Lobatto; \p per_span + 1 in
/// each, ends shared.
std::vector<double> placesInSpans(const std::vector<double>& knots, int per_span);

}  // namespace seamwright::occ
