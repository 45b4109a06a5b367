// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <seamwright/core/planar/arc_search.hpp>
#include <seamwright/core/planar/biarc.hpp>
#include <seamwright/core/planar/planar_curve.hpp>
#include <seamwright/core/progress.hpp>

/// Arcs beside a smooth part of a curve, with the proof of their distance. Not a public header.
namespace seamwright {

/// Arcs beside a part of the curve.
struct FittedPart {
  std::vector<PlanarArc> arcs;
  double distance_mm = 0;

  void append(const FittedPart& part) {
    arcs.insert(arcs.end(), part.arcs.begin(), part.arcs.end());
    distance_mm = std::max(distance_mm, part.distance_mm);
  }
};

/// One arc or two between points of the curve, with these directions there. Nothing if they are
/// not within the tolerance.
std::optional<FittedPart> fittedPart(const PlanarCurve& curve, const CurvePart& range,
                                     const HermiteEnds& ends, double tolerance_mm);

/// A chain that begins beside a parameter of the curve, with the bound of its distance; nothing if
/// an arc is not certainly within the tolerance.
std::optional<FittedPart> proven(const PlanarCurve& curve, double begin, const PlacedArcs& placed,
                                 double tolerance_mm);

/// A smooth part of the curve with the directions its arcs have at its ends.
struct SmoothRun {
  CurvePart range;
  RunEnds ends;
};

/// The line between ends at which any direction will do; nothing if it is not near the curve.
std::optional<FittedPart> lineBeside(const PlanarCurve& curve, const SmoothRun& run,
                                     double tolerance_mm);

/// The circle near a closed curve; nothing if none is near.
std::optional<FittedPart> circleBeside(const PlanarCurve& curve, const SampledRun& sampled,
                                       double tolerance_mm);

/// Few arcs by fewArcs(), with the bound of their distance; nothing if none are found or proven.
/// \param sampled the samples of the run.
std::optional<FittedPart> fewArcsBeside(const PlanarCurve& curve, const SmoothRun& run,
                                        const SampledRun& sampled, double tolerance_mm,
                                        const Progress& progress);

/// Pairs of arcs, each as long as the tolerance allows, between points of the curve. Their ends are
/// those of the curve.
/// \param run both directions are given.
/// \throws std::domain_error if the curve turns back, or the tolerance is below its rounding.
FittedPart greedyArcs(const PlanarCurve& curve, const SmoothRun& run, double tolerance_mm,
                      const Progress& progress);

/// Where fewArcsBeside() finds nothing: for halves of the run and their halves, as far as it finds
/// nothing there. The smallest parts have greedy pairs.
/// \param run both directions are given.
/// \throws std::domain_error as greedyArcs().
FittedPart arcsOfHalves(const PlanarCurve& curve, const SmoothRun& run, const SampledRun& sampled,
                        double tolerance_mm, const Progress& progress);

}  // namespace seamwright
