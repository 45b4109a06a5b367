// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <GeomAdaptor_Surface.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_BSplineSurfaceToBezierSurface.hxx>
#include <GeomProjLib.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_Curve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <seamwright/core/fill/regular.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/bounded_face.hpp>
#include <seamwright/occ_adapter/fill/continued_face.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using opencascade::handle;

/// An edge of the hole, with samples along it in the direction of the hole.
struct EdgeInterval {
  HoleEdge edge;
  std::vector<SideSample> samples;
};

std::vector<EdgeInterval> intervalsOf(const Hole& hole, double gap_mm) {
  // Samples of an edge. A choice: the proof of the seams measures what lies between them.
  constexpr int count = 64;
  std::vector<EdgeInterval> intervals;
  for (const HoleSide& side : hole.sides)
    for (const HoleEdge& edge : side.edges) {
      const SidePath path({{edge}, edge.length_mm}, gap_mm);
      EdgeInterval& interval = intervals.emplace_back(EdgeInterval{edge, {}});
      for (int k = 0; k <= count; ++k)
        interval.samples.push_back(path.atParameter(static_cast<double>(k) / count));
    }
  return intervals;
}

/// Twice the signed area of a closed polygon, positive if the inside is to its left.
double signedArea(const std::vector<Vector2d>& polygon) {
  double area = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector2d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

/// The smallest box of parameters around the hole.
struct Range {
  Vector2d low, high;
};

bool isRegular(const handle<Geom_Surface>& surface, const Range& at) {
  if (surface->IsKind(STANDARD_TYPE(Geom_Plane)) ||
      surface->IsKind(STANDARD_TYPE(Geom_CylindricalSurface)))
    return true;
  if (surface->IsKind(STANDARD_TYPE(Geom_SphericalSurface)))
    return std::max(-at.low.y(), at.high.y()) < std::numbers::pi / 2 - Precision::Angular();
  if (const auto cone = handle<Geom_ConicalSurface>::DownCast(surface); !cone.IsNull()) {
    const auto radiusAt = [&cone](double v) {
      return cone->RefRadius() + v * std::sin(cone->SemiAngle());
    };
    return radiusAt(at.low.y()) * radiusAt(at.high.y()) > 0;
  }
  if (const auto torus = handle<Geom_ToroidalSurface>::DownCast(surface); !torus.IsNull())
    return torus->MajorRadius() > torus->MinorRadius();
  const handle<Geom_BSplineSurface> spline =
      GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(
          surface, at.low.x(), at.high.x(), at.low.y(), at.high.y()));
  if (spline->Continuity() < GeomAbs_C1) return false;
  GeomConvert_BSplineSurfaceToBezierSurface pieces(spline);
  for (int i = 1; i <= pieces.NbUPatches(); ++i)
    for (int j = 1; j <= pieces.NbVPatches(); ++j)
      if (!provedRegular(bezierPatch(*pieces.Patch(i, j)))) return false;
  return true;
}

/// The least squares plane through the hole.
handle<Geom_Surface> planeOf(const std::vector<EdgeInterval>& intervals, const Vector3d& centre) {
  std::vector<Vector3d> points;
  for (const EdgeInterval& interval : intervals)
    for (const SideSample& sample : interval.samples) points.push_back(sample.point - centre);
  const Eigen::Map<const Eigen::Matrix3Xd> all(points.front().data(), 3,
                                               static_cast<Eigen::Index>(points.size()));
  const Eigen::JacobiSVD<Eigen::Matrix3Xd> axes(all, Eigen::ComputeFullU);
  return new Geom_Plane(pointOf(centre), directionOf(axes.matrixU().col(2)));
}

/// A copy of the face's surface, with the location applied. A sphere is rotated so that the hole is
/// far from its poles.
handle<Geom_Surface> copyOf(const TopoDS_Face& face, const Vector3d& centre) {
  const handle<Geom_Surface> surface =
      handle<Geom_Surface>::DownCast(BRep_Tool::Surface(face)->Copy());
  if (const auto sphere = handle<Geom_SphericalSurface>::DownCast(surface); !sphere.IsNull()) {
    const Vector3d towards = centre - vector(sphere->Location());
    if (towards.norm() > Precision::Confusion())
      return new Geom_SphericalSurface(
          gp_Ax3(sphere->Location(), directionOf(towards.unitOrthogonal()), directionOf(towards)),
          sphere->Radius());
  }
  return surface;
}

