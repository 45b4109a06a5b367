// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <seamwright/core/spline/alpha_form.hpp>
#include <seamwright/core/spline/alpha_join_condition.hpp>

namespace seamwright {

namespace {

using alpha::Row;
using bernstein::text;
using Quintic = Eigen::Matrix<double, 6, 3>;
using Quartic = Eigen::Matrix<double, 5, 3>;

/// Up to this share of the size of the poles a value counts as rounding.
constexpr double slack = 64 * std::numeric_limits<double>::epsilon();

Row rowOf(const AlphaSurface& surface, int i) {
  return surface.poles.middleRows<4>(4 * i);
}

double largestEntry(const Eigen::Ref<const Eigen::MatrixXd>& values) {
  return values.cwiseAbs().maxCoeff();
}

double longest(const Quintic& values) {
  return values.rowwise().stableNorm().maxCoeff();
}

/// The surface in a unit of length for which squares stay within the range of a double.
AlphaSurface inUnits(AlphaSurface surface, int exponent) {
  surface.poles = bernstein::scaledBy<AlphaSurface::Net>(surface.poles, -exponent);
  return surface;
}

int unitOf(const AlphaSurface& a, const AlphaSurface& b) {
  return bernstein::scaleExponent(std::max(largestEntry(a.poles), largestEntry(b.poles)));
}

void requireUsable(const AlphaSurface& surface, const char* prefix = "") {
  alpha::requireWithin(std::string(prefix) + "a_u", surface.a_u, alpha::kSmallestShape, 1);
  alpha::requireWithin(std::string(prefix) + "a_v", surface.a_v, alpha::kSmallestShape, 1);
  alphaSurfacePatch(surface);  // refuses poles that are not finite
}

/// X_u and X_v along the seam: coefficients of degree 5 and 4.
struct Seam {
  Quintic across;
  Quartic along;
};

Seam seamOf(const AlphaSurface& given) {
  const Eigen::Matrix<double, 6, 4> map = alpha::quintic(given.a_v);
  const Row last = rowOf(given, 3);
  const Quintic edge = map * last;
  return {5 * given.a_u * map * (last - rowOf(given, 2)),
          5 * (edge.bottomRows<5>() - edge.topRows<5>())};
}

void requireRegular(const Seam& seam) {
  if (seam.across.isZero(0))
    throw std::invalid_argument(
        "rows 2 and 3 are the same: the surface has no derivative across its edge");
  if (seam.along.isZero(0))
    throw std::invalid_argument("row 3 is one point: the edge has no direction");
}

/// The product of a quartic with ((1 - t) beta0 + t beta1).
Quintic slid(const Quartic& along, double beta0, double beta1) {
  Quintic result = Quintic::Zero();
  for (int i = 0; i < 5; ++i) {
    result.row(i) += (5 - i) / 5.0 * beta0 * along.row(i);
    result.row(i + 1) += (i + 1) / 5.0 * beta1 * along.row(i);
  }
  return result;
}

/// Equations (i) and (ii): 0 iff the quintic is an alpha-curve of that shape.
Eigen::Matrix<double, 6, 1> misfit(const Quintic& q, double shape) {
  Eigen::Matrix<double, 6, 1> result;
  result << (q.row(2) - q.row(3)).transpose(),
      (q.row(1) + q.row(4) - (1 - shape) * (q.row(0) + q.row(5)) - shape * (q.row(2) + q.row(3)))
          .transpose();
  return result;
}

/// The poles of an alpha-curve from its quintic.
Row alphaRow(const Quintic& q, double shape) {
  Row row;
  row << q.row(0), (q.row(1) - (1 - shape) * q.row(0)) / shape,
      (q.row(4) - (1 - shape) * q.row(5)) / shape, q.row(5);
  return row;
}

/// Finds the family of first rows, with fields divided by their sizes.
void findFamily(const AlphaSurface& given, double next_a_v, AlphaSeamCondition& condition) {
  const Seam seam = seamOf(given);
  requireRegular(seam);
  const double across = largestEntry(seam.across), along = largestEntry(seam.along);
  Eigen::Matrix<double, 6, 3> equations;
  equations << misfit(seam.across / across, next_a_v),
      misfit(slid(seam.along / along, 1, 0), next_a_v),
      misfit(slid(seam.along / along, 0, 1), next_a_v);
  if (condition.any_net) equations.col(0).setZero();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(equations, Eigen::ComputeFullV);
  condition.singular = svd.singularValues();
  condition.rank_noise =
      slack * largestEntry(given.poles) * std::max(5 * given.a_u / across, 5 / along);
  const auto rank = (condition.singular.array() > condition.rank_noise).count();
  const Eigen::Vector3d sizes(1 / across, 1 / along, 1 / along);
  condition.first_rows = sizes.asDiagonal() * svd.matrixV().rightCols(3 - rank);
  const double goes_on = (svd.matrixV().rightCols(3 - rank).row(0)).norm();
  condition.g1 =
      condition.order >= 0 && rank < 3 && goes_on > std::max(condition.rank_noise, slack);
}

void requireOrder(int order) {
  if (order < 0 || order > 2)
    throw std::invalid_argument("order " + std::to_string(order) + ": known are 0, 1 and 2");
}

/// Coefficients of u-derivatives along the seam.
struct Derivatives {
  Quintic position, first, second;
};

/// \param at_end the seam is u = 1, else u = 0.
Derivatives derivativesAt(const AlphaSurface& surface, bool at_end) {
  const auto row = [&](int i) { return rowOf(surface, at_end ? 3 - i : i); };
  const Eigen::Matrix<double, 6, 4> map = alpha::quintic(surface.a_v);
  const double sense = at_end ? -1 : 1, a = surface.a_u;
  const Row leg = row(1) - row(0);
  return {map * row(0), map * (5 * a * sense * leg),
          map * (10 * ((1 - 4 * a) * leg + row(2) - row(0)))};
}

double relative(double residual, double size) {
  return residual == 0 ? 0 : residual / size;
}

double sumOfSquares(const AlphaSurface& x, const AlphaSurface& y) {
  return (x.poles - y.poles).squaredNorm();
}

/// The minimum over b > 0 of F with F(0) = 0, F' = c3 b^3 + c1 b + c0, c3 >= 0; nothing if F > 0
/// there. F' has one change from - to + at most. Newton's method from above, where it is convex.
std::optional<double> positiveMinimum(double c3, double c1, double c0) {
  if (c0 >= 0 && c1 >= 0) return std::nullopt;
  double b = std::numeric_limits<double>::infinity();
  if (c3 > 0) b = std::cbrt(std::abs(c0) / c3) + std::sqrt(std::abs(c1) / c3);
  if (c1 > 0) b = std::min(b, -c0 / c1);
  if (!std::isfinite(b)) return std::nullopt;
  const double turn = c1 < 0 ? std::sqrt(-c1 / (3 * c3)) : 0;
  if (c1 < 0 && (c3 * turn * turn + c1) * turn + c0 >= 0) return std::nullopt;
  // From above each step takes at least about a third of the distance, at a double root half of it:
  // fewer than 100 reach the last bit. A bound against endless work.
  constexpr int most_steps = 200;
  for (int step = 0; step < most_steps; ++step) {
    const double next = b - ((c3 * b * b + c1) * b + c0) / (3 * c3 * b * b + c1);
    if (!(next < b)) break;
    b = std::max(next, turn);
  }
  const bool below = c1 * b + 3 * c0 < 0;  // 4 F(b) / b, where F' = 0
  return b > 0 && below ? std::optional(b) : std::nullopt;
}

void requireFit(const AlphaSeamFit& fit) {
  const std::pair<const char*, double> numbers[] = {{"beta1", fit.beta1},
                                                    {"beta2", fit.beta2},
                                                    {"gap_mm", fit.gap_mm},
                                                    {"first", fit.first},
                                                    {"second", fit.second}};
  for (const auto& [name, value] : numbers)
    if (!std::isfinite(value))
      throw std::invalid_argument(std::string(name) + " comes out as " + text(value) +
                                  ": the lengths or poles are too large or too small to fit");
}

double product(const Row& x, const Row& y) {
  return x.cwiseProduct(y).sum();
}

struct Betas {
  double beta1 = 1, beta2 = 0;
};

/// Converts betas by the surfaces' own u into betas by the common parameter.
Betas byCommonParameter(const Betas& own, double length, double next_length) {
  return {own.beta1 * (length / next_length), own.beta2 * (length / next_length) / next_length};
}

/// The cheapest betas by the surfaces' own u. across, before are P_3 - P_2 and P_1 - P_3 in the
/// shape of the next surface. \pre poles of moderate size.
std::optional<Betas> cheapest(const AlphaSurface& given, const AlphaSurface& next, int order) {
  const auto shaped = [&](const Row& row) { return alpha::reshaped(row, given.a_v / next.a_v); };
  const Row end = shaped(rowOf(given, 3)), across = end - shaped(rowOf(given, 2)),
            before = shaped(rowOf(given, 1)) - end;
  const alpha::Side from{given.a_u}, to{next.a_u};
  const alpha::Factors unit = alpha::factors(from, to, 1, 0);
  const Row wanted1 = rowOf(next, 1) - end, wanted2 = rowOf(next, 2) - end;
  double c3 = 0, c1 = unit.first * unit.first * product(across, across),
         c0 = -unit.first * product(across, wanted1);
  const double square = product(across, across);
  if (order == 2) {  // beta2 compensates the component along `across`
    const Row side = before - product(before, across) / square * across;
    c3 = 2 * unit.third * unit.third * product(side, side);
    c1 -= 2 * unit.third * product(side, wanted2);
  }
  const std::optional<double> beta1 = positiveMinimum(c3, c1, c0);
  if (!beta1) return std::nullopt;
  Betas betas{*beta1, 0};
  if (order == 2) {
    const alpha::Factors without = alpha::factors(from, to, *beta1, 0),
                         with = alpha::factors(from, to, *beta1, 1);
    const double second = product(wanted2 - without.third * before, across) / square;
    betas.beta2 = (second - without.second) / (with.second - without.second);
  }
  return betas;
}

}  // namespace

AlphaSeamCondition alphaSeamCondition(const AlphaSurface& given, double next_a_v) {
  requireUsable(given);
  alpha::requireWithin("next_a_v", next_a_v, alpha::kSmallestShape, 1);
  AlphaSeamCondition condition;
  condition.any_net = given.a_v == next_a_v;
  condition.noise_mm = slack * largestEntry(given.poles);
  for (int i = 0; i < 3; ++i)
    condition.defects_mm[static_cast<std::size_t>(i)] =
        alpha::defect(rowOf(given, 3 - i)).stableNorm();
  const auto meets = [&](std::size_t i) {
    return condition.any_net || condition.defects_mm[i] <= condition.noise_mm;
  };
  while (condition.order < 2 && meets(static_cast<std::size_t>(condition.order + 1)))
    ++condition.order;
  findFamily(given, next_a_v, condition);
  return condition;
}

Poles alphaSlidingRows(const AlphaSurface& given, double next_a_u, double next_a_v, double alpha,
                       double beta0, double beta1) {
  requireUsable(given);
  alpha::requireWithin("next_a_u", next_a_u, alpha::kSmallestShape, 1);
  alpha::requireWithin("next_a_v", next_a_v, alpha::kSmallestShape, 1);
  alpha::requirePositive("alpha", alpha);
  alpha::requireFinite("beta0", beta0);
  alpha::requireFinite("beta1", beta1);
  const Seam seam = seamOf(given);
  requireRegular(seam);
  const Quintic edge = alpha::quintic(given.a_v) * rowOf(given, 3),
                first = alpha * seam.across + slid(seam.along, beta0, beta1);
  const double size = largestEntry(given.poles);
  const double edge_miss = misfit(edge, next_a_v).stableNorm(),
               miss = misfit(first, next_a_v).stableNorm();
  const double spread = alpha * given.a_u + std::abs(beta0) + std::abs(beta1);
  if (given.a_v != next_a_v && edge_miss > slack * size)
    throw std::invalid_argument(
        "a_v and next_a_v differ, and the edge is not a curve of both shapes: it misses that by " +
        text(edge_miss) + " mm, rounding " + text(slack * size));
  if (miss > 10 * slack * size * spread)
    throw std::invalid_argument(
        "alpha X_u + beta X_v is not the derivative of an alpha-surface: it misses that by " +
        text(miss) + " mm, rounding " + text(10 * slack * size * spread));
  const Row row = given.a_v == next_a_v ? rowOf(given, 3) : alphaRow(edge, next_a_v);
  Poles rows(8, 3);
  rows << row, row + alphaRow(first, next_a_v) / (5 * next_a_u);
  if (!rows.allFinite())
    throw std::invalid_argument("a pole is not finite: alpha or beta is too large");
  return rows;
}

AlphaSurface alphaBalanced(const AlphaSurface& given, int order) {
  alphaSurfacePatch(given);  // refuses an invalid surface
  requireOrder(order);
  AlphaSurface result = given;
  for (int i = 3; i >= 3 - order; --i) {
    const Eigen::RowVector3d quarter = alpha::defect(rowOf(given, i)) / 4;
    for (const int j : {0, 3}) result.poles.row(4 * i + j) -= quarter;
    for (const int j : {1, 2}) result.poles.row(4 * i + j) += quarter;
  }
  return result;
}

AlphaSeamFit alphaSeamFit(const AlphaSurface& a, const AlphaSurface& b, double length,
                          double next_length) {
  requireUsable(a);
  requireUsable(b, "next_");
  alpha::requirePositive("length", length);
  alpha::requirePositive("next_length", next_length);
  const int unit = unitOf(a, b);
  const AlphaSurface from = inUnits(a, unit), to = inUnits(b, unit);
  requireRegular(seamOf(from));
  const Derivatives x = derivativesAt(from, true), y = derivativesAt(to, false);
  AlphaSeamFit fit;
  const double square = x.first.squaredNorm();
  const double beta1 = x.first.cwiseProduct(y.first).sum() / square;
  const Quintic bent = y.second - beta1 * beta1 * x.second;
  const double beta2 = x.first.cwiseProduct(bent).sum() / square;
  const Betas common = byCommonParameter({beta1, beta2}, length, next_length);
  fit.beta1 = common.beta1;
  fit.beta2 = common.beta2;
  const double first = longest(y.first);
  const double second = std::max(
      {longest(y.second), beta1 * beta1 * longest(x.second), std::abs(beta2) * longest(x.first)});
  fit.first = relative(longest(y.first - beta1 * x.first), first);
  fit.second = relative(longest(bent - beta2 * x.first), second);
  // Speeds of u by the common parameter, scaled such that the larger one is 1.
  const double of_x = std::min(1.0, next_length / length),
               of_y = std::min(1.0, length / next_length);
  fit.c_first = relative(longest(of_y * y.first - of_x * x.first),
                         std::max(of_y * first, of_x * longest(x.first)));
  fit.c_second =
      relative(longest(of_y * of_y * y.second - of_x * of_x * x.second),
               std::max(of_y * of_y * longest(y.second), of_x * of_x * longest(x.second)));
  const double size = std::max(largestEntry(from.poles), largestEntry(to.poles));
  const double speed = size * (a.a_u * std::abs(beta1) + b.a_u);
  const double bend = size * (beta1 * beta1 + 1 + std::abs(beta2) * a.a_u);
  const double gap = longest(y.position - x.position);
  fit.gap_mm = std::ldexp(gap, unit);
  fit.noise = {std::ldexp(slack * size, unit), relative(slack * 5 * speed, first),
               relative(slack * 40 * bend, second)};
  requireFit(fit);
  if (gap > slack * size) return fit;
  fit.geometric_order = !(fit.beta1 > 0) || fit.first > fit.noise[1] ? 0
                        : fit.second > fit.noise[2]                  ? 1
                                                                     : 2;
  fit.parametric_order = fit.c_first > fit.noise[1] ? 0 : fit.c_second > fit.noise[2] ? 1 : 2;
  return fit;
}

std::optional<AlphaNearest> alphaNearestJoin(const AlphaSurface& given, const AlphaSurface& next,
                                             const AlphaNearestOptions& options) {
  requireUsable(given);
  requireUsable(next, "next_");
  requireOrder(options.order);
  alpha::requirePositive("length", options.length);
  alpha::requirePositive("next_length", options.next_length);
  AlphaNearest result{given, next};
  if (given.a_v != next.a_v && alphaSeamCondition(given, next.a_v).order < options.order)
    result.given = alphaBalanced(given, options.order);
  requireRegular(seamOf(result.given));
  if (options.order == 0) {
    result.next.poles.topRows<4>() = alpha::reshaped(rowOf(result.given, 3), given.a_v / next.a_v);
  } else {
    if (!options.parametric) {
      const int unit = unitOf(result.given, next);
      const std::optional<Betas> own =
          cheapest(inUnits(result.given, unit), inUnits(next, unit), options.order);
      if (!own) return std::nullopt;
      const Betas common = byCommonParameter(*own, options.length, options.next_length);
      result.beta1 = common.beta1;
      result.beta2 = common.beta2;
    }
    const Poles rows =
        alphaJoinRows(result.given, {options.order, result.beta1, result.beta2, options.length,
                                     options.next_length, next.a_u, next.a_v});
    result.next.poles.topRows(rows.rows()) = rows;
  }
  result.cost_given = sumOfSquares(result.given, given);
  result.cost_next = sumOfSquares(result.next, next);
  return result;
}

}  // namespace seamwright
