// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/biarc_spline.hpp>

namespace seamwright {

/// Lines and arcs of which points are samples.
struct SampledChain {
  std::vector<PlanarArc> arcs;
  std::vector<int> corners;  ///< arcs that begin at a corner; ends do not count
  bool closed = false;
  double distance_mm = 0;  ///< no point is further from the chain
};

struct SampledChainOptions {
  bool closed = false;
  double tolerance_mm = 0.01;
  int most_arcs = 1000;  ///< chains of more are not looked for
};

/// The chain of fewest lines and arcs whose samples the points are, each off by less than the
/// tolerance; of those for several bounds of the errors the first. It is G1 except at corners:
/// those of pointCorners() for the bound, turns of 12 degrees or more included, and those where
/// neighbouring pieces cross at such an angle, and by three times the turn of an arc from point to
/// point. Pieces on both sides of a corner meet where they
/// cross. It is no further from the corner among the points than the tolerance and the bound of the
/// errors, or between two points in whose steps it fits: around the corner these are as far apart
/// as on both sides, or up to two steps between the last and the first point of a closed chain. An
/// arc needs three points, a line two, and two neighbours six; between corners where pieces cross
/// an arc needs four and a line three. There are at most 60 pieces between corners. Pieces are
/// lines if they can be. A closed chain begins at its first corner, else its first arc is the one
/// beside the first point. Identities (each has a test of its number):
///   (1) Samples of lines and arcs give these, up to the rounding of their digits; corners among
///       the samples stay corners, and those that equal steps of the samples leave out are found.
///   (2) No point is further from the chain than distance_mm <= tolerance_mm.
///   (3) Points of lines and arcs with errors up to 2/5 of the tolerance along each axis have as
///       many, with the same corners, and so they have from whichever point a closed chain begins.
///       Each piece needs so many points that errors do not hide it, and a corner of two lines
///       turns by 30 degrees or more.
/// Nothing if a point is further from each chain found than the tolerance, or the chain does not
/// run from point to point. \throws std::invalid_argument for equal neighbours.
/// Source: docs/theory/planar.md P9.6.
std::optional<SampledChain> sampledChain(const PlanarPoints& points,
                                         const SampledChainOptions& options);

}  // namespace seamwright
