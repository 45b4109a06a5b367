// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/blend/joint_frame.hpp>
#include <seamwright/core/blend/joint_jet.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::blending {

JointFrame raised(const JointFrame& frame, int degree_a, int degree_b) {
  JointFrame result = frame;
  while (result.a.degree() < degree_a) result.a = result.a.elevated();
  while (result.b.degree() < degree_b) result.b = result.b.elevated();
  return result;
}

void requireMeeting(const JointFrame& frame, const std::string& name) {
  using bernstein::text;
  const HomogeneousPoles &a = frame.a.homogeneousPoles(), &b = frame.b.homogeneousPoles();
  const Eigen::RowVector4d end = a.row(a.rows() - 1), start = b.row(0);
  if (end(3) != start(3))
    refuse(name + ": the weights at the joint are " + text(end(3)) + " and " + text(start(3)) +
           ": they must be equal");
  const double gap = (end.head<3>() / end(3) - start.head<3>() / start(3)).stableNorm();
  const double size =
      std::max(pointsOf(a).cwiseAbs().maxCoeff(), pointsOf(b).cwiseAbs().maxCoeff());
  // Both ends may be results of a few roundings each.
  const double rounding = 16 * machine_epsilon * size;
  if (!(gap <= rounding))
    refuse(name + ": the curves are " + text(gap) + " mm apart, rounding is " + text(rounding));
}

HomogeneousPoles polesBeside(const JointFrame& frame, int order) {
  HomogeneousPoles result(2 * order + 1, 4);
  result << frame.a.homogeneousPoles().bottomRows(order + 1),
      frame.b.homogeneousPoles().middleRows(1, order);
  return result;
}

JointKey keyOf(const JointFrame& frame, const BetaFit& fit) {
  JointKey key{.poles = polesBeside(frame, static_cast<int>(fit.beta.size())),
               .beta = fit.beta,
               .length_mm = fit.length_mm};
  key.far.resize(2, 3);
  key.far << frame.a.point(0).transpose(), frame.b.point(1).transpose();
  key.speed_mm = jointJet(key.poles, frame.a.degree(), frame.b.degree()).a.row(1).norm();
  return key;
}

}  // namespace seamwright::blending
