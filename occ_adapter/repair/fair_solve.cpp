// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <seamwright/occ_adapter/repair/fair_solve.hpp>
#include <seamwright/occ_adapter/repair/free_coefficients.hpp>
#include <seamwright/occ_adapter/repair/natural_sides.hpp>
#include <seamwright/occ_adapter/repair/step_problem.hpp>

namespace seamwright::occ {

namespace {

/// A sample is met if it misses less than this share of the tolerance. The rest is a reserve for
/// points between samples.
constexpr double enough = 0.6;

/// More weight, or more knots, help if they reduce the worst miss below this share of its old
/// value.
constexpr double helps = 0.7;

/// A sample that misses by more tolerances than this needs more knots; weight alone does not help.
constexpr double wanting_knots = 10;

/// Limits the cost of large parts. If more faces move than this, seams that still need knots after
/// a refinement are not refined further, since they would take most of the time. Their samples also
/// have a smaller largest weight, because otherwise they would spoil the solution for all other
/// faces. Such seams are tried again alone.
constexpr std::size_t many_faces = 12;

using HalvedSpans = std::array<std::set<int>, 2>;  ///< by direction

/// By face: the spans of displacements beside missed samples, except short ones.
std::map<int, HalvedSpans> missedSpans(const std::vector<Joint>& joints,
                                       const JointSamples& samples) {
  // Least length of a span as a share of the surface. It keeps a fair face from being spent on a
  // seam that needs much in a short interval (docs/theory/repair.md, "What cannot be repaired
  // fairly").
  constexpr double shortest = 1.0 / 128;
  std::map<int, HalvedSpans> spans;
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (const JointSample& sample : samples[j]) {
      if (sample.ratio <= enough) continue;
      for (std::size_t k = 0; k < sample.sides.size(); ++k) {
        const JointSide& side = sample.sides[k];
        if (side.mover == nullptr) continue;
        const SurfaceBasis& basis = side.mover->displacement.basis();
        for (const int direction : {0, 1}) {
          const SplineAxis& axis = direction == 0 ? basis.u() : basis.v();
          double t = side.uv[direction];
          const int span = axis.span(t, side.into[direction]);
          if (axis.length(span) > shortest * (axis.last - axis.first))
            spans[joints[j].sides[k].face][direction].insert(span);
        }
      }
    }
  return spans;
}

bool halve(Displacement& displacement, const HalvedSpans& spans) {
  constexpr std::size_t most_coefficients = 1500;
  const SurfaceBasis& basis = displacement.basis();
  const std::size_t count =
      (basis.u().poles + spans[0].size()) * (basis.v().poles + spans[1].size());
  return count <= most_coefficients && displacement.halve(spans);
}

/// The weight of the sample that is nearest.
double nearestWeight(const SampleWeights& weights, double s) {
  return std::ranges::min_element(weights, {},
                                  [s](const auto& one) { return std::abs(one.first - s); })
      ->second;
}

class FairSolving {
 public:
  FairSolving(const std::vector<Joint>& joints, const ContinuityTolerance& tolerance,
              MovingFaces& movers, const Progress& progress)
      : joints_(joints), tolerance_(tolerance), movers_(movers), progress_(progress) {}

  FairResult run(const FairStart& start) {
    constexpr int most_refinements = 4;
    for (const Joint& joint : joints_) samples_.push_back(sampled(joint, movers_, tolerance_));
    inherit(start.weights);
    look();
    if (start.is_new)
      unknowns_.freeAll(movers_, naturalSides());
    else
      freeWhereNeeded(start.relaxed);
    int in_vain = 0;
    for (int refinement = 0;; ++refinement) {
      const double before = refinement == 0 ? std::numeric_limits<double>::infinity() : worst();
      if (unknowns_.count() > 0) solve(start.is_new, refinement < most_refinements);
      in_vain = worst() > helps * before ? in_vain + 1 : 0;
      const bool is_hopeless =
          in_vain > 1 || (refinement > 0 && movers_.size() > many_faces && worst() > wanting_knots);
      if (worst() <= enough || refinement == most_refinements || is_hopeless || !refine()) break;
    }
    FairResult result{missed_, {}};
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (joints_[j].ask != Ask::Outline)
        for (const JointSample& sample : samples_[j])
          result.weights[joints_[j].seam].emplace_back(sample.s, sample.weight);
    return result;
  }

