// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/blend/balance.hpp>
#include <seamwright/core/blend/plain_blend.hpp>

namespace seamwright {

/// How a blended joint was made G^n, in the order in which the means are tried.
enum class BlendRemedy {
  Plain,              ///< linear blending keeps the joint
  Balanced,           ///< the auxiliary points are blended and cut down
  SmallestMove,       ///< linear blending, then the smallest move that makes the joint exact
  IntermediateFrame,  ///< the same with a key frame between, whose tangent is half turned
  Intrinsic,          ///< lengths and turning angles of the polygon are blended: G1 only
};

/// The name of the enumerator in words, such as "smallest move".
std::string nameOf(BlendRemedy remedy);

struct JointBlendOptions {
  int order = 2;  ///< n of G^n, 1 to 6
  /// Key frames are refused if one of D_0..D_n (BetaFit::defects) is above.
  double frame_tolerance = 1e-6;
  /// A result is accepted if D_0..D_n <= most_defect, or if rounding of the poles explains more.
  double most_defect = 1e-11;
  /// G1: tangents of all key frames that differ by at most this angle are parallel. The joint then
  /// takes its beta from linear blending, and moves by about this share of a leg or less: curves
  /// between with the lines of both remain lines. A choice, above what digits of files turn.
  double parallel_rad = 1e-4;
  /// Curves are raised up to this degree if that makes Balanced possible with defects within
  /// most_defect; rounding of the poles of high degrees may exceed it. Up to 25.
  int max_degree = 20;
  /// Tangents of accepted results are at least this share of the shorter one of the key frames.
  double least_tangent = 0.05;
  /// Balanced is accepted if it moves no pole beside the joint farther from linear blending than
  /// this, in units of L. Infinite: no bound.
  double most_departure = 1;
  /// false: betas are blended as those of Balanced. true: SmallestMove looks for the betas of the
  /// smallest move (nearestJoin()); then poles can jump from one local minimum to another.
  bool free_betas = false;
  BalanceGuards guards = {};

  /// \throws std::invalid_argument, with the value, for a number out of its range.
  void validate() const;
};

/// A joint between key frames.
struct BlendedJoint {
  BezierCurve a, b;
  int order = 0;         ///< of the join that was made; below that of the options for Intrinsic
  Eigen::VectorXd beta;  ///< beta_1 .. beta_order; nothing for an order of 0
  std::vector<double> defects;  ///< D_0 .. D_order, measured
  BlendRemedy remedy = BlendRemedy::Plain;
  double moved_mm = 0;  ///< largest distance of a pole from that of linear blending
  /// Why the means before the remedy failed, for all omega or at this one. It may be empty where a
  /// defect or a departure is too large.
  std::vector<BalanceFault> faults = {};
};

namespace blending {
class JointPath;
}

/// Blends two joints such that each curve between is G^n at its joint.
///
/// Poles -n..n beside the joint are adjusted, the others are blended linearly. The means are tried
/// in the order of BlendRemedy. One of them is chosen for all omega, when the object is made, from
/// nine omegas; where it fails at another omega the next ones are tried there. The tangents between
/// these omegas are checked in closed form where they are linear in omega.
///
/// beta_1 = ((1 - omega) beta_1^0 + lambda omega beta_1^1) / ((1 - omega) + lambda omega) with
/// lambda the ratio of a's first derivatives; beta_k for k >= 2 is blended linearly.
///
/// Curves of degree below n are raised to n, those of different degrees to the higher one. Raising
/// further, up to max_degree, makes Balanced possible as a rule: the first degree is taken at which
/// it is (both curves are raised alike).
///
/// Rational curves: homogeneous poles are blended, as they are given: a factor common to all poles
/// of a frame changes the blend. Weights at the joint must be equal. Balanced is possible if the
/// homogeneous poles of both frames meet the relations; otherwise SmallestMove, which keeps the
/// blended weights.
///
/// Identities (each has a test of its number):
///   (1) omega = 0 and 1: the key frames, raised, bitwise.
///   (2) The joint has the order and the betas of the result; defects are rounding. Measured for
///       2000 random frames of each n: at most 1e-11 for n <= 2, and for 99.7, 98.8, 89 and 82 % of
///       those with n = 3 to 6. None of the others exceeds a quarter of what a change of each pole
///       beside the joint by 2^-52 of the largest coordinate makes, so poles of doubles can't
///       promise less: a derivative of order k is a k-th difference of poles.
///   (3) Frames with equal betas: linear blending.
///   (4) n = 1: only the pole at the joint differs from linear blending, P_0 = (m beta_1 P_(-1) +
///       m' P_1) / (m' + m beta_1).
///   (5) Rigid motion and scale act on the result in the same way.
///   (6) Frames exchanged: omega turns into 1 - omega. For n = 1, frames reversed (and a, b
///       exchanged): the result is reversed. For n >= 2 it is another blend with other betas, as
///       beta_2, .. are those of the curve that leaves. Both up to rounding.
///   (7) Some remedy is always found: Intrinsic needs tangents of the key frames only.
/// Source: docs/theory/curves.md C11.1 to C11.7; [BarskyDeRose1990].
class JointBlend {
 public:
  /// \throws std::invalid_argument for invalid options, curves that do not meet or have different
  /// weights at the joint, and a frame that is not G^n within the tolerance, with its number, the
  /// order and the defect.
  JointBlend(const JointFrame& first, const JointFrame& second,
             const JointBlendOptions& options = {});

  /// The means chosen for all omega.
  BlendRemedy remedy() const;
  int degreeA() const;
  int degreeB() const;

  /// \param omega 0 to 1. \throws std::invalid_argument for another omega.
  BlendedJoint at(double omega) const;

 private:
  JointFrame first_, second_;
  std::shared_ptr<const blending::JointPath> path_;  ///< never changes, so copies share it
};

/// One omega only. \throws as JointBlend does.
BlendedJoint blendJoint(const JointFrame& first, const JointFrame& second, double omega,
                        const JointBlendOptions& options = {});

}  // namespace seamwright
