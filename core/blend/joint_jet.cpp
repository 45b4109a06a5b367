// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/blend/joint_jet.hpp>
#include <seamwright/core/join/curve/bell.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

namespace seamwright::blending {

namespace {

using Eigen::Index;

/// Of a curve that begins with these poles, the first point being the origin.
CurveDerivatives derivativesAtStart(HomogeneousPoles poles, int degree) {
  const Index n = poles.rows() - 1;
  HomogeneousPoles h(n + 1, 4);
  double factor = 1;
  for (Index k = 0; k <= n; ++k) {
    h.row(k) = factor * poles.row(0);
    factor *= static_cast<double>(degree - k);
    for (Index i = 0; i + 1 < poles.rows() - k; ++i) poles.row(i) = poles.row(i + 1) - poles.row(i);
  }
  CurveDerivatives x(n + 1, 3);
  for (Index k = 0; k <= n; ++k) {
    x.row(k) = h.row(k).head<3>();
    for (Index i = 1; i <= k; ++i) x.row(k) -= bernstein::binomials(k)(i) * h(i, 3) * x.row(k - i);
    x.row(k) /= h(0, 3);
  }
  return x;
}

/// b_k - sum_{j >= first} B_kj a_j.
Eigen::RowVector3d rowRest(const JointJet& jet, const Eigen::MatrixXd& bell, Index k, Index first) {
  Eigen::RowVector3d rest = jet.b.row(k);
  for (Index j = first; j <= k; ++j) rest -= bell(k, j) * jet.a.row(j);
  return rest;
}

}  // namespace

Poles pointsOf(const HomogeneousPoles& poles) {
  return poles.leftCols<3>().array().colwise() / poles.col(3).array();
}

JointJet jointJet(const HomogeneousPoles& poles, int degree_a, int degree_b) {
  const Index n = (poles.rows() - 1) / 2;
  const Eigen::RowVector3d origin = poles.row(n).head<3>() / poles(n, 3);
  HomogeneousPoles moved = poles;
  moved.leftCols<3>() -= poles.col(3) * origin;
  JointJet jet{derivativesAtStart(moved.topRows(n + 1).colwise().reverse(), degree_a),
               derivativesAtStart(moved.bottomRows(n + 1), degree_b), degree_a, degree_b};
  for (Index k = 1; k <= n; k += 2) jet.a.row(k) *= -1;
  const double noise = 8 * machine_epsilon * pointsOf(poles).cwiseAbs().maxCoeff();
  jet.noise_a = noise * degree_a;
  jet.noise_b = noise * degree_b;
  return jet;
}

Eigen::VectorXd projectedBetas(const JointJet& jet) {
  const Index n = jet.a.rows() - 1;
  const double speed = jet.a.row(1).stableNorm();
  Eigen::VectorXd beta = Eigen::VectorXd::Zero(n);
  for (Index k = 1; k <= n; ++k) {
    const Eigen::MatrixXd bell = bellMatrix<double>(Eigen::VectorXd(beta.head(k)));
    beta(k - 1) = (jet.a.row(1) / speed).dot(rowRest(jet, bell, k, 2)) / speed;
    if (!(beta(0) > 0) || !std::isfinite(beta(k - 1))) return beta.head(k - 1);
  }
  return beta;
}

std::vector<double> jointDefects(const JointJet& jet, double length_mm) {
  CurveJoint joint = measureJoint({jet.a, jet.noise_a}, {jet.b, jet.noise_b});
  double power = 1 / length_mm;
  for (double& difference : joint.differences) {
    difference *= power;
    power *= length_mm;
  }
  return joint.differences;
}

std::vector<double> rowDefects(const JointJet& jet, const Eigen::VectorXd& beta, double length_mm) {
  const Eigen::MatrixXd bell = bellMatrix<double>(beta);
  const double unit = length_mm / jet.b.row(1).stableNorm();
  std::vector<double> result;
  double power = 1 / length_mm;
  for (Index k = 1; k <= beta.size(); ++k) {
    power *= unit;
    result.push_back(rowRest(jet, bell, k, 1).stableNorm() * power);
  }
  return result;
}

double sharpnessOf(const JointJet& jet, double length_mm) {
  const CurveJoint joint = measureJoint({jet.a, jet.noise_a}, {jet.b, jet.noise_b});
  if (joint.sizes.empty()) return infinite;
  double result = 1;
  for (std::size_t k = 2; k < joint.sizes.size(); ++k)
    result =
        std::max(result, std::pow(joint.sizes[k], 1 / (static_cast<double>(k) - 1)) * length_mm);
  return result;
}

std::vector<double> roundingDefects(const HomogeneousPoles& poles, const JointJet& jet,
                                    double length_mm, double sharpness) {
  const Index n = jet.a.rows() - 1;
  std::vector<double> result(n + 1, 0.0);
  const double pole = machine_epsilon * pointsOf(poles).cwiseAbs().maxCoeff();
  for (const auto& [speed, degree] : {std::pair(jet.a.row(1).stableNorm(), jet.degree_a),
                                      std::pair(jet.b.row(1).stableNorm(), jet.degree_b)}) {
    double share = pole / length_mm;
    for (Index k = 0; k <= n; ++k) {
      const double power = static_cast<double>(std::max<Index>(k - 1, 0));
      result[k] += share * std::pow(sharpness, power);
      share *= 2 * length_mm * static_cast<double>(degree - k) / speed;
    }
  }
  return result;
}

}  // namespace seamwright::blending
