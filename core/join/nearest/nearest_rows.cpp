// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/join/nearest/nearest_rows.hpp>

namespace seamwright::nearest {

namespace {

/// Mapped to 0..1, or to 1..0 and in the opposite order.
std::vector<double> scaledKnots(const std::vector<double>& knots, bool backwards) {
  const double first = knots.front(), length = knots.back() - knots.front();
  std::vector<double> result;
  for (const double knot : knots)
    result.push_back(backwards ? (knots.back() - knot) / length : (knot - first) / length);
  if (backwards) std::ranges::reverse(result);
  return result;
}

bool isFree(const JoinSide& side, int pole) {
  return side.moves && (side.fixed.empty() || !side.fixed[pole]);
}

double weightOf(const JoinSide& side, int pole) {
  return side.weights.size() == 0 ? 1.0 : side.weights(pole);
}

/// The poles of a side in the coordinates of the unknowns.
struct Coordinates {
  const JoinSide& side;
  const Unknowns& unknowns;
  double scale;

  Eigen::RowVectorXd pole(int index) const {
    const auto h = side.surface.poles.row(index);
    const Eigen::RowVector3d x = h.head<3>() / h(3) - unknowns.centre.transpose();
    if (!unknowns.rational) return x;
    const double weight = h(3) / scale;
    Eigen::RowVectorXd result(4);
    result << weight * x, unknowns.size * weight;
    return result;
  }
  double moveWeight(int index) const {
    if (!isFree(side, index)) return 0;
    const double weight = unknowns.rational ? side.surface.poles(index, 3) / scale : 1;
    return weightOf(side, index) / (weight * weight);
  }
};

void requireExtent(const Poles& poles, const SeamRows& rows, const std::string& name) {
  for (int j = 0; j < rows.count; ++j)
    if (poles.row(rows.pole(0, j)) != poles.row(rows.pole(1, j))) return;
  throw std::invalid_argument("surface " + name + " has no extent across the seam");
}

/// Squares of lengths beyond these are no numbers of double precision.
constexpr double least_size_mm = 1e-100, most_size_mm = 1e100;

/// \param extent_mm the largest difference of a coordinate from that of the centre
void requireRange(double extent_mm, double largest_mm) {
  if (extent_mm == 0) throw std::invalid_argument("all poles along the seam are one point");
  if (extent_mm >= least_size_mm && largest_mm <= most_size_mm) return;
  throw std::invalid_argument(
      fmt::format("the poles along the seam have coordinates up to {:.3g} mm and a size of {:.3g} "
                  "mm: 1e-100 to 1e100 mm are possible",
                  largest_mm, extent_mm));
}

void measureRows(Unknowns& u, const JoinSide& a, const JoinSide& b) {
  const Poles in_a = affinePoles(a.surface.poles), in_b = affinePoles(b.surface.poles);
  requireExtent(in_a, u.a, "a");
  requireExtent(in_b, u.b, "b");
  for (int j = 0; j < u.count(); ++j)
    u.centre +=
        (in_a.row(u.a.pole(0, j)) + in_b.row(u.b.pole(0, j))).transpose() / (2.0 * u.count());
  double sum = 0, extent = 0;
  int number = 0;
  const auto add = [&](const Poles& poles, const SeamRows& rows) {
    for (int row = 0; row <= rows.depth; ++row)
      for (int j = 0; j < rows.count; ++j, ++number) {
        const Eigen::RowVector3d x = poles.row(rows.pole(row, j));
        const Eigen::RowVector3d from_centre = x - u.centre.transpose();
        sum += from_centre.squaredNorm();
        extent = std::max(extent, from_centre.cwiseAbs().maxCoeff());
        u.largest = std::max(u.largest, x.cwiseAbs().maxCoeff());
      }
  };
  add(in_a, u.a);
  add(in_b, u.b);
  requireRange(extent, u.largest);
  u.size = std::sqrt(sum / number);
}

/// The factor between the weights of the two seam rows, in the mean square.
double weightRatio(const Unknowns& u, const JoinSide& a, const JoinSide& b) {
  double in_a = 0, in_b = 0;
  for (int j = 0; j < u.count(); ++j) {
    const double weight_a = a.surface.poles(u.a.pole(0, j), 3),
                 weight_b = b.surface.poles(u.b.pole(0, j), 3);
    in_a += weight_a * weight_a;
    in_b += weight_b * weight_b;
  }
  return std::sqrt(in_b / in_a);
}

void setSeam(Unknowns& u, const Coordinates& a, const Coordinates& b) {
  u.seam_a.resize(u.count(), u.target.cols());
  u.seam_b.resize(u.count(), u.target.cols());
  for (int j = 0; j < u.count(); ++j) {
    const int in_a = u.a.pole(0, j), in_b = u.b.pole(0, j);
    const double weight_a = a.moveWeight(in_a), weight_b = b.moveWeight(in_b);
    const Eigen::RowVectorXd x = a.pole(in_a), y = b.pole(in_b);
    u.seam_a.row(j) = x;
    u.seam_b.row(j) = y;
    u.seam_gap = std::max(u.seam_gap, (x - y).norm());
    if (weight_a == 0 && weight_b == 0) u.fixed_gap = std::max(u.fixed_gap, (x - y).norm());
    if (weight_a > 0 && weight_b > 0) {
      u.move_weights(j) = weight_a + weight_b;
      u.target.row(j) = (weight_a * x + weight_b * y) / u.move_weights(j);
      u.seam_cost += weight_a * weight_b / u.move_weights(j) * (x - y).squaredNorm();
    } else {
      u.target.row(j) = weight_a == 0 ? x : y;
      u.seam_cost += (weight_a + weight_b) * (x - y).squaredNorm();
    }
  }
}

void setRows(Unknowns& u, const SeamRows& rows, const Coordinates& side, int first_block) {
  for (int row = 1; row <= rows.depth; ++row)
    for (int j = 0; j < rows.count; ++j) {
      const int index = (first_block + row - 1) * rows.count + j;
      u.target.row(index) = side.pole(rows.pole(row, j));
      u.move_weights(index) = side.moveWeight(rows.pole(row, j));
    }
}

struct Placing {
  const Unknowns& unknowns;
  const Eigen::MatrixXd& poles;

