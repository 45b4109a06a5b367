// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/differential/arc_length.hpp>
#include <seamwright/occ_adapter/blend/lateral_curve.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

using Eigen::Vector3d;

LateralCurve::LateralCurve(const EdgeChain& chain, bool backwards) {
  std::vector<ChainedEdge> edges = chain.edges;
  if (backwards) std::ranges::reverse(edges);
  for (const ChainedEdge& edge : edges) addPiece(edge, backwards);
  if (!(length_mm_ > 0 && std::isfinite(length_mm_)))
    throw GeometryError(fmt::format("edge {} has no length", edges.front().edge.number));
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (i > 0) breaks_.push_back({begins_mm_[i] / length_mm_, 0});
    addBreaks(pieces_[i], begins_mm_[i]);
  }
  judgeKinks();
}

void LateralCurve::addPiece(const ChainedEdge& edge, bool backwards) {
  const SpaceEdge& of = edge.edge;
  const bool forward = edge.forward != backwards;
  const double first = forward ? of.first : of.last, last = forward ? of.last : of.first;
  const GeomAdaptor_Curve curve(of.curve, of.first, of.last);
  const auto speed_mm = [&](double share) {
    gp_Pnt point;
    gp_Vec derivative;
    curve.D1(first + share * (last - first), point, derivative);
    return std::abs(last - first) * derivative.Magnitude();
  };
  TColStd_Array1OfReal at(1, curve.NbIntervals(GeomAbs_CN) + 1);
  curve.Intervals(at, GeomAbs_CN);
  std::vector<double> breaks;
  for (const double parameter : at) breaks.push_back((parameter - first) / (last - first));
  pieces_.push_back({of.number, curve, first, last, PathLength(speed_mm, breaks)});
  begins_mm_.push_back(length_mm_);
  length_mm_ += pieces_.back().length.length_mm();
}

void LateralCurve::addBreaks(const Piece& piece, double begin_mm) {
  std::vector<CurveBreak> found;
  // What is C3 by its parameter is so by arc length.
  for (const auto& [continuity, smoothness] :
       {std::pair(GeomAbs_C1, 0), std::pair(GeomAbs_C2, 1), std::pair(GeomAbs_C3, 2)}) {
    TColStd_Array1OfReal at(1, piece.curve.NbIntervals(continuity) + 1);
    piece.curve.Intervals(at, continuity);
    for (int i = at.Lower() + 1; i < at.Upper(); ++i) {
      const double along = (at(i) - piece.first) / (piece.last - piece.first);
      const double share = (begin_mm + piece.length.lengthTo(along)) / length_mm_;
      constexpr double same = 1e-9;
      if (std::ranges::none_of(found, [&, share = share](const CurveBreak& other) {
            return std::abs(other.share - share) < same;
          }))
        found.push_back({share, smoothness});
    }
  }
  std::ranges::sort(found, {}, &CurveBreak::share);
  breaks_.insert(breaks_.end(), found.begin(), found.end());
}

void LateralCurve::judgeKinks() {
  // As along a side. What turns less than the second is a tangent joint: rounding of files.
  constexpr double most_kink_rad = 1 * radians_per_degree, no_kink_rad = 1e-5;
  constexpr double beside = 1e-7;  // of the length, as along a side
  for (CurveBreak& there : breaks_) {
    const Vector3d point = at(there.share), before = point - at(there.share - beside),
                   after = at(there.share + beside) - point;
    const double kink_rad = std::atan2(before.cross(after).norm(), before.dot(after));
    if (!(kink_rad <= most_kink_rad))
      throw std::invalid_argument(
          fmt::format("it has a corner of angle_rad = {:.3g} ({:.3g} degrees) at ({:.6g})",
                      kink_rad, kink_rad / radians_per_degree, fmt::join(point, ", ")));
    if (kink_rad <= no_kink_rad) there.smoothness = std::max(there.smoothness, 1);
  }
}

Vector3d LateralCurve::at(double share) const {
  const double at_mm = std::clamp(share, 0.0, 1.0) * length_mm_;
  std::size_t i = 0;
  while (i + 1 < begins_mm_.size() && at_mm >= begins_mm_[i + 1]) ++i;
  const Piece& piece = pieces_[i];
  const double rest_mm = std::clamp(at_mm - begins_mm_[i], 0.0, piece.length.length_mm());
  return vector(piece.curve.Value(piece.parameterAt(piece.length.parameterAt(rest_mm))));
}

CurveDerivatives LateralCurve::atEnd(int end) const {
  const Piece& piece = end == 0 ? pieces_.front() : pieces_.back();
  gp_Pnt point;
  gp_Vec first, second, third;
  piece.curve.D3(end == 0 ? piece.first : piece.last, point, first, second, third);
  const double sense = piece.last > piece.first ? 1 : -1;
  CurveDerivatives rows(4, 3);
  rows << vector(point).transpose(), sense * vector(first).transpose(), vector(second).transpose(),
      sense * vector(third).transpose();
  const std::optional<CurveDerivatives> by_length = arcLengthDerivatives(rows);
  if (!by_length)
    throw GeometryError(fmt::format("edge {} stands still at ({:.6g})", piece.number,
                                    fmt::join(vector(point), ", ")));
  return *by_length;
}

}  // namespace seamwright::occ
