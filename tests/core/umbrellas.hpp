// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <numbers>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/seam/patch_side.hpp>
#include <seamwright/core/seam/triangle_side.hpp>
#include <seamwright/core/umbrella/umbrella.hpp>

#include "joins.hpp"

/// Random spokes and members, and what an umbrella must satisfy, from its poles alone.
namespace seamwright::test {

inline Poles polesOf(const UmbrellaMember& member) {
  return std::visit([](const auto& surface) { return surface.poles(); }, member);
}

/// Spokes of a random fan in a random place: angles from 0.3 to 2.8 rad, lengths of 6 to 14 mm,
/// poles off the line by up to 1 mm.
inline std::vector<BezierCurve> randomSpokes(int count, bool closed, int degree,
                                             std::mt19937_64& random) {
  using std::numbers::pi;
  const int members = closed ? count : count - 1;
  for (;;) {
    Eigen::VectorXd angles(members);
    for (double& angle : angles) angle = uniform(0.5, 1.5, random);
    angles *=
        (closed ? 2 * pi : uniform(0.5, 1, random) * std::min(5.0, 2.5 * members)) / angles.sum();
    if (angles.minCoeff() < 0.3 || angles.maxCoeff() > 2.8) continue;
    const Eigen::Matrix3d turn = randomRotation(random);
    const Eigen::RowVector3d origin(uniform(-5, 5, random), uniform(-5, 5, random),
                                    uniform(-5, 5, random));
    std::vector<BezierCurve> spokes;
    double angle = uniform(0, 6, random);
    for (int i = 0; i < count; ++i) {
      const double length = uniform(6, 14, random);
      Poles poles(degree + 1, 3);
      for (int k = 0; k <= degree; ++k) {
        const double along = length * k / degree, off = k < 2 ? 0 : 1;
        poles.row(k) << along * std::cos(angle) + off * uniform(-1, 1, random),
            along * std::sin(angle) + off * uniform(-1, 1, random), off * uniform(-1, 1, random);
      }
      spokes.emplace_back(Poles((poles * turn.transpose()).rowwise() + origin));
      if (i < members) angle += angles(i);
    }
    return spokes;
  }
}

inline std::vector<MemberKind> randomKinds(int members, std::mt19937_64& random) {
  std::vector<MemberKind> kinds;
  const int sort = whole(0, 3, random);  // all patches, all triangles, mixed twice as often
  for (int i = 0; i < members; ++i)
    kinds.push_back(sort == 0 || (sort > 1 && whole(0, 1, random) == 0) ? MemberKind::Tensor
                                                                        : MemberKind::Triangle);
  return kinds;
}

/// The member before a spoke runs up to it, the one behind sets out from it.
inline Ribbon ribbonBefore(const UmbrellaMember& member) {
  if (const auto* patch = std::get_if<BezierPatch>(&member))
    return ribbon(*patch, PatchEdge::U0, false, Across::OutOf);
  return ribbon(std::get<BezierTriangle>(member), TriangleEdge::L0, true, Across::OutOf);
}
inline Ribbon ribbonAfter(const UmbrellaMember& member) {
  if (const auto* patch = std::get_if<BezierPatch>(&member))
    return ribbon(*patch, PatchEdge::V0, false, Across::Into);
  return ribbon(std::get<BezierTriangle>(member), TriangleEdge::L1, false, Across::Into);
}
inline SeamSide sideBefore(const UmbrellaMember& member) {
  if (const auto* patch = std::get_if<BezierPatch>(&member))
    return seamSide(*patch, PatchEdge::U0, false);
  return seamSide(std::get<BezierTriangle>(member), TriangleEdge::L0, true);
}
inline SeamSide sideAfter(const UmbrellaMember& member) {
  if (const auto* patch = std::get_if<BezierPatch>(&member))
    return seamSide(*patch, PatchEdge::V0, false);
  return seamSide(std::get<BezierTriangle>(member), TriangleEdge::L1, false);
}

/// Largest of |V - a C' - b U| over 33 points of all inner spokes, relative to the largest term;
/// infinite where members do not meet.
inline double worstLaw(const Umbrella& umbrella) {
  double worst = 0;
  for (int i = 0; i < umbrella.vertex.spokes(); ++i) {
    if (!umbrella.vertex.isInner(i)) continue;
    const Ribbon u = ribbonBefore(umbrella.members[umbrella.vertex.memberBefore(i)]),
                 v = ribbonAfter(umbrella.members[i]);
    const double size = u.position.leftCols<3>().cwiseAbs().maxCoeff();
    double defect = 0, scale = 0;
    for (int k = 0; k <= 32; ++k) {
      const double t = k / 32.0, a = value(umbrella.functions[i].a, t),
                   b = value(umbrella.functions[i].b, t);
      const Eigen::Vector3d U = -value(u.first, t).head<3>(), V = value(v.first, t).head<3>();
      const Eigen::Vector3d tangent = umbrella.spokes[i].derivatives(t, 1).row(1);
      const Eigen::Vector3d gap = (value(u.position, t) - value(v.position, t)).head<3>();
      if (gap.norm() > 1e-12 * (1 + size)) return std::numeric_limits<double>::infinity();
      defect = std::max(defect, (V - a * tangent - b * U).norm());
      scale = std::max({scale, V.norm(), std::abs(a) * tangent.norm(), std::abs(b) * U.norm()});
    }
    worst = std::max(worst, defect / scale);
  }
  return worst;
}

/// Largest upper bound of the angle of tangent planes along the inner spokes, certified.
inline double certifiedAngle(const Umbrella& umbrella) {
  ContinuityTolerance tolerance;
  tolerance.angle_rad = 1e-10;
  double worst = 0;
  for (int i = 0; i < umbrella.vertex.spokes(); ++i) {
    if (!umbrella.vertex.isInner(i)) continue;
    const SeamFigures figures =
        encloseSeam(sideBefore(umbrella.members[umbrella.vertex.memberBefore(i)]),
                    sideAfter(umbrella.members[i]), tolerance);
    worst = std::max(worst, figures.certified && figures.angle_rad
                                ? figures.angle_rad->upper.value_or(std::numbers::pi)
                                : std::numbers::pi);
  }
  return worst;
}

inline double largestDifference(const Umbrella& a, const Umbrella& b, int shift = 0) {
  double largest = 0;
  const int m = static_cast<int>(a.members.size());
  for (int i = 0; i < m; ++i) {
    const Poles p = polesOf(a.members[i]), q = polesOf(b.members[(i + shift + m) % m]);
    if (p.rows() != q.rows()) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, (p - q).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// The same member with u and v exchanged.
inline UmbrellaMember exchanged(const UmbrellaMember& member) {
  if (const auto* patch = std::get_if<BezierPatch>(&member)) return patch->transposed();
  return std::get<BezierTriangle>(member).permuted({1, 0, 2});
}

inline BezierCurve mapped(const BezierCurve& curve, const Eigen::Matrix3d& linear,
                          const Eigen::RowVector3d& translation) {
  return BezierCurve(Poles((curve.poles() * linear.transpose()).rowwise() + translation));
}
inline UmbrellaMember mapped(const UmbrellaMember& member, const Eigen::Matrix3d& linear,
                             const Eigen::RowVector3d& translation) {
  const Poles poles = (polesOf(member) * linear.transpose()).rowwise() + translation;
  if (const auto* patch = std::get_if<BezierPatch>(&member))
    return BezierPatch(patch->degreeU(), patch->degreeV(), poles);
  return BezierTriangle(poles);
}

}  // namespace seamwright::test
