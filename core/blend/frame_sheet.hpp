// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/core/blend/frame_loft.hpp>

namespace seamwright {

/// What a sheet has to meet at an end: the curve, and along it the first and the second derivative
/// by omega. All three have the same degree and knots; derivatives are "points" of weight 1.
struct FrameRibbon {
  BezierSpline position, first, second;
};

enum class SheetSide { Start, End };

/// The ribbon by which a sheet continues a surface beyond an edge (Start), or arrives at it (End),
/// so that the parameter of the surface across the edge goes on at \p rate by omega: first = rate
/// X_s, second = rate^2 X_ss, where s runs out of the surface at the start and into it at the end.
/// A sheet that takes the position and the first derivative is G1 with the surface, one that takes
/// the second, too, is G2.
/// \param reversed the ribbon runs against the sense of the edge.
/// \param closed the edge is a closed curve: its first and last poles are equal, bitwise.
/// \throws std::invalid_argument for an invalid or a rational surface, and for a rate that is not
/// positive.
/// Source: docs/theory/surfaces.md S1.1, S7.5.
FrameRibbon edgeRibbon(const BSplineSurface& surface, PatchEdge edge, bool reversed, SheetSide side,
                       double rate, bool closed = false);

struct SheetEnd {
  FrameRibbon ribbon;
  int order = 2;  ///< 0: position only; 1: first; 2: first and second derivative
  /// Share of omega, from the end, over which the sheet goes from the ribbon to the frames; the
  /// tolerance does not count there, and the zone is one span. No zone for order 0.
  double zone = 0.25;
};

/// The rate at which the frames leave or reach their end, as a multiple of the speed of \p ribbon
/// (of rate 1): the ratio of the mean sizes of the movement of poles over the outermost \p share of
/// omega, and of ribbon.first.
/// \throws std::invalid_argument if ribbon.first vanishes, or the frames do not move.
double evenRate(const FrameFunction& frame, const Interval& omegas, const FrameRibbon& ribbon,
                SheetSide side, double share = 0.125);

/// The loft through frames between two profiles that meets neighbours at its ends: as frameLoft(),
/// but where an end is given position and derivatives by omega are those of its ribbon, along the
/// whole profile and except for rounding. An end that is not given is free. The knots of u are
/// those of the ribbons. In the zones of the ends the sheet leaves the frames as far as the ribbons
/// ask for; zone_distance_mm says how far.
///
///     const FrameRibbon start = edgeRibbon(face, PatchEdge::U1, false, SheetSide::Start, 1);
///     const FrameLoft sheet = frameSheet(frame, {0, 1}, SheetEnd{start, 2}, {});
///
/// Identities (each has a test of its number):
///   (1) Along the ends the sheet and its derivatives are those of the ribbons.
///   (2) encloseSeam() certifies it against the neighbour with G1 or G2, up to rounding, and
///       encloseKnotLines() with G^n across the lines of joints.
///   (3) With the ribbons of a surface that is a cubic spline in v, and its iso-curves as frames,
///       it is that surface.
/// \throws std::invalid_argument as frameLoft() does; if no end is given; for an order outside
/// 0..2; for closed in omega; for ribbons that are not C^n at their joints, or differ from the
/// frames in segments or closedness, or from each other in knots; for a profile that is not the
/// frame at that end within the tolerance, with the distance; for zones that are negative or
/// overlap; and for a station or a kink inside of a zone. Source: docs/theory/surfaces.md S7.3,
/// S7.5.
FrameLoft frameSheet(const FrameFunction& frame, const Interval& omegas,
                     const std::optional<SheetEnd>& start, const std::optional<SheetEnd>& end,
                     const FrameLoftOptions& options = {});

}  // namespace seamwright
