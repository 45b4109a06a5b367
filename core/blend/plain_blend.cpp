// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/blend/joint_frame.hpp>
#include <seamwright/core/blend/joint_jet.hpp>
#include <seamwright/core/blend/plain_blend.hpp>
#include <seamwright/core/join/curve/joint_length.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using bernstein::text;
using blending::JointJet;
using Eigen::Vector3d;

void requirePlain(const JointFrame& frame, const std::string& name) {
  blending::requireMeeting(frame, name);
  for (const BezierCurve* curve : {&frame.a, &frame.b})
    if (curve->isRational())
      refuse(name + " has a rational curve, weights " + text(curve->weights().minCoeff()) + " to " +
             text(curve->weights().maxCoeff()) + ": the conditions are those of polynomial curves");
}

void requireSpeed(const JointJet& jet, const std::string& name) {
  for (const auto& [x, noise] : {std::pair(&jet.a, jet.noise_a), std::pair(&jet.b, jet.noise_b)})
    if (!(x->row(1).stableNorm() > noise))
      refuse(name + " has no tangent at the joint: speed " + text(x->row(1).stableNorm()) +
             ", rounding " + text(noise));
}

/// |curvature| times a length.
double bendOf(const CurveDerivatives& x, double length) {
  const Vector3d first = x.row(1), second = x.row(2);
  const double speed = first.stableNorm();
  return length * (first / speed).cross(second / speed).stableNorm() / speed;
}

CurveDerivatives blended(const CurveDerivatives& x, const CurveDerivatives& y, double omega) {
  return (1 - omega) * x + omega * y;
}

PlainBlendCase caseOf(const PlainBlend& blend, int order, double tolerance) {
  if (blend.tangent_a.vanishes() || blend.tangent_b.vanishes()) return PlainBlendCase::None;
  if (blend.betas_defect <= tolerance) return PlainBlendCase::EqualBetas;
  if (blend.angle_rad > tolerance) return PlainBlendCase::None;
  if (order == 1) return PlainBlendCase::ParallelTangents;
  if (blend.beta1_defect <= tolerance) return PlainBlendCase::EqualBeta1;
  return blend.bend <= tolerance ? PlainBlendCase::Straight : PlainBlendCase::None;
}

}  // namespace

ShortestBlend shortestBlend(const Vector3d& u, const Vector3d& v, double rounding_mm) {
  for (const Vector3d* vector : {&u, &v})
    for (const double x : *vector)
      if (!std::isfinite(x)) refuse("a coordinate is " + text(x) + ": it must be finite");
  if (!(rounding_mm >= 0))
    refuse("rounding_mm is " + text(rounding_mm) + ": it must not be negative");
  const double size_u = u.stableNorm(), size_v = v.stableNorm();
  ShortestBlend result{.rounding_mm = rounding_mm + 4 * machine_epsilon * std::max(size_u, size_v)};
  const Vector3d between = v - u;
  const double length = between.stableNorm();
  const double along = length > 0 ? -u.dot(between / length) : 0;
  result.omega = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
  if (result.omega <= 0)
    result.length_mm = size_u;
  else if (result.omega >= 1)
    result.length_mm = size_v;
  else
    result.length_mm = u.cross(between / length).stableNorm();
  return result;
}

Eigen::VectorXd PlainBlend::beta(double omega) const {
  return blending::projectedBetas(
      {.a = blended(first_a, second_a, omega), .b = blended(first_b, second_b, omega)});
}

PlainBlend plainBlend(const JointFrame& first, const JointFrame& second, int order,
                      double tolerance) {
  if (order != 1 && order != 2)
    refuse("order is " + std::to_string(order) + ": the conditions are known for 1 and 2");
  if (!(tolerance >= 0)) refuse("tolerance is " + text(tolerance) + ": it must not be negative");
  requirePlain(first, "the first frame");
  requirePlain(second, "the second frame");
  const int degree_a = std::max({first.a.degree(), second.a.degree(), order}),
            degree_b = std::max({first.b.degree(), second.b.degree(), order});
  const JointFrame from = blending::raised(first, degree_a, degree_b),
                   to = blending::raised(second, degree_a, degree_b);
  const JointJet one = blending::jointJet(blending::polesBeside(from, order), degree_a, degree_b);
  const JointJet two = blending::jointJet(blending::polesBeside(to, order), degree_a, degree_b);
  requireSpeed(one, "the first frame");
  requireSpeed(two, "the second frame");

  PlainBlend result{.first_a = one.a, .first_b = one.b, .second_a = two.a, .second_b = two.b};
  const Vector3d u = one.a.row(1), v = two.a.row(1);
  result.angle_rad =
      std::atan2(u.normalized().cross(v.normalized()).norm(), u.normalized().dot(v.normalized()));
  result.ratio = v.stableNorm() / u.stableNorm();
  result.tangent_a = shortestBlend(u, v, one.noise_a + two.noise_a);
  result.tangent_b = shortestBlend(one.b.row(1), two.b.row(1), one.noise_b + two.noise_b);
  const Eigen::VectorXd beta = blending::projectedBetas(one);
  result.betas_defect = result.beta1_defect = infinite;
  if (beta.size() == order) {
    const double length_one = jointLength(extentOf(from.a.poles()), extentOf(from.b.poles())),
                 length_two = jointLength(extentOf(to.a.poles()), extentOf(to.b.poles()));
    const auto own = blending::rowDefects(one, beta, length_one),
               other = blending::rowDefects(two, beta, length_two);
    result.beta1_defect = std::max(own[0], other[0]);
    result.betas_defect = std::max(*std::max_element(own.begin(), own.end()),
                                   *std::max_element(other.begin(), other.end()));
    if (order == 2)
      for (const auto& [jet, length] : {std::pair(&one, length_one), std::pair(&two, length_two)})
        result.bend = std::max({result.bend, bendOf(jet->a, length), bendOf(jet->b, length)});
  }
  result.kind = caseOf(result, order, tolerance);
  return result;
}

}  // namespace seamwright
