// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/local_origin.hpp>
#include <seamwright/core/planar/plane_frame.hpp>
#include <seamwright/core/planar/sampled_chain.hpp>
#include <seamwright/core/planar/touch_point.hpp>
#include <seamwright/plugin/cli/sampled_curve.hpp>

namespace seamwright::cli {

namespace {

/// What the digits of the points hide: twice their rounding, because a curve near rounded points is
/// off as well; of points that count as exact a billionth of their extent.
double hidden_mm(const PointFile& file) {
  constexpr double roundings = 2, exact = 1e-9;
  const double extent_mm =
      (file.points.colwise().maxCoeff() - file.points.colwise().minCoeff()).maxCoeff();
  return std::max(roundings * file.rounding_mm, exact * extent_mm);
}

/// Whether points are more than a chain has free numbers. Each says one number, where it lies
/// across the chain. A piece has its length, an arc its radius as well, an open chain a direction.
bool hasSparePoints(const SampledChain& chain, Eigen::Index points, Eigen::Index lines) {
  constexpr Eigen::Index spare = 2;
  const auto pieces = static_cast<Eigen::Index>(chain.arcs.size());
  return points >= pieces + (pieces - lines) + (chain.closed ? 0 : 1) + spare;
}

/// Whether the curvature jumps visibly at each joint that is no corner. Arcs of the length L near a
/// curve of continuous curvature have jumps of about 125 d / L^2, if the distance is d: the error
/// of the curvature is a sawtooth, whose double integral is that. So a curve of arcs with jumps of
/// eight times as much is none of those.
bool jumpsVisibly(const SampledChain& chain, double hidden_mm) {
  constexpr double visible = 1000;
  const std::size_t count = chain.arcs.size();
  for (std::size_t i = chain.closed ? 0 : 1; i < count; ++i) {
    const PlanarArc &before = chain.arcs[(i + count - 1) % count], &after = chain.arcs[i];
    const bool is_corner = std::ranges::count(chain.corners, static_cast<int>(i)) > 0;
    if (is_corner || count == 1) continue;
    const double length_mm = std::min(before.length_mm, after.length_mm);
    const double jump_per_mm = std::abs(after.curvature_per_mm - before.curvature_per_mm);
    if (jump_per_mm * length_mm * length_mm < visible * hidden_mm) return false;
  }
  return true;
}

/// The parameter, by the knots of bezierSpline(), of a point of an arc of the chain.
double parameterAt(const std::vector<double>& knots, double curvature_per_mm, double length_mm) {
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, length_mm);
  const double begin = *(above - 1), end = *above;
  // Both tangents of the rational quadratic have angles a against its chord, and up to the point it
  // turns by 2 h.
  const double a = curvature_per_mm * (end - begin) / 2,
               h = curvature_per_mm * (length_mm - begin) / 2;
  const double t =
      a == 0 ? (length_mm - begin) / (end - begin) : std::sin(h) / (std::sin(a - h) + std::sin(h));
  return begin + t * (end - begin);
}

/// How far an arc advances to the point nearest to another one; beside its ends they are it.
double nearestLength_mm(const PlanarArc& arc, const Eigen::Vector2d& point, double beside_mm) {
  const double k = std::abs(arc.curvature_per_mm);
  double along_mm = touchPointOf(arc).lengthTo_mm(point);
  if (k > 0 && along_mm < -beside_mm) along_mm += 2 * std::numbers::pi / k;
  if (along_mm > arc.length_mm - beside_mm) return arc.length_mm;
  return along_mm < beside_mm ? 0 : along_mm;
}

/// The parameters of the points of the chain that are nearest to points.
std::vector<double> parametersOf(const SampledChain& chain, const PlanarPoints& points,
                                 const std::vector<double>& knots, double beside_mm) {
  std::vector<double> result;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector2d point = points.row(i).transpose();
    double before_mm = 0, nearest_mm = infinite, parameter = 0;
    for (const PlanarArc& arc : chain.arcs) {
      const double along_mm = nearestLength_mm(arc, point, beside_mm),
                   distance_mm = (arc.point(along_mm) - point).norm();
      if (distance_mm < nearest_mm) {
        nearest_mm = distance_mm;
        parameter = parameterAt(knots, arc.curvature_per_mm, before_mm + along_mm);
      }
      before_mm += arc.length_mm;
    }
    result.push_back(chain.closed && parameter >= knots.back() ? 0 : parameter);
  }
  return result;
}

/// The spline of the plane in space.
BezierSpline inSpace(BezierSpline spline, const PlaneFrame& frame) {
  for (Eigen::Index i = 0; i < spline.poles.rows(); ++i) {
    const Eigen::Vector4d pole = spline.poles.row(i).transpose();
    spline.poles.row(i).head<3>() =
        (pole[3] * frame.origin + frame.direction(pole.head<2>())).transpose();
  }
  return spline;
}

}  // namespace

std::optional<SampledCurve> sampledCurve(const PointFile& file, bool closed) {
  constexpr Eigen::Index least_points = 3;
  if (file.points.rows() < least_points) return std::nullopt;
  const double tolerance_mm = hidden_mm(file);
  FittedPlane plane = fitPlane(file.points);
  if (plane.distance_mm > tolerance_mm) return std::nullopt;
  PlanarPoints points = coordinatesIn(plane.frame, file.points);
  const Eigen::Vector2d origin = localOrigin(points);
  points.rowwise() -= origin.transpose();
  plane.frame.origin = plane.frame.point(origin);
  const auto chain = sampledChain(points, {.closed = closed, .tolerance_mm = tolerance_mm});
  if (!chain) return std::nullopt;
  const auto lines = std::ranges::count(chain->arcs, 0.0, &PlanarArc::curvature_per_mm);
  if (!hasSparePoints(*chain, points.rows(), lines) || !jumpsVisibly(*chain, tolerance_mm))
    return std::nullopt;
  SampledCurve result{
      .spline = inSpace(bezierSpline(chain->arcs, closed, tolerance_mm), plane.frame),
      .arcs = static_cast<int>(chain->arcs.size()) - static_cast<int>(lines),
      .lines = static_cast<int>(lines),
      .corners = {},
      .parameters = {},
      .distance_mm = chain->distance_mm};
  for (const int corner : chain->corners) {
    const Eigen::Vector2d at = chain->arcs[static_cast<std::size_t>(corner)].start;
    Eigen::Index nearest = 0;
    (points.rowwise() - at.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    result.corners.push_back(nearest + 1);
  }
  result.parameters = parametersOf(*chain, points, result.spline.knots, 2 * tolerance_mm);
  return result;
}

}  // namespace seamwright::cli