/// Makes one face on one surface.
class FaceMaker {
 public:
  FaceMaker(const std::vector<EdgeInterval>& intervals, handle<Geom_Surface> surface,
            bool own_paths)
      : intervals_(intervals), surface_(std::move(surface)), own_paths_(own_paths) {}

  bool isNear(double gap_mm, const std::optional<double>& angle_rad) const {
    ShapeAnalysis_Surface nearest(surface_);
    for (const EdgeInterval& interval : intervals_)
      for (const SideSample& sample : interval.samples) {
        const gp_Pnt point = pointOf(sample.point);
        const gp_Pnt2d at = nearest.ValueOfUV(point, Precision::Confusion());
        if (nearest.Value(at).Distance(point) > gap_mm) return false;
        if (angle_rad && normalAt(at).cross(sample.normal).norm() > std::sin(*angle_rad))
          return false;
      }
    return true;
  }

  std::optional<TopoDS_Face> run(double gap_mm) {
    if (!makePaths() || !closePaths(gap_mm) || !boundsTheHole() || !isRegular(surface_, range()))
      return std::nullopt;
    const BoundedFace made = boundedFace(surface_, paths_, is_left_);
    return made.tolerance_mm > gap_mm ? std::nullopt : std::optional(made.face);
  }

 private:
  /// Unit normal of the surface.
  Vector3d normalAt(const gp_Pnt2d& at) const {
    gp_Pnt point;
    gp_Vec u, v;
    surface_->D1(at.X(), at.Y(), point, u, v);
    return vector(u).cross(vector(v)).normalized();
  }

  bool makePaths() {
    for (const EdgeInterval& interval : intervals_) {
      const std::optional<BoundaryEdge> edge = boundaryEdge(interval.edge);
      if (!edge) return false;
      BoundaryEdge& path = paths_.emplace_back(*edge);
      if (own_paths_) {
        path.on_surface = BRep_Tool::CurveOnSurface(interval.edge.use.edge, interval.edge.use.shape,
                                                    path.first, path.last);
        if (!path.on_surface.IsNull())
          path.on_surface = handle<Geom2d_Curve>::DownCast(path.on_surface->Copy());
      } else {
        double tolerance = Precision::Confusion();
        path.on_surface =
            GeomProjLib::Curve2d(BRep_Tool::Curve(interval.edge.use.edge, path.first, path.last),
                                 path.first, path.last, surface_, tolerance);
      }
      if (path.on_surface.IsNull()) return false;
    }
    return true;
  }

  /// The parameters at a share of edge k, in the direction of the hole.
  gp_Pnt2d at(std::size_t k, double share) const {
    const BoundaryEdge& path = paths_[k];
    const double parameter = intervals_[k].edge.reversed ? 1 - share : share;
    return path.on_surface->Value(path.first + parameter * (path.last - path.first));
  }

  /// Moves pcurves by whole periods until each begins where the one before it ends. Returns false
  /// if one can't.
  bool closePaths(double gap_mm) {
    const GeomAdaptor_Surface adaptor(surface_);
    const Vector2d period(adaptor.IsUPeriodic() ? adaptor.UPeriod() : 0,
                          adaptor.IsVPeriodic() ? adaptor.VPeriod() : 0);
    const auto wholePeriods = [&period](const gp_Pnt2d& from, const gp_Pnt2d& to) {
      const auto whole = [](double distance, double one) {
        return one > 0 ? one * std::round(distance / one) : 0;
      };
      return gp_Vec2d(whole(to.X() - from.X(), period.x()), whole(to.Y() - from.Y(), period.y()));
    };
    for (std::size_t k = 1; k < paths_.size(); ++k)
      paths_[k].on_surface->Translate(wholePeriods(at(k, 0), at(k - 1, 1)));
    const auto meet = [&](const gp_Pnt2d& one, const gp_Pnt2d& other) {
      return std::abs(one.X() - other.X()) <= adaptor.UResolution(2 * gap_mm) &&
             std::abs(one.Y() - other.Y()) <= adaptor.VResolution(2 * gap_mm);
    };
    for (std::size_t k = 0; k < paths_.size(); ++k)
      if (!meet(at(k, 1), at((k + 1) % paths_.size(), 0))) return false;
    return true;
  }

