// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

struct MatchOptions {
  double match_mm = 0;     ///< distance of the edges <= match_mm
  double gap_mm = 0.01;    ///< gap tolerance; the correspondence need not be finer
  int most_pieces = 2000;  ///< of a correspondence; with more, pieces are not halved any more
  bool cubic = false;      ///< correspondences are cubic: of fewer pieces
};

/// The size of a search.
struct MatchSummary {
  std::size_t edges = 0;   ///< free edges that can be evaluated
  std::size_t pieces = 0;  ///< nearly straight pieces of them
  std::size_t close_pieces =
      0;  ///< pairs of pieces of different edges that were close together and compared
};

/// Finds where free edges (graph.open) run side by side, and adds a seam of kind Matched to the
/// graph for each common interval. docs/seams.md ("Matched seams") explains the rules for users.
///
/// An edge is the image of its pcurve on the surface of its face, which is also what is measured
/// later. In a common interval of edges n < m the point of m nearest to a point of n is no further
/// than match_mm and not beyond the end of m, and the directions differ by less than 45 degrees. So
/// a long edge and three short ones make three seams, and two circles that start at different
/// points make two, because intervals end where a closed edge starts. An interval counts if
///   (1) its length is at least 4 times its largest distance: edges that only meet at a corner, at
///       more than 14.5 degrees (sin = 1/4), make no seam, however large match_mm is;
///   (2) its length is at least 4 match_mm or a tenth of the shorter edge: edges in a row may
///       overlap a little.
///
/// Where several edges run along the same part of an edge,
///   (3) the nearest one of each face counts, by the largest distance over that part, and then the
///       nearest of different faces. So a face narrower than match_mm is joined on each side to its
///       neighbour there;
///   (4) but if an edge of another face is at most twice as far, or within each edge's own
///       tolerance, three faces or more meet there. If that part is as long as (2) requires, it is
///       no seam, and the edges move from graph.open to graph.non_manifold.
///
/// Edges of one face are matched only if the surface closes between them, as in a tube that was not
/// sewn: halfway between them in the parameter plane, the surface is more than twice as far from
/// them as they are from each other. The edges of a slit or of a narrow face are not matched.
///
/// Correspondence: s is proportional to the arc length of n at its knots; b is the point nearest to
/// a. Halfway between two knots the interpolated point is off along m by at most 0.5 % of the
/// larger of the distance and min(gap_mm, length of m / 1000), or by 1e-9 of the length of m; for
/// cubic ones this holds at a sixth, a half and five sixths. If
/// most_pieces are not enough, or m turns back on itself, the seam has a note.
///
/// An edge leaves graph.open if each interval that is not matched is no longer than 4 match_mm and
/// a tenth of the edge. An edge that is matched in part is in graph.seams and in graph.open.
///
/// The order of the faces only determines which of two edges is the first. Time grows as n log n
/// with the number of edges n if each has a bounded number of others within match_mm. An edge that
/// can't be evaluated stays free, with a note in graph.notes.
/// \throws Cancelled.
MatchSummary matchFreeEdges(const MatchOptions& options, SeamGraph& graph,
                            const Progress& progress = {});

}  // namespace seamwright::occ
