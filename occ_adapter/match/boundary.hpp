// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/match/match.hpp>
#include <seamwright/occ_adapter/match/match_reason.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// The common boundary of two faces, and the sides of both there. Not a public header.
namespace seamwright::occ {

struct CommonBoundary {
  std::optional<Seam> seam;  ///< faces are 1 and 2, edges have their numbers in the model
  MatchReason failure;       ///< why there is no seam
  MatchReason remark;        ///< which of several it is
};

/// The two faces as a compound.
TopoDS_Shape pairOf(const std::array<TopoDS_Face, 2>& faces);

/// The common boundary that the options name, or the longest one.
/// \throws std::invalid_argument if options.edge is not a common edge; Cancelled.
CommonBoundary commonBoundary(const TopoDS_Shape& model, const std::array<TopoDS_Face, 2>& faces,
                              const FaceMatchOptions& options, const Progress& progress);

/// Why an edge of a matched seam is not near the other one over its whole length; empty if it is.
/// At each end, four times the larger of the matching distance and the gap tolerance may be
/// missing.
MatchReason whyApart(const Seam& seam, const FaceMatchOptions& options);

/// A face beside the common boundary.
struct MatchSide {
  TopoDS_Face face;  ///< as in the model
  Coedge use;
  Pcurve pcurve;
  /// A copy of the face's surface if it can move: placed in space, clamped, and cut off at the
  /// boundary, with the same parameters. Null if it can't.
  opencascade::handle<Geom_BSplineSurface> spline;
  PatchEdge edge = PatchEdge::U0;  ///< the boundary, of the spline
  bool with_edge = true;           ///< the pcurve runs in the edge's own sense
  MatchReason cannot_move;         ///< why the surface can't move; empty if it can

  bool isNatural() const { return !spline.IsNull(); }
};

/// The side of a face at the boundary. The boundary counts as a side of the surface if it is within
/// a hundredth of the gap tolerance of that side.
/// \throws GeometryError if the edge has no pcurve on the face; Standard_Failure.
MatchSide matchSide(const TopoDS_Face& face, const Coedge& use, const FaceMatchOptions& options);

}  // namespace seamwright::occ
