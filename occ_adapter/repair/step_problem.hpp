// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <vector>

#include <seamwright/occ_adapter/repair/free_coefficients.hpp>
#include <seamwright/occ_adapter/repair/joint.hpp>
#include <seamwright/occ_adapter/repair/step_system.hpp>

/// One step towards the fair solution. Not a public header.
namespace seamwright::occ {

using JointSamples = std::vector<std::vector<JointSample>>;  ///< by joint

/// The least-squares problem of given samples and unknowns: bending energies relative to the
/// budgets of the faces, sizes of the moves, and conditions of the samples relative to their
/// tolerances. Source: docs/theory/repair.md.
class StepProblem {
 public:
  /// \param samples get their cells in the system. All is kept by reference.
  StepProblem(const std::vector<Joint>& joints, JointSamples& samples, MovingFaces& movers,
              const FreeCoefficients& unknowns);

  /// Moves the faces by the Gauss-Newton step. If it does not reduce the cost it is halved, at most
  /// twice, and then replaced by a damped step.
  /// \param ease factor of energies and sizes.
  void step(double ease);

 private:
  struct FaceEnergy {
    int face = 0, cell = 0;
    EnergyBlock block;
    std::vector<Eigen::Index> free;  ///< indices in the block
  };

  int cellOf(std::vector<int> unknowns);
  StepSystem prepared();
  void prepareEnergies();
  void prepareSample(const Joint& joint, JointSample& sample);
  void assemble();
  void addDamping(int face, const MovingFace& mover);
  void take(const PointRows& step);
  double cost() const;

  const std::vector<Joint>& joints_;
  JointSamples& samples_;
  MovingFaces& movers_;
  const FreeCoefficients& unknowns_;
  double ease_ = 1;
  std::vector<std::vector<int>> cells_;  ///< sets of unknowns that occur together in a condition
  std::map<std::vector<int>, int> cell_numbers_;
  std::vector<FaceEnergy> energies_;
  StepSystem system_;
};

}  // namespace seamwright::occ
