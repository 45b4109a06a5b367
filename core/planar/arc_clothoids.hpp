// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/progress.hpp>

namespace seamwright {

/// Clothoids near a chain of arcs.
struct ArcClothoids {
  std::vector<Clothoid> pieces;
  /// Upper bound of the distance from the arcs in both directions.
  double distance_mm = 0;
};

/// A G1 chain of arcs and lines as clothoids that join G2: arcs and lines with a clothoid between
/// neighbours. Lines stay on their lines. An arc moves towards the inside of its curve, where lines
/// are beside it, by the shift of the clothoid; between a flatter and a sharper arc it tilts. An
/// open chain keeps both ends and the directions there. Identities (each has a test of its number):
///   (1) Points of a dense sample are not further from the arcs than distance_mm <= tolerance_mm,
///       in both directions.
///   (2) The curvature is that of the arcs with each jump made a ramp: it has as many extrema and
///       inflections.
///   (3) An arc between lines keeps its centre if its transitions have one length, which is the
///       largest one: its radius becomes smaller by nearly the tolerance, or the transitions take
///       nine tenths of a neighbour.
/// \throws std::invalid_argument for an empty chain and a tolerance that is not positive and
/// finite. Throws std::domain_error if no transitions were found, with the index of an arc: corners
/// between the arcs, a tolerance below the rounding of the arcs, or sweeps of nearly a full circle.
/// Throws Cancelled, see Progress; it is called before the bound of each arc.
/// Source: docs/theory/planar.md P4.6.
ArcClothoids clothoidsNear(const std::vector<PlanarArc>& arcs, bool closed, double tolerance_mm,
                           const Progress& progress = {});

}  // namespace seamwright
