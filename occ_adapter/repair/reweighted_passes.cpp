// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <seamwright/occ_adapter/repair/reweighted_passes.hpp>

namespace seamwright::occ {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Displacements of faces and weights of samples, to which passes can return.
struct FairState {
  std::map<int, PointRows> coefficients;  ///< by face
  FairSamples::Weights weights;
};

FairState stateOf(const FairSamples& samples, const MovingFaces& movers) {
  FairState state;
  for (const auto& [face, mover] : movers)
    state.coefficients[face] = mover.displacement.coefficients();
  state.weights = samples.weights();
  return state;
}

void returnTo(const FairState& state, FairSamples& samples, MovingFaces& movers) {
  for (auto& [face, mover] : movers)
    mover.displacement.setCoefficients(state.coefficients.at(face));
  samples.setWeights(state.weights);
  samples.measure();
}

/// The factor of energies in the next step. The conditions on normals are linear only for small
/// turns. If samples miss by more than 20 tolerances, the energies count more in the first step, as
/// if tolerances were larger, and at most a tenth of that in each further step. So large kinks
/// close in steps that are nearly linear.
/// \param last factor of the last step; infinite before the first one.
double easeAfter(double last, double worst) {
  constexpr double near = 20, less = 0.1;
  // Costs are squares of misses over tolerances.
  const double far = worst / near;
  return std::max(1.0, std::min(far * far, less * last));
}

/// Counts passes that do not help. They end if the worst miss exceeds the best one so far by the
/// factor 4, or after passes without progress: two if the worst miss is above 3 tolerances, else
/// four. A pass with more weight that changes the worst miss by less than a hundredth counts twice.
class IdlePasses {
 public:
  IdlePasses(double worst, std::size_t worst_joint) : last_(worst), last_joint_(worst_joint) {}

  /// \param is_weighted weight was added before the pass.
  void add(const FairSamples& samples, double ease, bool is_weighted) {
    constexpr double stands_still = 0.01;
    const double worst = samples.worst();
    const std::size_t worst_joint = samples.worstJoint();
    // If another joint is worst now, weight has not been tried on it yet.
    if (ease > 1 || worst <= helpful_share * last_)
      count_ = 0;
    else if (worst_joint == last_joint_)
      count_ += is_weighted && std::abs(worst - last_) < stands_still * last_ ? 2 : 1;
    last_ = worst;
    last_joint_ = worst_joint;
  }

  bool areTooMany(double worst, double best) const {
    // Choices. Far from the tolerances passes that do not help will not reach them, so fewer are
    // tried.
    constexpr double diverges = 4, far = 3;
    return worst > diverges * best || count_ >= (worst > far ? 2 : 4);
  }

 private:
  double last_ = 0;
  std::size_t last_joint_ = 0;
  int count_ = 0;
};

}  // namespace

int reweightedPasses(FairSamples& samples, MovingFaces& movers, const FreeCoefficients& unknowns,
                     const PassOptions& options, const Progress& progress) {
  // The largest weight is reached after five passes of largest growth (5^5 > 1000, see
  // FairSamples::addWeight()). As many are left to converge with it.
  constexpr int most_passes = 10;
  // A choice: a larger weight brings the worst samples nearer and costs fairness elsewhere. With
  // many faces five passes of growth take too long; 100 is reached after three (5^3 > 100).
  const double largest_weight = movers.size() > many_faces ? 100 : 1000;
  StepProblem problem(samples.joints(), samples.samples(), movers, unknowns);
  std::optional<FairState> unweighted, best;
  double best_miss = infinite, ease = infinite;
  IdlePasses idle(infinite, samples.worstJoint());
  int pass = 0;
  while (pass < most_passes) {
    ease = easeAfter(ease, samples.worst());
    if (progress && !progress(0)) throw Cancelled();
    problem.step(ease);
    samples.measure();
    ++pass;
    if (samples.worst() < best_miss) {
      best_miss = samples.worst();
      best = stateOf(samples, movers);
    }
    if (samples.areMet()) return pass;
    idle.add(samples, ease, unweighted.has_value());
    if (ease > 1) continue;
    if (idle.areTooMany(samples.worst(), best_miss)) break;
    if (pass == 1 && options.is_first) continue;
    if (!unweighted) unweighted = stateOf(samples, movers);
    samples.addWeight(largest_weight);
  }
  const bool wants_knots = options.may_insert_knots && unweighted && best_miss > wanting_knots;
  if (best) returnTo(wants_knots ? *unweighted : *best, samples, movers);
  return pass;
}

}  // namespace seamwright::occ
