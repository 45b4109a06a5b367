// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/repair/surface_basis.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// Places along a path in the parameter plane of a spline surface; not a public header.
namespace seamwright::occ {

/// Places that are even in what a path crosses: knot spans, each as often as its direction's weight
/// says.
class SpanMeasure {
 public:
  SpanMeasure(const Pcurve& path, const SurfaceBasis& basis,
              const opencascade::handle<Geom_BSplineSurface>& surface,
              const Eigen::Vector2d& weights);

  /// Spans, by weight.
  double crossed() const { return crossed_.back(); }
  /// The place, 0..1, up to which that share of all is crossed.
  double at(double share) const;

 private:
  std::vector<double> s_, crossed_;
};

}  // namespace seamwright::occ
