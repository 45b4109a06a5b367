// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include <seamwright/occ_adapter/repair/face_follow.hpp>
#include <seamwright/occ_adapter/repair/surface_basis.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// Places along a path in the parameter plane of a spline surface; not a public header.
namespace seamwright::occ {

/// A place of a path, and what it has to meet there.
struct Place {
  double s = 0;
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< derivative of uv by s
  PoleShares shares;                                ///< second derivatives for a path of order 2 alone
  TargetPoint target;
  Eigen::Vector3d turn =
      Eigen::Vector3d::Zero();  ///< along the targets' way: by what angle their normal turns, 1 / mm
  int order = 0;                ///< that of the path, or 0 where the target has no normal
};

/// A plane curve over s in [0, 1]. The path must outlive it.
class PlanePath {
 public:
  explicit PlanePath(const FollowPath& path) : path_(path) {}

  Eigen::Vector2d at(double s) const;
  Place place(const SurfaceBasis& basis, double s) const;
  /// Where it crosses knots, with 0 and 1.
  std::vector<double> breaks(const opencascade::handle<Geom_BSplineSurface>& surface) const;

 private:
  double parameter(double s) const { return path_.path.first + s * (path_.path.last - path_.path.first); }

  const FollowPath& path_;
};

/// Places that are even in what a path crosses: knot spans, each as often as its direction's weight says.
class SpanMeasure {
 public:
  SpanMeasure(const PlanePath& path, const SurfaceBasis& basis,
              const opencascade::handle<Geom_BSplineSurface>& surface,
              const Eigen::Vector2d& weights = Eigen::Vector2d::Ones());

  /// Without weights.
  double spans() const { return spans_; }
  double crossed() const { return crossed_.back(); }
  /// The place up to which that share of all is crossed.
  double at(double share) const;

 private:
  std::vector<double> s_, crossed_;
  double spans_ = 0;
};

/// By end of a path: the share of it over which it crosses one knot span, in the mean of the three nearest that end; 0: the face is no spline.
std::array<double, 2> spansAtEnds(const FaceUse& side, const Pcurve& path);

}  // namespace seamwright::occ
