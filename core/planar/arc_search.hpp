// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/sampled_run.hpp>
#include <seamwright/core/progress.hpp>

/// Few arcs near samples of a curve. Not a public header.
namespace seamwright {

/// The direction of the arcs at an end of a run; any if there is none.
struct RunEnds {
  std::optional<double> begin_direction_rad, end_direction_rad;
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

/// A G1 chain of few arcs from the first sample to the last one that is no further from the samples
/// than the tolerance; nothing is said about the curve between samples. Nothing if none is found.
/// Source: docs/theory/planar.md P9.5.
std::optional<PlacedArcs> fewArcs(const SampledRun& run, const RunEnds& ends,
                                              const ArcSearchOptions& options,
                                              const Progress& progress = {});

}  // namespace seamwright