  /// Homogeneous, in the scale of its surface.
  Eigen::RowVector4d pole(int index, double weight, double scale) const {
    const Eigen::RowVector3d x = poles.row(index).head<3>();
    Eigen::RowVector4d result;
    if (unknowns.rational) {
      const double w = poles(index, 3) / unknowns.size;
      result << scale * (x + w * unknowns.centre.transpose()), scale * w;
    } else {
      result << weight * (x + unknowns.centre.transpose()), weight;
    }
    return result;
  }
};

void placeRows(const Placing& from, const SeamRows& rows, int first_block, double scale,
               BSplineSurface& to) {
  for (int row = 1; row <= rows.depth; ++row)
    for (int j = 0; j < rows.count; ++j) {
      const int index = (first_block + row - 1) * rows.count + j, pole = rows.pole(row, j);
      if (from.unknowns.move_weights(index) > 0)
        to.poles.row(pole) = from.pole(index, to.poles(pole, 3), scale);
    }
}

double largestMove(const BSplineSurface& from, const BSplineSurface& to) {
  return (affinePoles(to.poles) - affinePoles(from.poles)).rowwise().norm().maxCoeff();
}

}  // namespace

void requireSide(const JoinSide& side, const std::string& name) {
  requireValid(side.surface);
  const Eigen::Index count = side.surface.poles.rows();
  if (side.weights.size() != 0 && side.weights.size() != count)
    throw std::invalid_argument(
        "weights of surface " + name + " are " + std::to_string(side.weights.size()) +
        ": none, or one for each of " + std::to_string(count) + " poles is needed");
  if (!side.fixed.empty() && static_cast<Eigen::Index>(side.fixed.size()) != count)
    throw std::invalid_argument("fixed poles of surface " + name + " are " +
                                std::to_string(side.fixed.size()) + ": none, or one for each of " +
                                std::to_string(count) + " poles is needed");
  for (Eigen::Index i = 0; i < side.weights.size(); ++i)
    if (!(side.weights(i) > 0) || !std::isfinite(side.weights(i)))
      throw std::invalid_argument(fmt::format(
          "weight {} of a move of surface {} is {}: weights must be positive and finite", i, name,
          side.weights(i)));
}

SeamRows seamRows(const JoinSide& side, int order) {
  const BSplineSurface& s = side.surface;
  const bool along_v = along(side.edge) == SurfaceDirection::V;
  const bool at_end = side.edge == PatchEdge::U1 || side.edge == PatchEdge::V1;
  const int nu = s.countU(), nv = s.countV();
  SeamRows rows;
  rows.degree = along_v ? s.degree_v : s.degree_u;
  rows.count = along_v ? nv : nu;
  rows.knots = scaledKnots(along_v ? s.knots_v : s.knots_u, side.reversed);
  const int rows_count = along_v ? nu : nv, degree_across = along_v ? s.degree_u : s.degree_v;
  rows.depth = std::min(order, rows_count - 1);
  const std::vector<double> across = scaledKnots(along_v ? s.knots_u : s.knots_v, at_end);
  const int used = std::min(4, degree_across + 1);
  rows.across.leftCols(used) =
      bspline::basisDerivatives(degree_across, across, degree_across, 0, 3).leftCols(used);
  const int row_stride = along_v ? nv : 1, stride = along_v ? 1 : nv;
  rows.row_step = at_end ? -row_stride : row_stride;
  rows.step = side.reversed ? -stride : stride;
  rows.origin = (at_end ? (rows_count - 1) * row_stride : 0) +
                (side.reversed ? (rows.count - 1) * stride : 0);
  return rows;
}

Unknowns unknowns(const JoinSide& a, const JoinSide& b, int order) {
  Unknowns u;
  u.a = seamRows(a, order);
  u.b = seamRows(b, order);
  measureRows(u, a, b);
  u.rational = isRational(a.surface.poles) || isRational(b.surface.poles);
  u.scale_b = u.rational ? weightRatio(u, a, b) : 1;
  u.target.resize(static_cast<Eigen::Index>(u.blocks()) * u.count(), u.rational ? 4 : 3);
  u.move_weights = Eigen::VectorXd::Zero(u.target.rows());
  const Coordinates in_a{a, u, 1}, in_b{b, u, u.scale_b};
  setSeam(u, in_a, in_b);
  setRows(u, u.a, in_a, 1);
  setRows(u, u.b, in_b, 1 + u.a.depth);
  if (u.rational) u.largest = std::max(u.largest / u.size, 1.0) * u.target.col(3).maxCoeff();
  return u;
}

void place(const Unknowns& u, const Eigen::MatrixXd& poles, const JoinSide& a, const JoinSide& b,
           NearestJoin& result) {
  const Placing from{u, poles};
  for (int j = 0; j < u.count(); ++j) {
    const int in_a = u.a.pole(0, j), in_b = u.b.pole(0, j);
    auto seam_a = result.a.poles.row(in_a), seam_b = result.b.poles.row(in_b);
    const bool free_a = isFree(a, in_a), free_b = isFree(b, in_b);
    if (free_a && free_b) {
      seam_a = from.pole(j, seam_a(3), 1);
      seam_b = from.pole(j, seam_b(3), u.scale_b);
    } else if (free_a) {
      seam_a = u.rational ? Eigen::RowVector4d(seam_b / u.scale_b)
                          : Eigen::RowVector4d(seam_b * (seam_a(3) / seam_b(3)));
    } else if (free_b) {
      seam_b = u.rational ? Eigen::RowVector4d(seam_a * u.scale_b)
                          : Eigen::RowVector4d(seam_a * (seam_b(3) / seam_a(3)));
    }
  }
  placeRows(from, u.a, 1, 1, result.a);
  placeRows(from, u.b, 1 + u.a.depth, u.scale_b, result.b);
  result.largest_move_mm =
      std::max(largestMove(a.surface, result.a), largestMove(b.surface, result.b));
}

}  // namespace seamwright::nearest
