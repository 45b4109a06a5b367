// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <algorithm>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/repair/span_measure.hpp>

namespace seamwright::occ {

namespace {

Eigen::Vector2d pointAt(const Pcurve& path, double s) {
  const gp_Pnt2d p = path.curve->Value(path.first + s * (path.last - path.first));
  return {p.X(), p.Y()};
}

/// Parameters at which a pcurve crosses knot lines, with 0 and 1.
std::vector<double> breaksOf(const Pcurve& path,
                             const opencascade::handle<Geom_BSplineSurface>& surface) {
  Coedge use;
  const BRep_Builder builder;
  builder.MakeFace(use.shape, surface, Precision::Confusion());
  builder.MakeEdge(use.edge);
  std::vector<double> at = FaceStrip(use, path).breaks();
  at.push_back(0);
  at.push_back(1);
  std::ranges::sort(at);
  std::erase_if(at, [](double s) { return s < 0 || s > 1; });
  return at;
}

}  // namespace

SpanMeasure::SpanMeasure(const Pcurve& path, const SurfaceBasis& basis,
                         const opencascade::handle<Geom_BSplineSurface>& surface,
                         const Eigen::Vector2d& weights)
    : s_(breaksOf(path, surface)), crossed_{0} {
  // Chords of a pcurve in one span: a smooth curve turns little there.
  constexpr int steps = 4;
  for (std::size_t i = 1; i < s_.size(); ++i) {
    const Eigen::Vector2d middle = pointAt(path, (s_[i - 1] + s_[i]) / 2);
    const Eigen::Vector2d span(spanLength(basis.u(), middle[0]), spanLength(basis.v(), middle[1]));
    double crossed = 0;
    Eigen::Vector2d from = pointAt(path, s_[i - 1]);
    for (int k = 1; k <= steps; ++k) {
      const Eigen::Vector2d to = pointAt(path, s_[i - 1] + (s_[i] - s_[i - 1]) * k / steps);
      const Eigen::Vector2d spans = (to - from).cwiseQuotient(span).cwiseAbs();
      crossed += spans.cwiseProduct(weights).maxCoeff();
      from = to;
    }
    crossed_.push_back(crossed_.back() + crossed);
  }
}

double SpanMeasure::at(double share) const {
  const double wanted = share * crossed_.back();
  const std::size_t i = std::clamp<std::size_t>(
      std::ranges::lower_bound(crossed_, wanted) - crossed_.begin(), 1, crossed_.size() - 1);
  const double width = crossed_[i] - crossed_[i - 1];
  const double within = width > 0 ? (wanted - crossed_[i - 1]) / width : 0;
  return share >= 1 ? 1 : s_[i - 1] + within * (s_[i] - s_[i - 1]);
}

}  // namespace seamwright::occ
