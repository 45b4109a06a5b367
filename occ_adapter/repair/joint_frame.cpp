// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/repair/joint_frame.hpp>

namespace seamwright::occ {

SurfaceJet jetOf(const JointSide& side) {
  return side.mover == nullptr ? side.shown.jet
                               : side.mover->displacement.moved(side.shown.jet, side.shares);
}

std::optional<Eigen::Vector3d> normalOf(const JointSide& side, const SurfaceJet& jet) {
  return unitNormal(jet,
                    side.mover == nullptr ? side.shown.noise : side.mover->displacement.noise(jet));
}

std::optional<Eigen::Vector3d> slideNormal(const JointSample& sample) {
  for (const JointSide& side : sample.sides)
    if (side.slides_on) return normalOf(side, side.shown.jet);
  return {};
}

JointFrame frameOf(const JointSample& sample, const Eigen::Vector3d& normal) {
  Eigen::Vector3d tangent = sample.sides[0].shown.tangent;
  tangent -= normal.dot(tangent) * normal;
  if (!(tangent.norm() > 0)) tangent = normal.unitOrthogonal();
  tangent.normalize();
  return {normal, tangent, normal.cross(tangent)};
}

Differences differencesOf(const Joint& joint, const JointSample& sample, const SurfaceJet& a,
                          const SurfaceJet& b) {
  Differences found;
  found.gap = a.p - b.p;
  if (const auto normal = slideNormal(sample)) found.gap = normal->dot(found.gap) * *normal;
  if (joint.order < 1 || sample.sides.size() < 2) return found;
  const auto na = normalOf(sample.sides[0], a);
  auto nb = normalOf(sample.sides[1], b);
  if (!na || !nb) return found;
  if (na->dot(*nb) < 0) *nb = -*nb;
  found.normal = *na - *nb;
  if (joint.order < 2) return found;
  const JointFrame frame = frameOf(sample, (*na + *nb).normalized());
  const Eigen::Matrix3d difference = curvatureTensor(a, *na) - curvatureTensor(b, *nb);
  found.bend = {frame.tangent.dot(difference * frame.tangent),
                frame.tangent.dot(difference * frame.cross),
                frame.cross.dot(difference * frame.cross)};
  return found;
}

bool isEnd(const JointSample& sample) {
  return sample.s <= 0 || sample.s >= 1;
}

}  // namespace seamwright::occ
