// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/blend/joint_blend.hpp>
#include <seamwright/core/blend/joint_frame.hpp>
#include <seamwright/core/blend/joint_jet.hpp>
#include <seamwright/core/blend/joint_path.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using bernstein::text;

/// beta_1..beta_n of a frame, checked.
BetaFit checkedFit(const JointFrame& frame, const std::string& name,
                   const JointBlendOptions& options) {
  BetaFit fit = fitBeta(frame.a, frame.b, options.order);
  for (std::size_t k = 0; k < fit.defects.size(); ++k)
    if (!(fit.defects[k] <= options.frame_tolerance))
      refuse(name + " is not G" + std::to_string(k) + ": defect " + text(fit.defects[k]) +
             ", allowed " + text(options.frame_tolerance));
  if (fit.beta.size() < options.order)
    refuse(name + " has no tangent at the joint, or turns back there: beta_" +
           std::to_string(fit.beta.size() + 1) + " does not exist");
  return fit;
}

BezierCurve plainCurve(const BezierCurve& x, const BezierCurve& y, double omega) {
  const HomogeneousPoles &from = x.homogeneousPoles(), &to = y.homogeneousPoles();
  return BezierCurve::fromHomogeneous(from + omega * (to - from));
}

/// The curve with its last poles (of a) or its first ones (of b) replaced.
BezierCurve withPoles(const BezierCurve& curve, const HomogeneousPoles& near, bool at_end) {
  HomogeneousPoles poles = curve.homogeneousPoles();
  (at_end ? poles.bottomRows(near.rows()) : poles.topRows(near.rows())) = near;
  return BezierCurve::fromHomogeneous(std::move(poles));
}

blending::JointPath pathOf(const JointFrame& first, const BetaFit& fit, const JointFrame& second,
                           const BetaFit& second_fit, const JointBlendOptions& options,
                           BlendRemedy last = BlendRemedy::Intrinsic) {
  return {{KeyInterpolation({0, 1}, KeyInterpolation::Continuity::C0),
           {blending::keyOf(first, fit), blending::keyOf(second, second_fit)}},
          {first.a.degree(), first.b.degree()},
          options,
          last};
}

}  // namespace

std::string nameOf(BlendRemedy remedy) {
  constexpr std::array names = {"plain", "balanced", "smallest move", "intermediate frame",
                                "intrinsic"};
  return names.at(static_cast<std::size_t>(remedy));
}

void JointBlendOptions::validate() const {
  if (order < 1 || order > 6) refuse("order is " + std::to_string(order) + ": 1 to 6 is possible");
  if (!(frame_tolerance >= 0))
    refuse("frame_tolerance is " + text(frame_tolerance) + ": it must not be negative");
  if (!(most_defect >= 0))
    refuse("most_defect is " + text(most_defect) + ": it must not be negative");
  if (max_degree < 0 || max_degree > max_spline_degree)
    refuse("max_degree is " + std::to_string(max_degree) + ": 0 to " +
           std::to_string(max_spline_degree) + " is possible");
  if (!(least_tangent > 0 && least_tangent < 1))
    refuse("least_tangent is " + text(least_tangent) + ": it must be within (0, 1)");
  if (!(most_departure > 0))
    refuse("most_departure is " + text(most_departure) + ": it must be positive");
  guards.validate();
}

JointBlend::JointBlend(const JointFrame& first, const JointFrame& second,
                       const JointBlendOptions& options)
    : first_(first), second_(second) {
  options.validate();
  blending::requireMeeting(first, "the first frame");
  blending::requireMeeting(second, "the second frame");
  int degree_a = std::max({first.a.degree(), second.a.degree(), options.order}),
      degree_b = std::max({first.b.degree(), second.b.degree(), options.order});
  first_ = blending::raised(first, degree_a, degree_b);
  second_ = blending::raised(second, degree_a, degree_b);
  // Betas do not depend on the degree.
  const BetaFit fit = checkedFit(first_, "the first frame", options),
                second_fit = checkedFit(second_, "the second frame", options);
  auto path = pathOf(first_, fit, second_, second_fit, options);
  JointFrame raised = first_, second_raised = second_;
  JointBlendOptions strict = options;
  strict.frame_tolerance = options.most_defect;
  while (!path.isBalanced() && std::max(degree_a, degree_b) < options.max_degree) {
    raised = blending::raised(raised, ++degree_a, ++degree_b);
    second_raised = blending::raised(second_raised, degree_a, degree_b);
    auto next = pathOf(raised, fit, second_raised, second_fit, strict, BlendRemedy::Balanced);
    if (!next.isBalanced()) continue;
    path = std::move(next);
    first_ = std::move(raised);
    second_ = std::move(second_raised);
    break;
  }
  path_ = std::make_shared<const blending::JointPath>(std::move(path));
}

BlendRemedy JointBlend::remedy() const {
  return path_->remedy();
}

int JointBlend::degreeA() const {
  return first_.a.degree();
}

int JointBlend::degreeB() const {
  return first_.b.degree();
}

BlendedJoint JointBlend::at(double omega) const {
  if (!(omega >= 0 && omega <= 1)) refuse("omega is " + text(omega) + ": it must be within 0 to 1");
  blending::JointState state = path_->at(omega);
  const Eigen::Index n = (state.poles.rows() - 1) / 2;
  const JointFrame* key = omega == 0 ? &first_ : omega == 1 ? &second_ : nullptr;
  BlendedJoint result{.a = key ? key->a
                               : withPoles(plainCurve(first_.a, second_.a, omega),
                                           state.poles.topRows(n + 1), true),
                      .b = key ? key->b
                               : withPoles(plainCurve(first_.b, second_.b, omega),
                                           state.poles.bottomRows(n + 1), false),
                      .order = state.order,
                      .beta = std::move(state.beta),
                      .defects = {},
                      .remedy = state.remedy,
                      .moved_mm = state.moved_mm,
                      .faults = std::move(state.faults)};
  result.defects = fitBeta(result.a, result.b, result.order).defects;
  return result;
}

BlendedJoint blendJoint(const JointFrame& first, const JointFrame& second, double omega,
                        const JointBlendOptions& options) {
  return JointBlend(first, second, options).at(omega);
}

}  // namespace seamwright
