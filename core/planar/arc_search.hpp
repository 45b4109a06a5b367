// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/sampled_run.hpp>
#include <seamwright/core/progress.hpp>

/// Few arcs near samples of a curve. Not a public header.
namespace seamwright {

/// An end of a chain: on the normal of the curve there.
struct RunEnd {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  std::optional<double> direction_rad;  ///< of the arcs; any if there is none
};

struct RunEnds {
  RunEnd begin, end;
};

/// A G1 chain beside a run.
struct PlacedArcs {
  std::vector<PlanarArc> arcs;
  /// Where the curve crosses the normals at the ends of the arcs: between these parameters.
  std::vector<CurvePart> ends;
};

struct ArcSearchOptions {
  double tolerance_mm = 0;
  double most_turn_rad = 0;  ///< of one arc
  /// An arc turns to a side only if some sample beside it does.
  bool keeps_sides = true;
};

/// A G1 chain of few arcs between ends beside the first sample and the last one that is no further
/// from the samples than the tolerance; nothing is said about the curve between samples. Nothing if
/// none is found. Source: docs/theory/planar.md P9.5.
std::optional<PlacedArcs> fewArcs(const SampledRun& run, const RunEnds& ends,
                                  const ArcSearchOptions& options, const Progress& progress = {});

}  // namespace seamwright