 private:
  /// Takes over the square roots of earlier weights, since the reason for a large weight may be
  /// gone.
  void inherit(const std::map<std::size_t, SampleWeights>& weights) {
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const auto known = weights.find(joints_[j].seam);
      if (joints_[j].ask == Ask::Outline || known == weights.end()) continue;
      for (JointSample& sample : samples_[j])
        sample.weight = std::sqrt(nearestWeight(known->second, sample.s));
    }
  }

  double worst() const { return missed_.empty() ? 0 : std::ranges::max(missed_); }
  std::size_t worstJoint() const {
    return static_cast<std::size_t>(std::ranges::max_element(missed_) - missed_.begin());
  }

  void look() {
    missed_.assign(joints_.size(), 0);
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (JointSample& sample : samples_[j]) {
        followSlide(sample);
        followCurvature(joints_[j], tolerance_, sample);
        sample.ratio = missedShare(joints_[j], sample);
        missed_[j] = std::max(missed_[j], sample.ratio);
      }
  }

  /// \param whole faces of which all coefficients are free.
  void freeWhereNeeded(const std::set<int>& whole) {
    std::map<int, std::set<int>> needed;
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (const JointSample& sample : samples_[j]) {
        if (sample.ratio <= enough) continue;
        for (std::size_t k = 0; k < sample.sides.size(); ++k)
          if (const JointSide& side = sample.sides[k]; side.mover != nullptr)
            for (const int coefficient : side.mover->displacement.coefficientsNear(side.uv))
              needed[joints_[j].sides[k].face].insert(coefficient);
      }
    unknowns_.free(needed, whole, movers_, naturalSides());
  }

  NaturalSides naturalSides() const {
    std::vector<bool> gaps_stay;
    for (std::size_t j = 0; j < joints_.size(); ++j)
      gaps_stay.push_back(joints_[j].ask == Ask::Keep ||
                          std::ranges::all_of(samples_[j], &JointSample::keeps_gap));
    return {joints_, gaps_stay, movers_};
  }

  struct State {
    std::map<int, PointRows> coefficients;     ///< by face
    std::vector<std::vector<double>> weights;  ///< by joint and sample
  };

  State state() const {
    State now;
    for (const auto& [face, mover] : movers_)
      now.coefficients[face] = mover.displacement.coefficients();
    for (const auto& samples : samples_) {
      now.weights.emplace_back();
      for (const JointSample& sample : samples) now.weights.back().push_back(sample.weight);
    }
    return now;
  }

  void returnTo(const State& state) {
    for (auto& [face, mover] : movers_)
      mover.displacement.setCoefficients(state.coefficients.at(face));
    for (std::size_t j = 0; j < samples_.size(); ++j)
      for (std::size_t i = 0; i < samples_[j].size(); ++i)
        samples_[j][i].weight = state.weights[j][i];
    look();
  }

