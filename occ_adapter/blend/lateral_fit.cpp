// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <seamwright/core/bspline/surface_jets.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <seamwright/occ_adapter/blend/lateral_fit.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

double parameterOf(LateralSide side) {
  return side == LateralSide::First ? 0 : 1;
}

/// Where the boundary shall run: along the curve, and at its ends in the corners of the sheet,
/// which may lie beside the curve by no more than the gap tolerance.
class LateralTarget {
 public:
  LateralTarget(const BlendLateral& lateral, const SurfaceJets& sheet) : lateral_(&lateral) {
    for (const int end : {0, 1})
      beside_[end] = sheet.at(parameterOf(lateral.side), end, 0).p - lateral.curve->at(end);
  }
  const BlendLateral& lateral() const { return *lateral_; }
  Vector3d at(double v) const {
    const double closing = lateral_->pace.closing(v);
    return lateral_->curve->at(lateral_->pace.shareAt(v)) + (1 - closing) * beside_[0] +
           closing * beside_[1];
  }

 private:
  const BlendLateral* lateral_;
  std::array<Vector3d, 2> beside_;
};

using Values = std::function<Vector3d(double v)>;

/// The poles across of the spline with these values that vanishes at both ends as often as the
/// orders ask for.
Eigen::MatrixXd interpolated(const BlendTask& task, const BSplineSurface& sheet,
                             const Values& values) {
  const ZeroEndInterpolation interpolation(sheet.degree_v, sheet.knots_v, task.ends[0].order + 1,
                                           task.ends[1].order + 1);
  Eigen::MatrixXd at(interpolation.parameters().size(), 3);
  for (Eigen::Index i = 0; i < at.rows(); ++i)
    at.row(i) = values(interpolation.parameters()[i]).transpose();
  return interpolation.poles(at);
}

/// The part of the partial by u that leaves the tangent plane of the face beside.
Vector3d beyondPlane(const BlendLateral& lateral, const SurfaceJets& sheet, double v) {
  const Vector3d normal = lateral.normal(lateral.pace.shareAt(v));
  return sheet.at(parameterOf(lateral.side), v, 1).u.dot(normal) * normal;
}

/// What the second partial by u lacks for the curvature of the face beside. The first one lies in
/// the tangent plane.
Vector3d lackOfBend(const BlendLateral& lateral, const SurfaceJets& sheet, double v) {
  const double share = lateral.pace.shareAt(v);
  const Vector3d normal = lateral.normal(share);
  const SurfaceJet there = sheet.at(parameterOf(lateral.side), v, 2);
  return (there.u.dot(lateral.curvature(share) * there.u) - there.uu.dot(normal)) * normal;
}

BSplineSurface movedToLaterals(const BlendTask& task, const BSplineSurface& sheet) {
  BSplineSurface moved = sheet;
  for (const BlendLateral& lateral : task.laterals) {
    const LateralTarget target(lateral, SurfaceJets(sheet));
    const SurfaceJets before(moved);
    const double u = parameterOf(lateral.side);
    moved = displacedBoundary(moved, lateral.side, interpolated(task, moved, [&](double v) {
                                return Vector3d(target.at(v) - before.at(u, v, 0).p);
                              }));
  }
  for (const BlendLateral& lateral : task.laterals)
    if (lateral.normal) {
      const SurfaceJets before(moved);
      moved = turnedBoundary(moved, lateral.side, interpolated(task, moved, [&](double v) {
                               return Vector3d(-beyondPlane(lateral, before, v));
                             }));
    }
  for (const BlendLateral& lateral : task.laterals)
    if (lateral.curvature) {
      const SurfaceJets before(moved);
      moved = bentBoundary(moved, lateral.side, interpolated(task, moved, [&](double v) {
                             return lackOfBend(lateral, before, v);
                           }));
    }
  return moved;
}

/// The relative difference of the curvature from that of the face beside.
double bendBeside(const BlendTask& task, const BlendLateral& lateral, const SurfaceJet& there,
                  double v) {
  const double share = lateral.pace.shareAt(v);
  Vector3d normal = there.u.cross(there.v).normalized();
  if (normal.dot(lateral.normal(share)) < 0) normal = -normal;
  const Eigen::Matrix3d own = curvatureTensor(there, normal), wanted = lateral.curvature(share);
  const CurvatureDifference difference{.difference_per_mm = (own - wanted).norm(),
                                       .norm_a_per_mm = own.norm(),
                                       .norm_b_per_mm = wanted.norm()};
  return relativeDifference(difference, task.tolerance.flat_radius_mm);
}

