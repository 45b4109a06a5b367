// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>

#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/match/match.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// The boundary that two faces have in common, and what each face is there; not a public header.
namespace seamwright::occ {

struct CommonBoundary {
  std::optional<Seam> seam;  ///< faces 1 and 2; edges by their numbers in the model; nothing: why
  std::string note;          ///< why there is none, or which of several it is
};

/// The two faces as a compound.
TopoDS_Shape pairOf(const std::array<TopoDS_Face, 2>& faces);

/// \throws std::invalid_argument if options.edge is none of the common edges; Cancelled.
CommonBoundary commonBoundary(const TopoDS_Shape& model, const std::array<TopoDS_Face, 2>& faces,
                              const FaceMatchOptions& options, const Progress& progress);

/// Why an edge of a matched seam is not near the other over its whole length, with numbers; empty
/// if it is: what is left out at an end is no longer than four times the larger of the distance to
/// match and the gap tolerance.
std::string whyApart(const Seam& seam, const FaceMatchOptions& options);

/// A face beside the common boundary.
struct MatchSide {
  TopoDS_Face face;  ///< as in the model
  Coedge use;
  Pcurve pcurve;
  /// A copy of the face's surface where it can move: placed, clamped, cut off at the boundary where
  /// it went on beyond it, with the same parameters. Null where it cannot.
  opencascade::handle<Geom_BSplineSurface> spline;
  PatchEdge edge = PatchEdge::U0;  ///< the boundary, of the spline
  bool with_edge = true;           ///< the pcurve runs in the edge's own sense
  std::string cannot_move;         ///< why

  bool isNatural() const { return !spline.IsNull(); }
};

/// The boundary may be away from a side of the surface by a hundredth of the gap tolerance.
/// \throws std::runtime_error if the edge has no path on the face; Standard_Failure.
MatchSide matchSide(const TopoDS_Face& face, const Coedge& use, const FaceMatchOptions& options);

}  // namespace seamwright::occ
