// SPDX-License-Identifier: LGPL-2.1-or-later
#include <limits>

#include <seamwright/occ_adapter/repair/fair_samples.hpp>
#include <seamwright/occ_adapter/repair/fair_solve.hpp>
#include <seamwright/occ_adapter/repair/free_coefficients.hpp>
#include <seamwright/occ_adapter/repair/reweighted_passes.hpp>

namespace seamwright::occ {

namespace {

bool halve(Displacement& displacement, const HalvedSpans& spans) {
  // The bending energy of a face is a dense matrix in its coefficients: 1500 of them take 18 MB.
  constexpr std::size_t most_coefficients = 1500;
  const SurfaceBasis& basis = displacement.basis();
  const std::size_t count =
      (basis.u().poles + spans[0].size()) * (basis.v().poles + spans[1].size());
  return count <= most_coefficients && displacement.halve(spans);
}

/// Halves spans beside missed samples, and samples their joints again.
/// \returns whether any span was halved.
bool refine(FairSamples& samples, MovingFaces& movers) {
  std::map<int, HalvedSpans> spans = samples.missedSpans();
  samples.naturalSides(movers).spread(spans, movers);
  bool any = false;
  for (const auto& [face, halves] : spans) any = halve(movers.at(face).displacement, halves) || any;
  if (!any) return false;
  samples.sampleAgain(spans, movers);
  samples.measure();
  return true;
}

}  // namespace

FairResult fairSolve(const std::vector<Joint>& joints, const ContinuityTolerance& tolerance,
                     const FairStart& start, MovingFaces& movers, const Progress& progress) {
  // Each refinement halves spans, so four reach a sixteenth of the first ones.
  constexpr int most_refinements = 4;
  FairSamples samples(joints, tolerance, movers, start.weights);
  FreeCoefficients unknowns;
  if (start.is_new)
    unknowns.freeAll(movers, samples.naturalSides(movers));
  else
    unknowns.free(samples.missedCoefficients(), start.relaxed, movers,
                  samples.naturalSides(movers));
  FairResult result;
  int in_vain = 0;
  double before = std::numeric_limits<double>::infinity();
  for (;; ++result.refinements) {
    const int refinement = result.refinements;
    if (unknowns.count() > 0)
      result.passes += reweightedPasses(
          samples, movers, unknowns,
          {.is_first = start.is_new, .may_insert_knots = refinement < most_refinements}, progress);
    in_vain = samples.worst() > helpful_share * before ? in_vain + 1 : 0;
    const bool is_hopeless = in_vain > 1 || (refinement > 0 && movers.size() > many_faces &&
                                             samples.worst() > wanting_knots);
    if (samples.areMet() || refinement == most_refinements || is_hopeless ||
        !refine(samples, movers))
      break;
    // From now on only coefficients beside missed samples move.
    unknowns.free(samples.missedCoefficients(), {}, movers, samples.naturalSides(movers));
    before = samples.worst();
  }
  result.missed = samples.missed();
  result.weights = samples.weightsBySeam();
  return result;
}

}  // namespace seamwright::occ
