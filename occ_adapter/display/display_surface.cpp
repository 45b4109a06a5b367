// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopLoc_Location.hxx>
#include <cmath>
#include <limits>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/display/display_surface.hpp>

namespace seamwright::occ {

namespace {

/// The steps away from a pole, as a share of the parameter range. The normal loses 1e-16 / 1e-5 by
/// rounding there, the curvature 1e-16 / 1e-10.
constexpr double pole_step = 1e-5;
/// A step across the whole range shorter than this share of the other one, or so nearly along it,
/// defines no direction.
constexpr double collapsed_share = 1e-10;
/// Curvatures that grow by this share within one step towards a pole have no limit there: those of
/// a smooth pole differ by about the step, 1e-5, and those of a tip double.
constexpr double bounded_growth = 1e-2;

}  // namespace

DisplaySurface::DisplaySurface(const TopoDS_Face& face)
    : sign_(face.Orientation() == TopAbs_REVERSED ? -1 : 1) {
  TopLoc_Location location;
  surface_.Load(BRep_Tool::Surface(face, location));
  location_ = location.Transformation();
  scale_ = std::abs(location_.ScaleFactor());
}

void DisplaySurface::setRange(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  middle_ = 0.5 * (low + high);
  range_ = high - low;
  for (double& range : range_)
    if (!(range > 0)) range = 1;
}

DisplaySurface::Sample DisplaySurface::at(const Eigen::Vector2d& uv) const {
  gp_Pnt p;
  gp_Vec du, dv;
  surface_.D1(uv.x(), uv.y(), p, du, dv);
  Sample sample{vector(p.Transformed(location_)), Eigen::Vector3d::Zero()};
  std::optional<Eigen::Vector3d> normal = normalOf(vector(du), vector(dv));
  if (!normal) {
    if (const std::optional<Eigen::Vector2d> step = stepOffPole(uv)) {
      const std::optional<Eigen::Vector3d> near = normalAt(uv + *step),
                                           far = normalAt(uv + 2 * *step);
      if (near && far) normal = (2 * *near - *far).normalized();
    }
  }
  if (normal) sample.normal = inSpace(*normal);
  return sample;
}

Eigen::Vector3d DisplaySurface::pointAt(const Eigen::Vector2d& uv) const {
  return vector(surface_.Value(uv.x(), uv.y()).Transformed(location_).XYZ());
}

NodeCurvature DisplaySurface::curvatureAt(const Eigen::Vector2d& uv) const {
  if (const std::optional<NodeCurvature> curvature = regularCurvature(uv)) return *curvature;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::optional<Eigen::Vector2d> step = stepOffPole(uv);
  if (!step) return {nan, nan};
  const std::optional<NodeCurvature> near = regularCurvature(uv + *step);
  const std::optional<NodeCurvature> far = regularCurvature(uv + 2 * *step);
  if (!near || !far) return {nan, nan};
  const double size = std::max(std::abs(near->k1), std::abs(near->k2));
  if (std::max(std::abs(near->k1 - far->k1), std::abs(near->k2 - far->k2)) > bounded_growth * size)
    return {nan, nan};
  return {2 * near->k1 - far->k1, 2 * near->k2 - far->k2};
}

/// In the coordinates of the surface, without the sign of the face; nothing where it collapses.
std::optional<Eigen::Vector3d> DisplaySurface::normalOf(const Eigen::Vector3d& du,
                                                        const Eigen::Vector3d& dv) const {
  const Eigen::Vector3d across = du.cross(dv);
  const double longest = std::max(range_.x() * du.norm(), range_.y() * dv.norm());
  const double length = across.norm();
  if (!(range_.x() * range_.y() * length > collapsed_share * longest * longest))
    return std::nullopt;
  return across / length;
}

std::optional<Eigen::Vector3d> DisplaySurface::normalAt(const Eigen::Vector2d& uv) const {
  gp_Pnt p;
  gp_Vec du, dv;
  surface_.D1(uv.x(), uv.y(), p, du, dv);
  return normalOf(vector(du), vector(dv));
}

std::optional<NodeCurvature> DisplaySurface::regularCurvature(const Eigen::Vector2d& uv) const {
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv;
  surface_.D2(uv.x(), uv.y(), p, du, dv, duu, dvv, duv);
  SurfaceJet jet;
  jet.u = vector(du), jet.v = vector(dv);
  jet.uu = vector(duu), jet.uv = vector(duv), jet.vv = vector(dvv);
  const std::optional<Eigen::Vector3d> normal = normalOf(jet.u, jet.v);
  if (!normal) return std::nullopt;
  const PrincipalCurvatures found = principalCurvatures(jet, sign_ * *normal);
  return NodeCurvature{found.k1 / scale_, found.k2 / scale_};
}

/// A step towards the inside of the face to where the surface has a normal: across the boundary
/// that collapses, so that the normals around the tip of a cone stay apart.
std::optional<Eigen::Vector2d> DisplaySurface::stepOffPole(const Eigen::Vector2d& uv) const {
  const Eigen::Vector2d inward =
      pole_step * range_.cwiseProduct(Eigen::Vector2d(uv.x() > middle_.x() ? -1 : 1,
                                                      uv.y() > middle_.y() ? -1 : 1));
  for (const Eigen::Vector2d& step :
       {Eigen::Vector2d(0, inward.y()), Eigen::Vector2d(inward.x(), 0), inward})
    if (normalAt(uv + step)) return step;
  return std::nullopt;
}

Eigen::Vector3d DisplaySurface::inSpace(const Eigen::Vector3d& local_normal) const {
  const gp_Vec turned =
      gp_Vec(local_normal.x(), local_normal.y(), local_normal.z()).Transformed(location_);
  return sign_ * vector(turned).normalized();
}

}  // namespace seamwright::occ
