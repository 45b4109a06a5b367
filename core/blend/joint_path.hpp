// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/blend/joint_blend.hpp>
#include <seamwright/core/blend/joint_jet.hpp>
#include <seamwright/core/blend/key_interpolation.hpp>

/// One joint through all key frames: the poles beside it by omega; not a public header.
/// Source: docs/theory/curves.md C11.5 to C11.8.
namespace seamwright::blending {

/// A joint in a key frame.
struct JointKey {
  HomogeneousPoles poles;  ///< rows -n..n
  Eigen::VectorXd beta;    ///< beta_1..beta_n
  double length_mm = 0;    ///< L
  double speed_mm = 0;     ///< |a_1|
  Poles far = {};          ///< the other ends of both curves
};

struct JointKeys {
  KeyInterpolation in_omega;
  std::vector<JointKey> keys;
};

struct JointDegrees {
  int a = 0, b = 0;
};

struct JointState {
  HomogeneousPoles poles = {};  ///< rows -n..n
  Eigen::VectorXd beta = {};
  BlendRemedy remedy = BlendRemedy::Plain;
  int order = 0;
  double moved_mm = 0;
  std::vector<BalanceFault> faults = {};
  /// Vectors that must not vanish between this omega and the next, in units of the shorter one of
  /// the key frames beside.
  std::vector<Eigen::Vector3d> tangents = {};
};

/// The pole rows and betas of all keys at omega. beta_1 is positive.
HomogeneousPoles plainPoles(const JointKeys& keys, double omega);
Eigen::VectorXd blendedBetas(const JointKeys& keys, double omega);
/// The largest distance of points with the same number.
double largestDistance(const HomogeneousPoles& x, const HomogeneousPoles& y);

class JointPath {
 public:
  /// \param last means after it are not looked for, which saves time where they are of no use.
  /// \pre keys have an order of 1 at least and regular tangents.
  JointPath(JointKeys keys, JointDegrees degrees, const JointBlendOptions& options,
            BlendRemedy last = BlendRemedy::Intrinsic);

  BlendRemedy remedy() const { return remedy_; }
  bool isBalanced() const { return remedy_ <= BlendRemedy::Balanced; }
  int order() const { return static_cast<int>(keys_.keys.front().beta.size()); }
  /// At the omega of a key its poles, bitwise.
  JointState at(double omega) const;

 private:
  std::optional<JointState> tried(BlendRemedy remedy, double omega,
                                  std::vector<BalanceFault>& faults) const;
  std::optional<JointState> plain(double omega, std::vector<BalanceFault>& faults) const;
  std::optional<JointState> balanced(double omega, std::vector<BalanceFault>& faults) const;
  std::optional<JointState> moved(const JointKeys& keys, double omega,
                                  std::vector<BalanceFault>& faults) const;
  bool hasTangents(const std::vector<Eigen::Vector3d>& tangents,
                   std::vector<BalanceFault>& faults) const;
  JointState intrinsic(double omega) const;
  JointState key(int i) const;
  double lengthAt(const HomogeneousPoles& poles, double omega) const;
  std::vector<double> allowedDefects(const HomogeneousPoles& poles, const JointJet& jet,
                                     double length) const;
  bool isAccepted(const JointState& state, double omega) const;
  /// In the interval of keys i and i + 1.
  bool holds(BlendRemedy remedy, int i, std::vector<BalanceFault>& faults) const;
  bool holds(BlendRemedy remedy, std::vector<BalanceFault>& faults) const;
  bool isPlain() const;
  bool isParallel() const;
  Eigen::VectorXd betasAt(const JointKeys& keys, const HomogeneousPoles& poles, double omega) const;
  void solvePoints();
  void addIntermediateKeys();

  JointKeys keys_;
  JointDegrees degrees_;
  JointBlendOptions options_;
  std::vector<Eigen::MatrixXd> points_;   ///< auxiliary points of each key; none if not balanced
  std::vector<BalanceFault> key_faults_;  ///< why there are none
  std::optional<JointKeys> with_intermediate_;
  std::vector<BalanceFault> faults_;  ///< why means before the chosen one do not hold
  bool plain_ = false;
  bool parallel_ = false;  ///< G1 with one tangent in all keys: linear blending fixes beta
  BlendRemedy remedy_ = BlendRemedy::Intrinsic;
};

}  // namespace seamwright::blending
