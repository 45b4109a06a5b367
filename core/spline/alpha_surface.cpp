// SPDX-License-Identifier: LGPL-2.1-or-later
#include <limits>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/spline/alpha_surface.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;
using Row = Eigen::Matrix<double, 4, 3, Eigen::RowMajor>;

void requireWithin(const char* name, double value, double low, double high) {
  if (!(low <= value && value <= high))
    throw std::invalid_argument(std::string(name) + " is " + text(value) + ": it must be within " +
                                text(low) + " to " + text(high));
}

void requirePositive(const char* name, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw std::invalid_argument(std::string(name) + " is " + text(value) + ": it must be positive");
}

void requireFinite(const AlphaSurface& surface) {
  for (int k = 0; k < 16; ++k)
    if (!surface.poles.row(k).allFinite())
      throw std::invalid_argument("pole " + std::to_string(k / 4) + ", " + std::to_string(k % 4) +
                                  " is not finite");
}

/// From the poles of an alpha-curve to those of its quintic.
Eigen::Matrix<double, 6, 4> quintic(double a) {
  Eigen::Matrix<double, 6, 4> map;
  map << 1, 0, 0, 0,   //
      1 - a, a, 0, 0,  //
      0, 0.5, 0.5, 0,  //
      0, 0.5, 0.5, 0,  //
      0, 0, a, 1 - a,  //
      0, 0, 0, 1;
  return map;
}

constexpr double smallest_shape = 1e-6;  ///< below it the end derivatives are too small to build on

void requireJoin(const AlphaSurface& given, const AlphaJoin& join) {
  requireFinite(given);
  if (join.order < 1 || join.order > 3)
    throw std::invalid_argument("order " + std::to_string(join.order) + ": known are 1, 2 and 3");
  requireWithin("a_u", given.a_u, smallest_shape, 1);
  requireWithin("a_v", given.a_v, smallest_shape, 1);
  requireWithin("next_a_u", join.next_a_u, smallest_shape, 1);
  requireWithin("next_a_v", join.next_a_v, smallest_shape, 1);
  requirePositive("beta1", join.beta1);
  requirePositive("length", join.length);
  requirePositive("next_length", join.next_length);
  if (!std::isfinite(join.beta2))
    throw std::invalid_argument("beta2 is " + text(join.beta2) + ": it must be finite");
  if (given.poles.bottomRows<4>() == given.poles.middleRows<4>(8))
    throw std::invalid_argument("rows 2 and 3 are the same: the surface has no derivative across its edge");
}

/// The row's curve with another shape: the inner poles move in the ratio of the shapes.
Row reshaped(const Row& row, int index, double ratio, double noise) {
  const double defect = (row.row(0) + row.row(3) - row.row(1) - row.row(2)).norm();
  if (defect > noise)
    throw std::invalid_argument(
        "a_v and next_a_v differ, which needs Q_i0 + Q_i3 = Q_i1 + Q_i2 in every row: row " +
        std::to_string(index) + " misses it by " + text(defect) + " mm, rounding " + text(noise));
  Row result = row;
  result.row(1) = (1 - ratio) * row.row(0) + ratio * row.row(1);
  result.row(2) = (1 - ratio) * row.row(3) + ratio * row.row(2);
  return result;
}

}  // namespace

BezierPatch alphaSurfacePatch(const AlphaSurface& surface) {
  requireFinite(surface);
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
  const double h = join.length, k = join.next_length, b = join.beta1;
  const double b2 = join.order == 3 ? -2 * b * (b / h + 1 / k) : join.beta2;
  const Row last = given.poles.bottomRows<4>(), across = last - given.poles.middleRows<4>(8),
            before = given.poles.middleRows<4>(4) - last;
  const double first = b * given.a_u * k / (join.next_a_u * h);
  const double second = first * (4 * join.next_a_u - 1) + b2 * given.a_u * k * k / (2 * h) +
                        b * b * (4 * given.a_u - 1) * k * k / (h * h);
  std::vector<Row> rows = {last, last + first * across};
  if (join.order >= 2) rows.emplace_back(last + second * across + b * b * k * k / (h * h) * before);
  if (join.next_a_v != given.a_v) {
    double size = given.poles.cwiseAbs().maxCoeff();
    for (const Row& row : rows) size = std::max(size, row.cwiseAbs().maxCoeff());
    const double noise =
        64 * std::numeric_limits<double>::epsilon() * size * (1 + std::abs(first) + std::abs(second));
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i] = reshaped(rows[i], static_cast<int>(i), given.a_v / join.next_a_v, noise);
  }
  Poles poles(4 * static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    poles.middleRows<4>(4 * static_cast<Eigen::Index>(i)) = rows[i];
  return poles;
}

}  // namespace seamwright
