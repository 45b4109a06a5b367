// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/occ_adapter/repair/fair_samples.hpp>
#include <seamwright/occ_adapter/repair/free_coefficients.hpp>

/// Reweighted least squares with given knots. Not a public header.
namespace seamwright::occ {

/// More weight, or more knots, help if they reduce the worst miss below this share of its old
/// value.
constexpr double helpful_share = 0.7;

/// A sample that misses by more tolerances than this needs more knots; weight alone does not help.
constexpr double wanting_knots = 10;

/// Limits the cost of large parts. If more faces move than this, seams that still need knots after
/// a refinement are not refined further, since they would take most of the time. Their samples also
/// have a smaller largest weight, because otherwise they would spoil the solution for all other
/// faces. Such seams are tried again alone.
constexpr std::size_t many_faces = 12;

struct PassOptions {
  bool is_first = true;          ///< nothing was solved before: no weight is added after one pass
  bool may_insert_knots = true;  ///< the caller can insert knots where weight does not help
};

/// Repeats passes until all samples are met or more weight does not help. Each pass moves the faces
/// by a Gauss-Newton step and then gives missed samples more weight. The best pass is kept. If the
/// miss stays large in spite of weight, knots are missing: the faces return to what they were
/// before weight was added, so that the caller can insert knots.
/// \param samples in: measured; out: of the faces as they are after the passes, with their weights.
/// \returns the number of passes.
/// \throws Cancelled; Standard_Failure.
int reweightedPasses(FairSamples& samples, MovingFaces& movers, const FreeCoefficients& unknowns,
                     const PassOptions& options, const Progress& progress);

}  // namespace seamwright::occ
