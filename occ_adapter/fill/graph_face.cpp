// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <Geom_BSplineSurface.hxx>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <seamwright/core/fill/graph_fill.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/fill/bounded_face.hpp>
#include <seamwright/occ_adapter/fill/fitted_edge.hpp>
#include <seamwright/occ_adapter/fill/graph_face.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using opencascade::handle;

/// The sine of the least angle between the line of sight and the faces around the hole.
constexpr double least_rise = 0.26;

/// Samples of an edge for directions and outlines. A choice: what the fill misses is measured.
constexpr int outline_samples = 64;

/// A direction of sight and a plane across it. Columns are the axes; z points to the viewer, who
/// sees the hole to the left of its edges.
using Sight = Eigen::Matrix3d;

/// The normal of the face beside the hole that points to the viewer.
Vector3d upOf(const SideSample& sample) {
  return sample.beyond.cross(sample.derivative).normalized();
}

using Paths = std::vector<std::shared_ptr<const SidePath>>;

Paths pathsAlong(const Hole& hole, double gap_mm) {
  Paths paths;
  for (const HoleSide& side : hole.sides)
    for (const HoleEdge& edge : side.edges)
      paths.push_back(std::make_shared<const SidePath>(HoleSide{{edge}, edge.length_mm}, gap_mm));
  return paths;
}

/// Samples between the ends, where a face may have no tangent plane.
std::vector<SideSample> outlineOf(const Paths& paths) {
  std::vector<SideSample> samples;
  for (const auto& path : paths)
    for (int k = 0; k < outline_samples; ++k) {
      samples.push_back(path->atParameter((k + 0.5) / outline_samples));
      if (!upOf(samples.back()).allFinite()) samples.pop_back();
    }
  return samples;
}

/// The direction for which the least component of the vectors is largest, nearly.
Vector3d nearestToAll(const std::vector<Vector3d>& directions) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& one : directions) sum += one;
  Vector3d best = sum.normalized(), tried = best;
  const auto rise = [&](const Vector3d& sight) {
    double least = 1;
    for (const Vector3d& one : directions) least = std::min(least, sight.dot(one));
    return least;
  };
  // Badoiu and Clarkson's steps towards the farthest one: the error falls as 1 / step.
  constexpr int steps = 200;
  for (int step = 1; step <= steps; ++step) {
    const Vector3d& farthest = *std::ranges::min_element(
        directions, {}, [&](const Vector3d& one) { return tried.dot(one); });
    tried = (tried + (farthest - tried) / (step + 1)).normalized();
    if (rise(tried) > rise(best)) best = tried;
  }
  return best;
}

/// Turns x and y so that the box of the outline is smallest, with its long side along x.
Sight turned(const Vector3d& z, const std::vector<SideSample>& outline) {
  constexpr int steps = 45;  // of two degrees
  const Vector3d x0 = z.unitOrthogonal(), y0 = z.cross(x0);
  Sight best;
  double least = HUGE_VAL;
  for (int k = 0; k < steps; ++k) {
    const double angle = k * std::numbers::pi / (2 * steps);
    const Vector3d x = std::cos(angle) * x0 + std::sin(angle) * y0, y = z.cross(x);
    Eigen::AlignedBox2d box;
    for (const SideSample& sample : outline)
      box.extend(Vector2d(x.dot(sample.point), y.dot(sample.point)));
    if (box.volume() >= least) continue;
    least = box.volume();
    if (box.sizes().x() >= box.sizes().y())
      best << x, y, z;
    else
      best << y, -x, z;
  }
  return best;
}

bool cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const auto side = [](const Vector2d& p, const Vector2d& q, const Vector2d& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Whether a polygon runs once around its inside, to the left.
bool isOutline(const std::vector<Vector2d>& polygon) {
  const std::size_t n = polygon.size();
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % n];
    area += a.x() * b.y() - a.y() * b.x();
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && cross(a, b, polygon[j], polygon[(j + 1) % n])) return false;
  }
  return area > 0;
}

