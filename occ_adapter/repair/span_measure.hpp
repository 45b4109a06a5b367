// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/repair/surface_basis.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// Distributes parameters along a pcurve on a spline surface. Not a public header.
namespace seamwright::occ {

/// Measures a pcurve by the knot spans that it crosses. A span counts with the weight of its
/// direction.
class SpanMeasure {
 public:
  SpanMeasure(const Pcurve& path, const SurfaceBasis& basis,
              const opencascade::handle<Geom_BSplineSurface>& surface,
              const Eigen::Vector2d& weights);

  /// Weighted number of spans that the whole pcurve crosses.
  double crossed() const { return crossed_.back(); }
  /// The parameter in 0..1 up to which that share of the spans is crossed.
  double at(double share) const;

 private:
  std::vector<double> s_, crossed_;
};

}  // namespace seamwright::occ
