// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <seamwright/occ_adapter/repair/step_problem.hpp>

namespace seamwright::occ {

namespace {

/// Price of the energy that spends a face's budget, in terms of a sample that stands for a
/// sixteenth of a seam and misses by a quarter of its tolerance (docs/theory/repair.md, "Prices").
constexpr double price_of_budget = 300;

/// Weight of the sum of squares of the coefficients. It stands for the integral of |D|^2 / size^4,
/// as if the coefficients were evenly distributed over the face. The size of the move is secondary,
/// except for faces that moved too far.
double sizeFactor(const MovingFace& mover) {
  const double of_size =
      std::pow(price_of_budget * mover.stiffness / (mover.budget_per_mm * mover.size_mm), 2) /
      mover.area_mm2;
  return (of_size + std::pow(price_of_budget / mover.restraint_mm, 2)) / mover.displacement.count();
}

}  // namespace

StepProblem::StepProblem(const std::vector<Joint>& joints, JointSamples& samples,
                         MovingFaces& movers, const FreeCoefficients& unknowns)
    : joints_(joints),
      samples_(samples),
      movers_(movers),
      unknowns_(unknowns),
      system_(prepared()) {}

int StepProblem::cellOf(std::vector<int> unknowns) {
  const auto [found, is_new] = cell_numbers_.emplace(unknowns, static_cast<int>(cells_.size()));
  if (is_new) cells_.push_back(std::move(unknowns));
  return found->second;
}

StepSystem StepProblem::prepared() {
  prepareEnergies();
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (JointSample& sample : samples_[j]) prepareSample(joints_[j], sample);
  return {unknowns_.count(), cells_};
}

void StepProblem::prepareEnergies() {
  for (const auto& [face, mover] : movers_) {
    const std::vector<int>& unknown = unknowns_.of(face);
    const double unit =
        std::pow(price_of_budget * mover.stiffness / mover.budget_per_mm, 2) / mover.area_mm2;
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

void StepProblem::prepareSample(const Joint& joint, JointSample& sample) {
  std::vector<int> unknowns;
  for (std::size_t k = 0; k < sample.sides.size(); ++k)
    if (sample.sides[k].mover != nullptr)
      for (const int coefficient : sample.sides[k].shares.poles)
        if (const int number = unknowns_.of(joint.sides[k].face)[coefficient]; number >= 0)
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
      const int number = unknowns_.of(joint.sides[k].face)[coefficient];
      side.column.push_back(
          number < 0 ? -1 : std::ranges::lower_bound(unknowns, number) - unknowns.begin());
    }
  }
  sample.cell = cellOf(std::move(unknowns));
}

void StepProblem::assemble() {
  system_.clear();
  for (const FaceEnergy& energy : energies_) {
    const PointRows& all = movers_.at(energy.face).displacement.coefficients();
    const PointRows at = all(energy.block.coefficients, Eigen::indexing::all);
    const PointRows gradient = energy.block.matrix * at;
    system_.addEnergy(energy.cell, ease_ * energy.block.matrix(energy.free, energy.free),
                      ease_ * gradient(energy.free, Eigen::indexing::all));
  }
  for (auto& [face, mover] : movers_) addDamping(face, mover);
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (const JointSample& sample : samples_[j])
      if (sample.cell >= 0) addConditions(joints_[j], sample, system_);
}

void StepProblem::addDamping(int face, const MovingFace& mover) {
  const std::vector<int>& unknown = unknowns_.of(face);
  const double factor = ease_ * sizeFactor(mover);
  for (std::size_t k = 0; k < unknown.size(); ++k)
    if (unknown[k] >= 0)
      system_.addDamping(
          unknown[k], factor,
          mover.displacement.coefficients().row(static_cast<Eigen::Index>(k)).transpose());
}

void StepProblem::take(const PointRows& step) {
  for (auto& [face, mover] : movers_) {
    PointRows own = mover.displacement.coefficients();
    const std::vector<int>& unknown = unknowns_.of(face);
    for (std::size_t k = 0; k < unknown.size(); ++k)
      if (unknown[k] >= 0) own.row(static_cast<Eigen::Index>(k)) += step.row(unknown[k]);
    mover.displacement.setCoefficients(std::move(own));
  }
}

double StepProblem::cost() const {
  double sum = 0;
  for (const FaceEnergy& energy : energies_) {
    const PointRows& all = movers_.at(energy.face).displacement.coefficients();
    const PointRows at = all(energy.block.coefficients, Eigen::indexing::all);
    sum += ease_ * (at.transpose() * energy.block.matrix * at).trace();
  }
  for (const auto& [face, mover] : movers_)
    sum += ease_ * sizeFactor(mover) * mover.displacement.coefficients().squaredNorm();
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (const JointSample& sample : samples_[j])
      if (sample.cell >= 0) sum += costOf(joints_[j], sample);
  return sum;
}

void StepProblem::step(double ease) {
  // Marquardt's factors on the diagonal; 0 is the undamped Gauss-Newton step.
  constexpr std::array<double, 4> dampings = {0, 1e-3, 3e-2, 1};
  // Choices: a step that a quarter of it does not make better points the wrong way, and more
  // damping turns it towards the gradient.
  constexpr int halvings = 2;
  ease_ = ease;
  assemble();
  const double before = cost();
  for (const double damping : dampings) {
    system_.damp(damping);
    PointRows step = system_.solve();
    for (int k = 0; k <= halvings; ++k) {
      take(step);
      if (cost() <= before) return;
      take(-step);
      step *= 0.5;
    }
  }
}

}  // namespace seamwright::occ
