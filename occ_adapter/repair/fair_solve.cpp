// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <seamwright/occ_adapter/repair/fair_solve.hpp>
#include <seamwright/occ_adapter/repair/natural_sides.hpp>

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
      freeAll();
    else
      freeWhereNeeded(start.relaxed);
    int in_vain = 0;
    for (int refinement = 0;; ++refinement) {
      const double before = refinement == 0 ? std::numeric_limits<double>::infinity() : worst();
      if (unknowns_ > 0) solve(start.is_new, refinement < most_refinements);
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
        sample.weight = std::sqrt(nearest(known->second, sample.s));
    }
  }

  static double nearest(const SampleWeights& weights, double s) {
    return std::ranges::min_element(weights, {},
                                    [s](const auto& one) { return std::abs(one.first - s); })
        ->second;
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

  void freeAll() {
    for (auto& [face, mover] : movers_)
      unknown_[face].assign(static_cast<std::size_t>(mover.displacement.count()), 0);
    number();
  }

  /// Frees the coefficients near missed samples. Coefficients far from these keep the values, and
  /// the fairness, that they got with fewer knots.
  /// \param whole faces of which all coefficients are free.
  void freeWhereNeeded(const std::set<int>& whole) {
    for (auto& [face, mover] : movers_)
      unknown_[face].assign(static_cast<std::size_t>(mover.displacement.count()),
                            whole.count(face) > 0 ? 0 : -1);
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (const JointSample& sample : samples_[j]) {
        if (sample.ratio <= enough) continue;
        for (std::size_t k = 0; k < sample.sides.size(); ++k)
          if (const JointSide& side = sample.sides[k]; side.mover != nullptr)
            for (const int coefficient : side.mover->displacement.coefficientsNear(side.uv))
              unknown_[joints_[j].sides[k].face][coefficient] = 0;
      }
    number();
  }

  /// Numbers the free coefficients. Tied coefficients are free if one of them is.
  void number() {
    const NaturalSides sides = naturalSides();
    std::map<std::pair<int, int>, int> numbers;  // by first of the tied coefficients
    const auto forEach = [&](const auto& work) {
      for (auto& [face, all] : unknown_)
        for (std::size_t k = 0; k < all.size(); ++k)
          work(sides.first(face, static_cast<int>(k)), all[k]);
    };
    forEach([&](const auto& first, int& own) {
      if (own >= 0) numbers[first] = 0;
    });
    unknowns_ = 0;
    for (auto& [first, number] : numbers) number = unknowns_++;
    forEach([&](const auto& first, int& own) {
      const auto found = numbers.find(first);
      own = found == numbers.end() ? -1 : found->second;
    });
  }

  NaturalSides naturalSides() const {
    std::vector<bool> gaps_stay;
    for (std::size_t j = 0; j < joints_.size(); ++j)
      gaps_stay.push_back(joints_[j].ask == Ask::Keep ||
                          std::ranges::all_of(samples_[j], &JointSample::keeps_gap));
    return {joints_, gaps_stay, movers_};
  }

  struct FaceEnergy {
    int face = 0, cell = 0;
    EnergyBlock block;
    std::vector<Eigen::Index> free;  ///< indices in the block
  };

  int cellOf(std::vector<int> unknowns) {
    const auto [found, is_new] = cell_numbers_.emplace(unknowns, static_cast<int>(cells_.size()));
    if (is_new) cells_.push_back(std::move(unknowns));
    return found->second;
  }

  /// Collects the cells: sets of unknowns that occur together in a condition.
  StepSystem prepare() {
    cells_.clear();
    cell_numbers_.clear();
    prepareEnergies();
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (JointSample& sample : samples_[j]) prepareSample(joints_[j], sample);
    return {unknowns_, cells_};
  }

  void prepareEnergies() {
    energies_.clear();
    for (const auto& [face, mover] : movers_) {
      const std::vector<int>& unknown = unknown_[face];
      const double unit =
          std::pow(fairness * mover.stiffness / mover.budget_per_mm, 2) / mover.area_mm2;
      for (EnergyBlock& block : mover.displacement.bending()) {
        FaceEnergy energy{face, 0, std::move(block), {}};
        const auto numberOf = [&](Eigen::Index k) { return unknown[energy.block.coefficients[k]]; };
        for (Eigen::Index k = 0; k < std::ssize(energy.block.coefficients); ++k)
          if (numberOf(k) >= 0) energy.free.push_back(k);
        if (energy.free.empty()) continue;
        std::ranges::sort(energy.free, {}, numberOf);
        std::vector<int> unknowns;
        std::ranges::transform(energy.free, std::back_inserter(unknowns), numberOf);
        energy.block.matrix *= unit;
        energy.cell = cellOf(std::move(unknowns));
        energies_.push_back(std::move(energy));
      }
    }
  }

  void prepareSample(const Joint& joint, JointSample& sample) {
    std::vector<int> unknowns;
    for (std::size_t k = 0; k < sample.sides.size(); ++k)
      if (sample.sides[k].mover != nullptr)
        for (const int coefficient : sample.sides[k].shares.poles)
          if (const int number = unknown_[joint.sides[k].face][coefficient]; number >= 0)
            unknowns.push_back(number);
    std::ranges::sort(unknowns);
    unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
    sample.cell = -1;
    if (unknowns.empty()) return;
    for (std::size_t k = 0; k < sample.sides.size(); ++k) {
      JointSide& side = sample.sides[k];
      side.column.clear();
      if (side.mover == nullptr) continue;
      for (const int coefficient : side.shares.poles) {
        const int number = unknown_[joint.sides[k].face][coefficient];
        side.column.push_back(
            number < 0 ? -1 : std::ranges::lower_bound(unknowns, number) - unknowns.begin());
      }
    }
    sample.cell = cellOf(std::move(unknowns));
  }

  void assemble(StepSystem& system) {
    system.clear();
    for (const FaceEnergy& energy : energies_) {
      const PointRows& all = movers_.at(energy.face).displacement.coefficients();
      const PointRows at = all(energy.block.coefficients, Eigen::indexing::all);
      const PointRows pull = energy.block.matrix * at;
      system.addEnergy(energy.cell, ease_ * energy.block.matrix(energy.free, energy.free),
                       ease_ * pull(energy.free, Eigen::indexing::all));
    }
    for (auto& [face, mover] : movers_) addDamping(face, mover, system);
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (const JointSample& sample : samples_[j])
        if (sample.cell >= 0) addConditions(joints_[j], sample, system);
  }

  /// Weight of the sum of squares of the coefficients. It stands for the integral of |D|^2 /
  /// size^4, as if the coefficients were evenly distributed over the face. The size of the move is
  /// secondary, except for faces that moved too far.
  static double damping(const MovingFace& mover) {
    const double of_size =
        std::pow(fairness * mover.stiffness / (mover.budget_per_mm * mover.size_mm), 2) /
        mover.area_mm2;
    return (of_size + std::pow(fairness / mover.restraint_mm, 2)) / mover.displacement.count();
  }

  void addDamping(int face, const MovingFace& mover, StepSystem& system) {
    const std::vector<int>& unknown = unknown_[face];
    const double factor = ease_ * damping(mover);
    for (std::size_t k = 0; k < unknown.size(); ++k)
      if (unknown[k] >= 0)
        system.addDamping(
            unknown[k], factor,
            mover.displacement.coefficients().row(static_cast<Eigen::Index>(k)).transpose());
  }

  void take(const PointRows& step) {
    for (auto& [face, mover] : movers_) {
      PointRows own = mover.displacement.coefficients();
      const std::vector<int>& unknown = unknown_[face];
      for (std::size_t k = 0; k < unknown.size(); ++k)
        if (unknown[k] >= 0) own.row(static_cast<Eigen::Index>(k)) += step.row(unknown[k]);
      mover.displacement.setCoefficients(std::move(own));
    }
  }

  double cost() const {
    double sum = 0;
    for (const FaceEnergy& energy : energies_) {
      const PointRows& all = movers_.at(energy.face).displacement.coefficients();
      const PointRows at = all(energy.block.coefficients, Eigen::indexing::all);
      sum += ease_ * (at.transpose() * energy.block.matrix * at).trace();
    }
    for (const auto& [face, mover] : movers_)
      sum += ease_ * damping(mover) * mover.displacement.coefficients().squaredNorm();
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (const JointSample& sample : samples_[j])
        if (sample.cell >= 0) sum += costOf(joints_[j], sample);
    return sum;
  }

  /// Takes the step. If it does not reduce the cost it is halved, at most twice, and then replaced
  /// by a damped step.
  void descend(StepSystem& system) {
    // Marquardt's factors on the diagonal; 0 is the undamped Gauss-Newton step.
    constexpr std::array<double, 4> dampings = {0, 1e-3, 3e-2, 1};
    constexpr int halvings = 2;
    const double before = cost();
    for (const double damping : dampings) {
      system.damp(damping);
      PointRows step = system.solve();
      for (int k = 0; k <= halvings; ++k) {
        take(step);
        if (cost() <= before) return;
        take(-step);
        step *= 0.5;
      }
    }
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
    StepSystem system = prepare();
    std::optional<State> plain, best;
    double best_ratio = std::numeric_limits<double>::infinity(), last = best_ratio;
    int idle = 0;
    std::size_t last_joint = worstJoint();
    for (int pass = 0; pass < most_passes; ++pass) {
      easeBy(pass == 0 ? std::numeric_limits<double>::infinity() : ease_);
      if (progress_ && !progress_(0)) throw Cancelled();
      assemble(system);
      descend(system);
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
    // Least length of a span as a share of the surface. It keeps a fair face from being spent on a
    // seam that needs much in a short interval (docs/theory/repair.md, "What cannot be repaired
    // fairly").
    constexpr double shortest = 1.0 / 128;
    std::map<int, std::array<std::set<int>, 2>> spans;
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (const JointSample& sample : samples_[j]) {
        if (sample.ratio <= enough) continue;
        for (std::size_t k = 0; k < sample.sides.size(); ++k) {
          const JointSide& side = sample.sides[k];
          if (side.mover == nullptr) continue;
          const SurfaceBasis& basis = side.mover->displacement.basis();
          for (const int way : {0, 1}) {
            const SplineAxis& axis = way == 0 ? basis.u() : basis.v();
            double t = side.uv[way];
            const int span = axis.span(t, side.into[way]);
            if (axis.length(span) > shortest * (axis.last - axis.first))
              spans[joints_[j].sides[k].face][way].insert(span);
          }
        }
      }
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
    for (JointSample& sample : samples_[j]) sample.weight = nearest(weights, sample.s);
  }

  static bool halve(Displacement& displacement, const std::array<std::set<int>, 2>& spans) {
    constexpr std::size_t most_coefficients = 1500;
    const SurfaceBasis& basis = displacement.basis();
    const std::size_t count =
        (basis.u().poles + spans[0].size()) * (basis.v().poles + spans[1].size());
    return count <= most_coefficients && displacement.halve(spans);
  }

  /// Price of the energy that spends a face's budget, in terms of a sample that stands for a
  /// sixteenth of a seam and misses by a quarter of its tolerance (docs/theory/repair.md,
  /// "Prices").
  static constexpr double fairness = 300;

  const std::vector<Joint>& joints_;
  const ContinuityTolerance& tolerance_;
  MovingFaces& movers_;
  const Progress& progress_;
  std::vector<std::vector<JointSample>> samples_;  ///< by joint
  std::vector<double> missed_;                     ///< by joint
  std::map<int, std::vector<int>> unknown_;  ///< by face and coefficient: its number, -1: it stays
  int unknowns_ = 0;
  double ease_ = 1;  ///< factor on energies, see easeBy()
  std::vector<std::vector<int>> cells_;
  std::map<std::vector<int>, int> cell_numbers_;
  std::vector<FaceEnergy> energies_;
};

}  // namespace

FairResult fairSolve(const std::vector<Joint>& joints, const ContinuityTolerance& tolerance,
                     const FairStart& start, MovingFaces& movers, const Progress& progress) {
  return FairSolving(joints, tolerance, movers, progress).run(start);
}

}  // namespace seamwright::occ
