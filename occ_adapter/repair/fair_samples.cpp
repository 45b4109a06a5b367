// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/occ_adapter/repair/fair_samples.hpp>

namespace seamwright::occ {

namespace {

/// The weight of the sample that is nearest.
double nearestWeight(const SampleWeights& weights, double s) {
  return std::ranges::min_element(weights, {},
                                  [s](const auto& one) { return std::abs(one.first - s); })
      ->second;
}

}  // namespace

FairSamples::FairSamples(const std::vector<Joint>& joints, const ContinuityTolerance& tolerance,
                         const MovingFaces& movers,
                         const std::map<std::size_t, SampleWeights>& earlier)
    : joints_(joints), tolerance_(tolerance) {
  for (const Joint& joint : joints) {
    samples_.push_back(sampled(joint, movers, tolerance));
    const auto known = earlier.find(joint.seam);
    if (joint.ask == Ask::Outline || known == earlier.end()) continue;
    for (JointSample& sample : samples_.back())
      sample.weight = std::sqrt(nearestWeight(known->second, sample.s));
  }
  measure();
}

double FairSamples::worst() const {
  return missed_.empty() ? 0 : std::ranges::max(missed_);
}

std::size_t FairSamples::worstJoint() const {
  return static_cast<std::size_t>(std::ranges::max_element(missed_) - missed_.begin());
}

void FairSamples::measure() {
  missed_.assign(joints_.size(), 0);
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (JointSample& sample : samples_[j]) {
      followSlide(sample);
      followCurvature(joints_[j], tolerance_, sample);
      sample.ratio = missedShare(joints_[j], sample);
      missed_[j] = std::max(missed_[j], sample.ratio);
    }
}

void FairSamples::addWeight(double largest_weight) {
  // If misses were inverse to weights, a sample would miss this share of what counts as met after
  // the next pass. The limit of growth keeps a pass from spoiling the solution for other samples.
  constexpr double aimed_share = 0.7, most_growth = 5;
  for (auto& samples : samples_)
    for (JointSample& sample : samples)
      if (sample.ratio > met_share)
        sample.weight = std::min(
            largest_weight,
            sample.weight * std::min(most_growth, sample.ratio / (aimed_share * met_share)));
}

FairSamples::Weights FairSamples::weights() const {
  Weights weights;
  for (const auto& samples : samples_) {
    weights.emplace_back();
    for (const JointSample& sample : samples) weights.back().push_back(sample.weight);
  }
  return weights;
}

void FairSamples::setWeights(const Weights& weights) {
  for (std::size_t j = 0; j < samples_.size(); ++j)
    for (std::size_t i = 0; i < samples_[j].size(); ++i) samples_[j][i].weight = weights[j][i];
}

std::map<std::size_t, SampleWeights> FairSamples::weightsBySeam() const {
  std::map<std::size_t, SampleWeights> weights;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    if (joints_[j].ask != Ask::Outline)
      for (const JointSample& sample : samples_[j])
        weights[joints_[j].seam].emplace_back(sample.s, sample.weight);
  return weights;
}

std::map<int, std::set<int>> FairSamples::missedCoefficients() const {
  std::map<int, std::set<int>> coefficients;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (const JointSample& sample : samples_[j]) {
      if (sample.ratio <= met_share) continue;
      for (std::size_t k = 0; k < sample.sides.size(); ++k)
        if (const JointSide& side = sample.sides[k]; side.mover != nullptr)
          for (const int coefficient : side.mover->displacement.coefficientsNear(side.uv))
            coefficients[joints_[j].sides[k].face].insert(coefficient);
    }
  return coefficients;
}

std::map<int, HalvedSpans> FairSamples::missedSpans() const {
  // Least length of a span as a share of the surface. It keeps a fair face from being spent on a
  // seam that needs much in a short interval (docs/theory/repair.md, "What cannot be repaired
  // fairly").
  constexpr double shortest = 1.0 / 128;
  std::map<int, HalvedSpans> spans;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    for (const JointSample& sample : samples_[j]) {
      if (sample.ratio <= met_share) continue;
      for (std::size_t k = 0; k < sample.sides.size(); ++k) {
        const JointSide& side = sample.sides[k];
        if (side.mover == nullptr) continue;
        const SurfaceBasis& basis = side.mover->displacement.basis();
        for (const int direction : {0, 1}) {
          const SplineAxis& axis = direction == 0 ? basis.u() : basis.v();
          double t = side.uv[direction];
          const int span = axis.span(t, side.into[direction]);
          if (axis.length(span) > shortest * (axis.last - axis.first))
            spans[joints_[j].sides[k].face][direction].insert(span);
        }
      }
    }
  return spans;
}

NaturalSides FairSamples::naturalSides(const MovingFaces& movers) const {
  std::vector<bool> gaps_stay;
  for (std::size_t j = 0; j < joints_.size(); ++j)
    gaps_stay.push_back(joints_[j].ask == Ask::Keep ||
                        std::ranges::all_of(samples_[j], &JointSample::keeps_gap));
  return {joints_, gaps_stay, movers};
}

void FairSamples::sampleAgain(const std::map<int, HalvedSpans>& halved, const MovingFaces& movers) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const bool is_beside = std::ranges::any_of(
        joints_[j].sides, [&halved](const Coedge& side) { return halved.count(side.face) > 0; });
    if (!is_beside) continue;
    SampleWeights weights;
    for (const JointSample& sample : samples_[j]) weights.emplace_back(sample.s, sample.weight);
    samples_[j] = sampled(joints_[j], movers, tolerance_);
    for (JointSample& sample : samples_[j]) sample.weight = nearestWeight(weights, sample.s);
  }
}

}  // namespace seamwright::occ
