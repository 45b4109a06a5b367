// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <utility>

#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/seam.hpp>
#include <seamwright/occ_adapter/topology/sew_reason.hpp>

/// Replaces two edges that lie along each other by one. Not a public header.
namespace seamwright::occ {

/// Begin and end of an interval of an edge, as parameters in 0..1 over the range of its curve.
using ParameterRange = std::array<double, 2>;

/// Two edges have no common edge.
class NoCommonEdge : public GeometryError {
 public:
  explicit NoCommonEdge(SewReason reason)
      : GeometryError(reason.text), reason_(std::move(reason)) {}
  const SewReason& reason() const { return reason_; }

 private:
  SewReason reason_;
};

/// An edge without vertices, in the frame of the shape. It runs in the direction of the first edge
/// of a matched seam and has a pcurve on both sides.
struct CommonEdge {
  TopoDS_Edge edge;
  opencascade::handle<Geom_Curve> curve;
  double first = 0, last = 0;
  std::vector<EdgeSide> sides;  ///< pcurves over [first, last]
  /// Largest distance between the curve and the images of both pcurves, as measured.
  double tolerance_mm = 0;
};

/// The curve lies halfway between both sides; a curve that both edges share is kept. The first side
/// keeps its pcurve. The second side gets a pcurve whose points correspond to those of the first
/// one: its old path, reparametrised. This is exact where the reparametrisation has constant speed
/// (to a thousandth of \p gap_mm), and otherwise interpolated to the same accuracy.
/// \param ranges ends of the interval on both sides. Those of the second side correspond to those
/// of the first and may decrease.
/// \throws NoCommonEdge where corresponding points of the two sides do not run in the same order;
/// GeometryError where a curve can't be built; Standard_Failure.
CommonEdge commonEdge(const Seam& seam, const std::array<ParameterRange, 2>& ranges, double gap_mm);

}  // namespace seamwright::occ
