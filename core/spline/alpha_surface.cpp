// SPDX-License-Identifier: LGPL-2.1-or-later
#include <limits>
#include <seamwright/core/spline/alpha_form.hpp>
#include <seamwright/core/spline/alpha_surface.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using alpha::quintic;
using alpha::requireWithin;
using alpha::Row;
using bernstein::text;

void requireFiniteNet(const AlphaSurface& surface) {
  for (int k = 0; k < 16; ++k)
    if (!surface.poles.row(k).allFinite())
      throw std::invalid_argument("pole " + std::to_string(k / 4) + ", " + std::to_string(k % 4) +
                                  " is not finite");
}

void requireJoin(const AlphaSurface& given, const AlphaJoin& join) {
  requireFiniteNet(given);
  alpha::requireJoin(join);
  requireWithin("a_u", given.a_u, alpha::kSmallestShape, 1);
  requireWithin("a_v", given.a_v, alpha::kSmallestShape, 1);
  requireWithin("next_a_u", join.next_a_u, alpha::kSmallestShape, 1);
  requireWithin("next_a_v", join.next_a_v, alpha::kSmallestShape, 1);
  if (given.poles.bottomRows<4>() == given.poles.middleRows<4>(8))
    throw std::invalid_argument(
        "rows 2 and 3 are the same: the surface has no derivative across its edge");
}

void requireBalanced(const Row& row, std::size_t index, double noise) {
  const double miss = alpha::defect(row).stableNorm();
  if (miss > noise)
    throw std::invalid_argument(
        "a_v and next_a_v differ, which needs Q_i0 + Q_i3 = Q_i1 + Q_i2 in every row: row " +
        std::to_string(index) + " misses it by " + text(miss) + " mm, rounding " + text(noise));
}

}  // namespace

BezierPatch alphaSurfacePatch(const AlphaSurface& surface) {
  requireFiniteNet(surface);
  requireWithin("a_u", surface.a_u, 0, 1);
  requireWithin("a_v", surface.a_v, 0, 1);
  const Eigen::Matrix<double, 6, 4> along_u = quintic(surface.a_u), along_v = quintic(surface.a_v);
  Poles poles(36, 3);
  for (int c = 0; c < 3; ++c) {
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> net =
        surface.poles.col(c).reshaped<Eigen::RowMajor>(4, 4);
    const Eigen::Matrix<double, 6, 6> raised = along_u * net * along_v.transpose();
    poles.col(c) = raised.reshaped<Eigen::RowMajor>();
  }
  return {5, 5, poles};
}

Poles alphaJoinRows(const AlphaSurface& given, const AlphaJoin& join) {
  requireJoin(given, join);
  const double beta2 =
      join.order == 3 ? alpha::beta2OfG3(join.beta1, join.length, join.next_length) : join.beta2;
  const auto [first, second, third] = alpha::factors(
      {given.a_u, join.length}, {join.next_a_u, join.next_length}, join.beta1, beta2);
  const Row last = given.poles.bottomRows<4>(), across = last - given.poles.middleRows<4>(8),
            before = given.poles.middleRows<4>(4) - last;
  std::vector<Row> rows = {last, last + first * across};
  if (join.order >= 2) rows.emplace_back(last + second * across + third * before);
  if (join.next_a_v != given.a_v) {
    double size = given.poles.cwiseAbs().maxCoeff();
    for (const Row& row : rows) size = std::max(size, row.cwiseAbs().maxCoeff());
    const double noise = 64 * std::numeric_limits<double>::epsilon() * size *
                         (1 + std::abs(first) + std::abs(second));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      requireBalanced(rows[i], i, noise);
      rows[i] = alpha::reshaped(rows[i], given.a_v / join.next_a_v);
    }
  }
  Poles poles(4 * static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    poles.middleRows<4>(4 * static_cast<Eigen::Index>(i)) = rows[i];
  alpha::requireInRange(poles);
  return poles;
}

}  // namespace seamwright
