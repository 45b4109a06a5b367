// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <set>
#include <vector>

#include <seamwright/occ_adapter/repair/fair_solve.hpp>
#include <seamwright/occ_adapter/repair/natural_sides.hpp>
#include <seamwright/occ_adapter/repair/step_problem.hpp>

/// The samples of joints while their faces move. Not a public header.
namespace seamwright::occ {

/// A sample is met if it misses less than this share of the tolerance. The rest is a reserve for
/// points between samples.
constexpr double met_share = 0.6;

/// Spans of a displacement that are halved, by direction.
using HalvedSpans = std::array<std::set<int>, 2>;

/// Samples with their weights and misses. The misses are those of the faces as they were when they
/// were last measured.
class FairSamples {
 public:
  /// \param earlier weights by seam, of an earlier solution. Each sample gets the square root of
  /// the nearest one, since the reason for a large weight may be gone.
  FairSamples(const std::vector<Joint>& joints, const ContinuityTolerance& tolerance,
              const MovingFaces& movers, const std::map<std::size_t, SampleWeights>& earlier);

  const std::vector<Joint>& joints() const { return joints_; }
  /// By joint. A StepProblem gives the samples their cells.
  JointSamples& samples() { return samples_; }
  /// By joint: the largest miss of a sample over its tolerance.
  const std::vector<double>& missed() const { return missed_; }
  double worst() const;
  std::size_t worstJoint() const;
  bool areMet() const { return worst() <= met_share; }

  /// Measures the misses of the faces as they are now.
  void measure();
  /// Gives missed samples more weight.
  void addWeight(double largest_weight);

  using Weights = std::vector<std::vector<double>>;  ///< by joint and sample
  Weights weights() const;
  void setWeights(const Weights& weights);
  /// The weights by seam; outlines have none.
  std::map<std::size_t, SampleWeights> weightsBySeam() const;

  /// By face: the coefficients of displacements beside missed samples.
  std::map<int, std::set<int>> missedCoefficients() const;
  /// By face: the spans of displacements beside missed samples, except short ones.
  std::map<int, HalvedSpans> missedSpans() const;
  /// Ties the sides of faces whose gap need not change.
  NaturalSides naturalSides(const MovingFaces& movers) const;

  /// Samples the joints of these faces again, as densely as their new knots need. Each sample takes
  /// over the weight of the nearest old one.
  void sampleAgain(const std::map<int, HalvedSpans>& halved, const MovingFaces& movers);

 private:
  const std::vector<Joint>& joints_;
  const ContinuityTolerance& tolerance_;
  JointSamples samples_;
  std::vector<double> missed_;
};

}  // namespace seamwright::occ
