// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

struct MatchOptions {
  double match_mm = 0;     ///< distance of the edges <= match_mm
  double gap_mm = 0.01;    ///< what counts as a gap: the correspondence need not be finer
  int most_pieces = 2000;  ///< of a correspondence; once it has more, none is halved any more
};

/// What the search looked at.
struct MatchSummary {
  std::size_t edges = 0;   ///< free edges that can be evaluated
  std::size_t pieces = 0;  ///< nearly straight pieces of them
  std::size_t close_pieces =
      0;  ///< pairs of pieces of different edges found close together and looked at
};

/// Finds where free edges (graph.open) run side by side, and adds a seam of kind Matched for each
/// common interval.
///
/// An edge is here what its face makes of it: the image of its pcurve on the surface, which is what
/// is measured later. A common interval of edges n < m is where the point of m nearest to a point
/// of n is no further than match_mm, is not beyond the end of m, and the directions differ by less
/// than 45 degrees. So a long edge and three short ones make three seams, and two circles that
/// start at different points make two, because intervals end where a closed edge starts. An
/// interval counts if
///  (1) its length is at least 4 times its largest distance, so edges that only meet at a corner
///      and part at more than 14.5 degrees (sin = 1/4) make no seam, nor does anything else if
///      match_mm is larger than the edges;
///  (2) its length is at least 4 match_mm or a tenth of the shorter edge: edges in a row may
///      overlap a little.
///
/// Where several edges run along the same part of an edge:
///  (3) of the edges of one face the nearest counts, judged by the largest distance over that part;
///      then of different faces the nearest. So a face narrower than match_mm is joined on each
///      side to the neighbour on that side;
///  (4) unless an edge of another face is at most twice as far, or not further than each edge's own
///      tolerance: three faces or more meet there. If that part is as long as (2) asks, it is no
///      seam; the edges leave graph.open for graph.non_manifold. Edges of one face are matched only
///      if the surface closes between them (a tube whose two long edges were never sewn): halfway
///      between their points in the parameter plane the surface is more than twice as far from them
///      as they are from one another. The edges of a slit or of a narrow face are not. Edges that
///      bound two faces or more already take no part.
///
/// Correspondence: s is proportional to the arc length of n at its knots; b is the place nearest to
/// a. Halfway between two knots the place that is interpolated is off along m by at most 0.5 % of
/// the larger of min(gap_mm, length of m / 1000) and the distance (and 1e-9 of the length of m),
/// unless most_pieces are not enough or m turns back on itself, which is a note on the seam.
///
/// An edge leaves graph.open if matched intervals leave out no more than 4 match_mm and a tenth of
/// it at a time. An edge that is matched in part is in graph.seams and in graph.open.
///
/// The result does not depend on the order of the faces but for which of two edges is the first.
/// Time grows with the number of edges n as n log n as long as each has a bounded number of others
/// within match_mm. An edge that can't be evaluated stays open, with a note in graph.notes.
/// \throws Cancelled.
MatchSummary matchFreeEdges(const MatchOptions& options, SeamGraph& graph,
                            const Progress& progress = {});

}  // namespace seamwright::occ