/// The largest figure at a point of a lateral boundary over its tolerance.
double excessBeside(const BlendTask& task, const SurfaceJets& sheet, const LateralTarget& target,
                    double v) {
  const BlendLateral& lateral = target.lateral();
  const SurfaceJet there = sheet.at(parameterOf(lateral.side), v, 2);
  double excess = (there.p - target.at(v)).norm() / task.tolerance.gap_mm;
  if (!lateral.normal) return excess;
  const Vector3d normal = there.u.cross(there.v), wanted = lateral.normal(lateral.pace.shareAt(v));
  const double angle_rad = std::atan2(normal.cross(wanted).norm(), std::abs(normal.dot(wanted)));
  excess = std::max(excess, angle_rad / task.tolerance.angle_rad);
  if (!lateral.curvature) return excess;
  return std::max(excess, bendBeside(task, lateral, there, v) / task.tolerance.curvature_rel);
}

/// A span across in which a lateral boundary is beyond its share of the tolerance.
struct PoorSpanAcross {
  double from = 0, to = 0;
  double excess = 0;
};

/// The spans that can be halved and are beyond that share, the worst first.
std::vector<PoorSpanAcross> poorSpansAcross(const BlendTask& task, const BSplineSurface& sheet,
                                            const SheetKnots& knots, double share_of_tolerance) {
  constexpr std::array<double, 8> samples = {0.01, 0.1, 0.25, 0.4, 0.6, 0.75, 0.9, 0.99};
  constexpr double shortest = 1.0 / 4096;  // a choice: beyond it only kinks are left
  std::vector<PoorSpanAcross> result;
  std::vector<LateralTarget> targets;
  const SurfaceJets jets(sheet);
  for (const BlendLateral& lateral : task.laterals) targets.emplace_back(lateral, jets);
  const std::map<double, int>& at = knots.multiplicities();
  for (auto from = at.begin(), to = std::next(from); to != at.end(); from = to++) {
    PoorSpanAcross span{from->first, to->first};
    if (span.to - span.from < shortest) continue;
    for (const double sample : samples)
      for (const LateralTarget& target : targets) {
        const double v = span.from + sample * (span.to - span.from);
        span.excess = std::max(span.excess, excessBeside(task, jets, target, v));
      }
    if (span.excess > share_of_tolerance) result.push_back(span);
  }
  std::ranges::sort(result, std::greater(), &PoorSpanAcross::excess);
  return result;
}

/// Knots where derivatives of the curves jump, by multiplicity.
std::map<double, int> knotsOfCurves(const BlendTask& task, int degree) {
  std::map<double, int> knots;
  for (const BlendLateral& lateral : task.laterals)
    for (const CurveBreak& there : lateral.curve->breaks()) {
      int& multiplicity = knots[lateral.pace.parameterOf(there.share)];
      multiplicity = std::max(multiplicity, degree - there.smoothness);
    }
  return knots;
}

}  // namespace

BSplineSurface fittedToLaterals(const BlendTask& task, const BSplineSurface& sheet,
                                double share_of_tolerance, int max_spans,
                                const Progress& progress) {
  if (task.laterals.empty()) return sheet;
  // A choice: splines of degree 5 get that digit for few spans more.
  const double share = 0.2 * share_of_tolerance;
  // Quintics, or enough poles for the derivatives of both ends.
  constexpr int least_degree = 5;
  const int degree = std::max(sheet.degree_v, least_degree);
  SheetKnots knots(degree, knotsOfCurves(task, degree));
  if (poorSpansAcross(task, sheet, knots, share).empty()) return sheet;
  for (int round = 0;; ++round) {
    checkProgress(progress, shareAfter(round));
    BSplineSurface moved = movedToLaterals(task, withKnotsAcross(sheet, degree, knots.flat()));
    const std::vector<PoorSpanAcross> poor = poorSpansAcross(task, moved, knots, share);
    const int more = std::min(static_cast<int>(poor.size()), max_spans - knots.spans());
    if (more <= 0) return moved;
    for (int i = 0; i < more; ++i) knots.halve(poor[i].from, poor[i].to);
    knots.grade();
  }
}

double farthestFromCurve_mm(const BlendLateral& lateral, const BSplineSurface& sheet) {
  constexpr int samples = 512;
  const SurfaceJets jets(sheet);
  double largest = 0;
  for (int i = 0; i <= samples; ++i) {
    const double v = static_cast<double>(i) / samples;
    const Vector3d made = jets.at(parameterOf(lateral.side), v, 0).p;
    largest = std::max(largest, (made - lateral.curve->at(lateral.pace.shareAt(v))).norm());
  }
  return largest;
}

}  // namespace seamwright::occ
