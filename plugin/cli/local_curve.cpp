// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <seamwright/core/planar/local_origin.hpp>
#include <seamwright/plugin/cli/local_curve.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

/// Lengths in mm for which no formula overflows or vanishes: the highest power of a length is the
/// eighth, in products of derivatives, and 2^800 is in the range of doubles.
constexpr double smallest_mm = 0x1p-100, largest_mm = 0x1p100;

/// Points, or ends of curves and poles, one a row.
PlanarPoints controlPoints(const GivenCurve& given) {
  if (given.points.rows() > 0) return given.points;
  std::vector<Eigen::Vector2d> found;
  for (const ChainCurve& curve : given.chain.curves)
    for (const BezierCurve& one : bezierCurves(curve)) {
      const Poles poles = one.poles();
      for (Eigen::Index i = 0; i < poles.rows(); ++i) found.emplace_back(poles.row(i).head<2>());
    }
  PlanarPoints points(static_cast<Eigen::Index>(found.size()), 2);
  for (std::size_t i = 0; i < found.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = found[i].transpose();
  return points;
}

}  // namespace

void requireSize(const GivenCurve& given) {
  const PlanarPoints points = controlPoints(given);
  const double size_mm = points.cwiseAbs().maxCoeff();
  if (!(size_mm <= largest_mm))
    throw std::domain_error(
        fmt::format("the coordinates reach {:.3g} mm, and products of lengths above {:.3g} mm "
                    "overflow: scale the curve",
                    size_mm, largest_mm));
  const double extent_mm = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  double least_mm = extent_mm;
  for (Eigen::Index i = 1; i < given.points.rows(); ++i)
    least_mm = std::min(least_mm, (points.row(i) - points.row(i - 1)).lpNorm<Eigen::Infinity>());
  if (!(least_mm >= smallest_mm))
    throw std::domain_error(fmt::format(
        "{} {:.3g} mm, and products of lengths below {:.3g} mm vanish: scale the curve",
        least_mm < extent_mm ? "two neighbours are apart by" : "the curve has a size of", least_mm,
        smallest_mm));
}

LocalCurve localCurve(const GivenCurve& given) {
  const bool has_points = given.points.rows() > 0;
  LocalCurve local{.given = given,
                   .origin = has_points ? localOrigin(given.points) : localOrigin(given.chain)};
  // Points are moved to the origin without rounding, poles of rational splines with one.
  local.rounding_mm = (has_points ? 1 : 2) * roundingAt_mm(local.origin);
  local.given.points.rowwise() -= local.origin.transpose();
  // A tolerance that is too small for that is refused by taskOf().
  for (double& tolerance_mm : local.given.tolerances_mm)
    tolerance_mm = std::max(tolerance_mm - local.rounding_mm, 0.0);
  local.given.chain = moved(given.chain, -local.origin);
  local.given.gap_mm += local.rounding_mm;
  return local;
}

CurveTask taskOf(const LocalCurve& local, const CurveTask& task) {
  // A choice: below it the rounding would take more than an eighth of the tolerance.
  constexpr double least_ratio = 8;
  CurveTask result = task;
  if (task.tolerance_mm == 0 || local.rounding_mm == 0) return result;
  if (task.tolerance_mm < least_ratio * local.rounding_mm)
    throw std::domain_error(fmt::format(
        "the tolerance {:.3g} mm is too small for coordinates of {:.3g} mm, which are "
        "rounded by {:.3g} mm: give at least {:.3g} mm, or move the curve to the origin",
        task.tolerance_mm, local.origin.cwiseAbs().maxCoeff(), local.rounding_mm,
        least_ratio * local.rounding_mm));
  result.tolerance_mm -= local.rounding_mm;
  return result;
}

void moveBack(MadeCurve& made, const LocalCurve& local) {
  made.chain = moved(made.chain, local.origin);
  made.points.rowwise() += local.origin.transpose();
  for (Clothoid& piece : made.clothoids) piece.start += local.origin;
  made.chain_distance_mm += local.rounding_mm;
  for (std::optional<double>* distance_mm : {&made.record.distance_mm, &made.record.moved_mm})
    if (*distance_mm && **distance_mm > 0) **distance_mm += local.rounding_mm;
}

}  // namespace seamwright::cli