std::optional<Sight> sightOf(const std::vector<SideSample>& outline) {
  if (outline.size() < 3) return std::nullopt;
  std::vector<Vector3d> ups;
  for (const SideSample& sample : outline) ups.push_back(upOf(sample));
  const Vector3d z = nearestToAll(ups);
  if (!std::ranges::all_of(ups, [&](const Vector3d& up) { return z.dot(up) > least_rise; }))
    return std::nullopt;
  const Sight sight = turned(z, outline);
  std::vector<Vector2d> polygon;
  for (const SideSample& sample : outline)
    polygon.emplace_back((sight.transpose() * sample.point).head<2>());
  return isOutline(polygon) ? std::optional(sight) : std::nullopt;
}

/// The second derivative of the height along a direction of the plane.
double bendOf(const SideSample& sample, const Sight& sight, const Vector3d& up,
              const Vector2d& direction) {
  const Eigen::Matrix<double, 3, 2> xy = sight.leftCols<2>();
  Eigen::Matrix2d plane;
  plane << xy.transpose() * sample.jet.u, xy.transpose() * sample.jet.v;
  const Vector2d c = plane.inverse() * direction;
  const Vector3d bend =
      c(0) * c(0) * sample.jet.uu + 2 * c(0) * c(1) * sample.jet.uv + c(1) * c(1) * sample.jet.vv;
  return up.dot(bend) / up.dot(sight.col(2));
}

GraphSample graphSample(const SideSample& sample, const Sight& sight) {
  const Vector3d at = sight.transpose() * sample.point;
  const Vector3d up = upOf(sample), seen = sight.transpose() * up;
  const Vector2d along = (sight.transpose() * sample.derivative).head<2>().normalized();
  GraphSample result{.at = at.head<2>(),
                     .height_mm = at.z(),
                     .slope = -seen.head<2>() / seen.z(),
                     .across = Vector2d(along.y(), -along.x()),
                     .speed_mm = sample.derivative.norm()};
  result.bend_per_mm = bendOf(sample, sight, up, result.across);
  return result;
}

GraphBoundary boundaryAlong(const std::shared_ptr<const SidePath>& path, const Sight& sight) {
  return [path, sight](double t) { return graphSample(path->atParameter(t), sight); };
}

/// A sight whose x and y are turned as joints of the edges need it.
std::optional<Sight> bestSightOf(const Paths& paths) {
  const std::optional<Sight> sight = sightOf(outlineOf(paths));
  if (!sight) return std::nullopt;
  std::vector<GraphBoundary> boundary;
  for (const auto& path : paths) boundary.push_back(boundaryAlong(path, *sight));
  const double turn_rad = graphTurn_rad(boundary).value_or(0);
  return Sight(*sight * Eigen::AngleAxisd(turn_rad, Vector3d::UnitZ()));
}

handle<Geom_Surface> placed(BSplineSurface surface, const Sight& sight) {
  for (Eigen::Index k = 0; k < surface.poles.rows(); ++k)
    surface.poles.row(k).head<3>() =
        (sight * surface.poles.row(k).head<3>().transpose()).transpose().eval();
  return geomSurface(surface);
}

}  // namespace

std::optional<TopoDS_Face> graphFace(const FillTask& task, const Progress& progress) {
  const ContinuityTolerance& tolerance = task.options.tolerance;
  const double gap_mm = tolerance.gap_mm / fit_share;
  const Paths paths = pathsAlong(task.hole, gap_mm);
  const std::optional<Sight> sight = bestSightOf(paths);
  if (!sight) return std::nullopt;
  std::vector<GraphBoundary> boundary;
  std::vector<BoundaryEdge> edges;
  std::size_t k = 0;
  for (const HoleSide& side : task.hole.sides)
    for (const HoleEdge& hole_edge : side.edges) {
      const std::shared_ptr<const SidePath>& path = paths[k++];
      boundary.push_back(boundaryAlong(path, *sight));
      std::optional<BoundaryEdge> edge = fittedEdge(
          hole_edge, *path,
          [&](double parameter) -> Vector2d {
            return (sight->transpose() * path->atParameter(parameter).point).head<2>();
          },
          gap_mm / fit_share, gap_mm);
      if (!edge) return std::nullopt;
      edges.push_back(*edge);
    }
  const GraphFill fill =
      graphFill(boundary,
                {.gap_mm = tolerance.gap_mm,
                 .angle_rad = task.options.target == Level::G0 ? 0 : tolerance.angle_rad},
                progress);
  return boundedFace(placed(fill.surface, *sight), edges, true).face;
}

}  // namespace seamwright::occ