  Range range() const {
    Range found{Vector2d::Constant(HUGE_VAL), Vector2d::Constant(-HUGE_VAL)};
    for (const Vector2d& corner : polygon_) {
      found.low = found.low.cwiseMin(corner);
      found.high = found.high.cwiseMax(corner);
    }
    return found;
  }

  /// Whether the faces beside the hole lie outside of the loop, as far as they continue in the
  /// surface.
  bool boundsTheHole() {
    for (std::size_t k = 0; k < paths_.size(); ++k)
      for (std::size_t i = 0; i + 1 < intervals_[k].samples.size(); ++i) {
        const gp_Pnt2d uv =
            at(k, static_cast<double>(i) / static_cast<double>(intervals_[k].samples.size() - 1));
        polygon_.emplace_back(uv.X(), uv.Y());
      }
    const double area = signedArea(polygon_);
    is_left_ = area > 0;
    constexpr double least_slope = 1e-3;  // least tangential part of the direction into a face that
                                          // is beside the hole and not above or below it
    for (std::size_t k = 0; k < paths_.size(); ++k)
      for (std::size_t i = 1; i + 1 < intervals_[k].samples.size(); ++i) {
        const SideSample& sample = intervals_[k].samples[i];
        const double share =
            static_cast<double>(i) / static_cast<double>(intervals_[k].samples.size() - 1);
        const Vector3d into =
            (is_left_ ? 1 : -1) * normalAt(at(k, share)).cross(sample.derivative.normalized());
        if (into.dot(sample.beyond) > 1 - least_slope) return false;
      }
    return area != 0;
  }

  const std::vector<EdgeInterval>& intervals_;
  handle<Geom_Surface> surface_;
  bool own_paths_;
  std::vector<BoundaryEdge> paths_;  ///< by edge
  std::vector<Vector2d> polygon_;
  bool is_left_ = true;  ///< on the surface the hole is to the left of the loop
};

bool haveOneSurface(const std::vector<EdgeInterval>& intervals) {
  const TopoDS_Face& first = intervals.front().edge.use.shape;
  TopLoc_Location here, there;
  const handle<Geom_Surface>& surface = BRep_Tool::Surface(first, here);
  return std::ranges::all_of(intervals, [&](const EdgeInterval& interval) {
    return BRep_Tool::Surface(interval.edge.use.shape, there) == surface && here == there;
  });
}

}  // namespace

std::optional<TopoDS_Face> continuedFace(const Hole& hole, double gap_mm,
                                         std::optional<double> angle_rad) {
  const std::vector<EdgeInterval> intervals = intervalsOf(hole, gap_mm);
  const auto tried = [&](const handle<Geom_Surface>& surface,
                         bool own_paths) -> std::optional<TopoDS_Face> {
    FaceMaker maker(intervals, surface, own_paths);
    return own_paths || maker.isNear(gap_mm, angle_rad) ? maker.run(gap_mm) : std::nullopt;
  };
  if (haveOneSurface(intervals)) {
    const TopoDS_Face& face = intervals.front().edge.use.shape;
    const handle<Geom_Surface> own =
        handle<Geom_Surface>::DownCast(BRep_Tool::Surface(face)->Copy());
    if (const auto made = tried(own, true)) return made;
  }
  if (const auto made = tried(planeOf(intervals, hole.centre), false)) return made;
  int before = 0;
  for (const EdgeInterval& interval : intervals) {
    const Coedge& use = interval.edge.use;
    if (use.face == before ||
        !BRep_Tool::Surface(use.shape)->IsKind(STANDARD_TYPE(Geom_ElementarySurface)))
      continue;
    before = use.face;
    if (const auto made = tried(copyOf(use.shape, hole.centre), false)) return made;
  }
  return std::nullopt;
}

}  // namespace seamwright::occ