  /// Repeats passes until all samples are met or more weight does not help. If the miss stays large
  /// in spite of weight, knots are missing: the effect of the weights is undone before knots are
  /// inserted.
  void solve(bool is_first, bool may_refine) {
    constexpr int most_passes = 10;
    // A pass whose worst miss exceeds the best one so far by the factor 4 ends the passes. Passes
    // without progress end them too: two if the worst miss is above 3 tolerances, else four. After
    // weights were added, a pass that changes the worst miss by less than a hundredth counts twice.
    constexpr double diverges = 4, far = 3, stands_still = 0.01;
    StepProblem problem(joints_, samples_, movers_, unknowns_);
    std::optional<State> plain, best;
    double best_ratio = std::numeric_limits<double>::infinity(), last = best_ratio;
    int idle = 0;
    std::size_t last_joint = worstJoint();
    for (int pass = 0; pass < most_passes; ++pass) {
      easeBy(pass == 0 ? std::numeric_limits<double>::infinity() : ease_);
      if (progress_ && !progress_(0)) throw Cancelled();
      problem.step(ease_);
      look();
      if (worst() < best_ratio) {
        best_ratio = worst();
        best = state();
      }
      if (worst() <= enough) return;
      const std::size_t worst_joint = worstJoint();
      // If another joint is worst now, weight has not been tried on it yet.
      if (ease_ > 1 || worst() <= helps * last)
        idle = 0;
      else if (worst_joint == last_joint)
        idle += plain && std::abs(worst() - last) < stands_still * last ? 2 : 1;
      last = worst();
      last_joint = worst_joint;
      if (ease_ > 1) continue;
      if (worst() > diverges * best_ratio) break;
      if (idle >= (worst() > far ? 2 : 4)) break;
      if (pass == 0 && is_first) continue;
      if (!plain) plain = state();
      addWeight();
    }
    if (best) returnTo(may_refine && plain && best_ratio > wanting_knots ? *plain : *best);
  }

  /// The conditions on normals are linear only for small turns. If samples miss by more than 20
  /// tolerances, the energies count more in the first step, as if tolerances were larger, and at
  /// most a tenth of that in each further step. So large kinks close in steps that are nearly
  /// linear.
  void easeBy(double last) {
    constexpr double near = 20, less = 0.1;
    const double far = worst() / near;
    ease_ = std::max(1.0, std::min(far * far, less * last));
  }

  void addWeight() {
    constexpr double most_growth = 5;
    const double most_weight = movers_.size() > many_faces ? 100 : 1000;
    for (auto& samples : samples_)
      for (JointSample& sample : samples)
        if (sample.ratio > enough)
          sample.weight = std::min(
              most_weight, sample.weight * std::min(most_growth, sample.ratio / (0.7 * enough)));
  }

  /// Halves spans beside missed samples. \returns whether any span was halved.
  bool refine() {
    std::map<int, HalvedSpans> spans = missedSpans(joints_, samples_);
    naturalSides().spread(spans, movers_);
    bool any = false;
    for (const auto& [face, halves] : spans)
      any = halve(movers_.at(face).displacement, halves) || any;
    if (!any) return false;
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (std::ranges::any_of(joints_[j].sides,
                              [&](const Coedge& side) { return spans.count(side.face) > 0; }))
        sampleAgain(j);
    look();
    freeWhereNeeded({});
    return true;
  }

  /// Samples the joint again, as densely as the new knots need. Each sample takes over the weight
  /// of the nearest old one.
  void sampleAgain(std::size_t j) {
    SampleWeights weights;
    for (const JointSample& sample : samples_[j]) weights.emplace_back(sample.s, sample.weight);
    samples_[j] = sampled(joints_[j], movers_, tolerance_);
    for (JointSample& sample : samples_[j]) sample.weight = nearestWeight(weights, sample.s);
  }

  const std::vector<Joint>& joints_;
  const ContinuityTolerance& tolerance_;
  MovingFaces& movers_;
  const Progress& progress_;
  JointSamples samples_;        ///< by joint
  std::vector<double> missed_;  ///< by joint
  FreeCoefficients unknowns_;
  double ease_ = 1;  ///< factor of energies
};

}  // namespace

FairResult fairSolve(const std::vector<Joint>& joints, const ContinuityTolerance& tolerance,
                     const FairStart& start, MovingFaces& movers, const Progress& progress) {
  return FairSolving(joints, tolerance, movers, progress).run(start);
}

}  // namespace seamwright::occ
