// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <algorithm>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/repair/path_place.hpp>

namespace seamwright::occ {

Eigen::Vector2d PlanePath::at(double s) const {
  const gp_Pnt2d p = path_.path.curve->Value(parameter(s));
  return {p.X(), p.Y()};
}

Place PlanePath::place(const SurfaceBasis& basis, double s) const {
  gp_Pnt2d p;
  gp_Vec2d d;
  path_.path.curve->D1(parameter(s), p, d);
  Place place;
  place.s = s;
  place.uv = {p.X(), p.Y()};
  place.along = (path_.path.last - path_.path.first) * Eigen::Vector2d(d.X(), d.Y());
  const Eigen::Vector2d left(-place.along.y(), place.along.x());
  place.shares =
      basis.at(place.uv, path_.face_on_left ? left : Eigen::Vector2d(-left), path_.order < 2 ? 1 : 2);
  place.target = path_.target(s);
  place.order = place.target.normal.isZero() ? 0 : path_.order;
  return place;
}

std::vector<double> PlanePath::breaks(const opencascade::handle<Geom_BSplineSurface>& surface) const {
  FaceUse use;
  const BRep_Builder builder;
  builder.MakeFace(use.shape, surface, Precision::Confusion());
  builder.MakeEdge(use.edge);
  std::vector<double> at = FaceStrip(use, path_.path).breaks();
  at.push_back(0);
  at.push_back(1);
  std::ranges::sort(at);
  std::erase_if(at, [](double s) { return s < 0 || s > 1; });
  return at;
}

SpanMeasure::SpanMeasure(const PlanePath& path, const SurfaceBasis& basis,
                         const opencascade::handle<Geom_BSplineSurface>& surface,
                         const Eigen::Vector2d& weights)
    : s_(path.breaks(surface)), crossed_{0} {
  constexpr int steps = 4;
  for (std::size_t i = 1; i < s_.size(); ++i) {
    const Eigen::Vector2d middle = path.at((s_[i - 1] + s_[i]) / 2);
    const Eigen::Vector2d span(spanLength(basis.u(), middle[0]), spanLength(basis.v(), middle[1]));
    double crossed = 0;
    Eigen::Vector2d from = path.at(s_[i - 1]);
    for (int k = 1; k <= steps; ++k) {
      const Eigen::Vector2d to = path.at(s_[i - 1] + (s_[i] - s_[i - 1]) * k / steps);
      const Eigen::Vector2d spans = (to - from).cwiseQuotient(span).cwiseAbs();
      spans_ += spans.maxCoeff();
      crossed += spans.cwiseProduct(weights).maxCoeff();
      from = to;
    }
    crossed_.push_back(crossed_.back() + crossed);
  }
}

double SpanMeasure::at(double share) const {
  const double wanted = share * crossed_.back();
  const std::size_t i = std::clamp<std::size_t>(std::ranges::lower_bound(crossed_, wanted) - crossed_.begin(),
                                                1, crossed_.size() - 1);
  const double width = crossed_[i] - crossed_[i - 1];
  const double within = width > 0 ? (wanted - crossed_[i - 1]) / width : 0;
  return share >= 1 ? 1 : s_[i - 1] + within * (s_[i] - s_[i - 1]);
}

std::array<double, 2> spansAtEnds(const FaceUse& side, const Pcurve& path) {
  TopLoc_Location location;
  const auto surface = clampedSpline(BRep_Tool::Surface(side.shape, location));
  if (surface.IsNull()) return {0, 0};
  FollowPath along;
  along.path = path;
  const SpanMeasure measure(PlanePath(along), SurfaceBasis(*surface), surface);
  if (measure.spans() == 0) return {0, 0};
  const double spans = std::min(3.0, measure.spans()), share = spans / measure.spans();
  return {measure.at(share) / spans, (1 - measure.at(1 - share)) / spans};
}

}  // namespace seamwright::occ
