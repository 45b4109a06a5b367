// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/differential/jet.hpp>

/// The derivatives of both curves at a joint, from the 2n + 1 poles beside it; not a public header.
namespace seamwright::blending {

/// Derivatives of orders 0..n by the curves' own parameters; the point is the origin.
struct JointJet {
  CurveDerivatives a, b;
  int degree_a = 0, degree_b = 0;
  double noise_a = 0, noise_b = 0;  ///< bounds of the rounding in the first derivatives
};

/// \param poles rows -n..n, homogeneous. \pre both degrees are at least n.
JointJet jointJet(const HomogeneousPoles& poles, int degree_a, int degree_b);

/// beta_1..beta_n by C2.6; fewer where a beta_1 is not positive or not finite.
Eigen::VectorXd projectedBetas(const JointJet& jet);

/// D_0..D_n of C2.5 in units of \p length_mm; empty if a tangent is lost.
std::vector<double> jointDefects(const JointJet& jet, double length_mm);

/// What the k-th row of the beta constraint leaves, |b_k - sum_j B_kj a_j| L^(k-1) / |b_1|^k for
/// k = 1..n, the betas being \p beta.
std::vector<double> rowDefects(const JointJet& jet, const Eigen::VectorXd& beta, double length_mm);

/// The largest of 1 and s_k^(1/(k-1)) L for k = 2..n (C2.5): defects of order k have the condition
/// sharpness^(k-1). Infinite if a tangent is lost.
double sharpnessOf(const JointJet& jet, double length_mm);

/// What rounding of the poles alone can add to D_0..D_n, to a small factor: a derivative of order k
/// is m!/(m-k)! times a difference of poles with binomials that add up to 2^k, each pole rounded.
/// \param sharpness of the joint.
std::vector<double> roundingDefects(const HomogeneousPoles& poles, const JointJet& jet,
                                    double length_mm, double sharpness);

/// Poles without their weights.
Poles pointsOf(const HomogeneousPoles& poles);

}  // namespace seamwright::blending
