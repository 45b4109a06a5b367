// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <vector>

#include <seamwright/core/blend/joint_blend.hpp>
#include <seamwright/core/blend/key_interpolation.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

struct SplineBlendOptions {
  /// Of all joints. Its max_degree is that of the splines: they are raised to the first degree up
  /// to it at which every joint is Plain or Balanced, if there is one. The default raises them only
  /// as far as joints that do not share poles need.
  JointBlendOptions joint = {.max_degree = 0};
  KeyInterpolation::Continuity continuity = KeyInterpolation::Continuity::C0;
  /// false: a joint of a key frame that is not G^n within joint.frame_tolerance is refused. true: a
  /// joint keeps the order that all key frames have there, so that a corner stays a corner.
  bool keep_lower_orders = false;
};

/// A joint of a blended spline.
struct SplineJoint {
  int knot = 0;   ///< index of its knot; of the joint that closes a spline, the last one
  int order = 0;  ///< of the join that was made
  Eigen::VectorXd beta = {};         ///< beta_1 .. beta_order, by the segments' parameters 0..1
  std::vector<double> defects = {};  ///< D_0 .. D_order, measured
  BlendRemedy remedy = BlendRemedy::Plain;
  double moved_mm = 0;  ///< largest distance of a pole from that of linear blending
  std::vector<BalanceFault> faults = {};  ///< as of BlendedJoint
};

struct SplineFrame {
  BezierSpline spline;
  std::vector<SplineJoint> joints;  ///< in the order of measureJoints()
};

/// Blends splines such that each spline between is G^n at every joint.
///
/// Key frames have the same number of segments, the same degree, and are all open or all closed;
/// segment i of one corresponds to segment i of the others, parameter by parameter. Poles and knots
/// are interpolated by omega, then the poles -n..n beside each joint are adjusted as JointBlend
/// does. Joints share no pole if the degree is at least 2n + 1; splines of a lower degree are
/// raised before.
///
/// By omega poles, auxiliary points and beta_2, .., beta_n are interpolated as KeyInterpolation
/// says. beta_1 remains positive: for C0 it is the blended speed after the joint by that before it
/// (C11.5), for C1 and C2 log beta_1 is interpolated. Knots are interpolated linearly, so that they
/// increase. With SmallestMove the poles are as smooth by omega, with IntermediateFrame and
/// Intrinsic they are C0.
///
/// Preparing costs a few milliseconds a joint and interval; a frame costs O(segments n^3).
///
/// Identities (each has a test of its number):
///   (1) At the omega of a key: the key frame, raised, bitwise.
///   (2) All joints have the order and the betas of the result; defects are rounding.
///   (3) If the key frames have equal betas at a joint, its poles are those of the interpolation;
///       so C^n splines with knots in proportion are interpolated.
///   (4) Rigid motion and scale act on frames in the same way.
///   (5) Key frames in reverse order: omega is reversed. Key frames run backwards: the frames are,
///       for n = 1; beta_2, .., beta_n are blended linearly on one side (C11.5).
///   (6) Two key frames of two segments: the joint of JointBlend.
/// Source: docs/theory/curves.md C11.1 to C11.8.
class SplineBlend {
 public:
  /// \param omegas one per key frame, increasing.
  /// \throws std::invalid_argument, with index and value, for invalid options and splines, key
  /// frames that do not correspond, closed rational splines whose first and last weights differ,
  /// and for a joint that is not G^n: with key frame, knot, order and defect.
  SplineBlend(const std::vector<BezierSpline>& keys, const std::vector<double>& omegas,
              const SplineBlendOptions& options = {});

  int degree() const;
  /// Of each joint.
  std::vector<int> orders() const;
  std::vector<BlendRemedy> remedies() const;

  /// \throws std::invalid_argument for an omega outside of the keys'. \throws std::domain_error if
  /// a weight comes out not positive, which only C1 and C2 of rational splines can cause.
  SplineFrame frameAt(double omega) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;  ///< never changes, so copies share it
};

}  // namespace seamwright
