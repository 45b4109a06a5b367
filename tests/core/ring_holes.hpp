// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fill/ring_fill.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>

#include "fills.hpp"

/// Holes with smooth and reflex corners in z = k1 x^2 / 2 + k2 y^2 / 2, exactly.
namespace seamwright::test {

struct Bowl {
  double k1 = 0, k2 = 0;
  double heightAt(double x, double y) const { return k1 / 2 * x * x + k2 / 2 * y * y; }
};

/// A plane cubic lifted to the surface, with the lift of the direction across it as cross-boundary
/// derivative, and its second derivative.
inline FillSide lifted(const Poles& plan, const Bowl& bowl) {
  const auto square = [](const Eigen::VectorXd& f) { return rows::times(f, f); };
  const Eigen::VectorXd x = plan.col(0), y = plan.col(1);
  Poles edge = rows::elevated<3>(rows::Field<3>(plan), 6);
  edge.col(2) = bowl.k1 / 2 * square(x) + bowl.k2 / 2 * square(y);
  const Poles along = rows::derivative<3>(rows::Field<3>(plan));
  const Eigen::VectorXd out_x = along.col(1), out_y = -along.col(0);
  Poles cross(6, 3), bend = Poles::Zero(5, 3);
  cross.col(0) = rows::elevated<1>(out_x, 5);
  cross.col(1) = rows::elevated<1>(out_y, 5);
  cross.col(2) = bowl.k1 * rows::times(x, out_x) + bowl.k2 * rows::times(y, out_y);
  bend.col(2) = bowl.k1 * square(out_x) + bowl.k2 * square(out_y);
  return {BezierCurve(edge), cross, bend};
}

inline std::vector<FillSide> lifted(const std::vector<Poles>& plans, const Bowl& bowl) {
  std::vector<FillSide> sides;
  for (const Poles& plan : plans) sides.push_back(lifted(plan, bowl));
  return sides;
}

inline Poles planLine(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  Poles poles = Poles::Zero(4, 3);
  for (int i = 0; i < 4; ++i) poles.row(i).head<2>() = a + (b - a) * i / 3.0;
  return poles;
}

/// Both parts of a plane cubic.
inline std::vector<Poles> planParts(const Poles& plan, double at) {
  const auto [first, second] = BezierCurve(plan).split(at);
  return {first.poles(), second.poles()};
}

/// Four cubics close to an ellipse.
inline std::vector<Poles> ovalPlan(double a, double b) {
  constexpr double h = 0.5522847498307936;
  std::vector<Poles> plans;
  for (const auto& [c, s] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    Poles poles = Poles::Zero(4, 3);
    const std::array<Eigen::Vector2d, 4> quarter = {{{1, 0}, {1, h}, {h, 1}, {0, 1}}};
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector2d& p = quarter.at(i);
      poles.row(i) << a * (c * p.x() - s * p.y()), b * (s * p.x() + c * p.y()), 0;
    }
    plans.push_back(poles);
  }
  return plans;
}

/// Two corners; both sides are cut into two, at that parameter.
inline std::vector<Poles> lensPlan(double depth, double at) {
  Poles below = Poles::Zero(4, 3), above = Poles::Zero(4, 3);
  below << -10, 0, 0, -4, -depth, 0, 4, -depth, 0, 10, 0, 0;
  above << 10, 0, 0, 4, depth, 0, -4, depth, 0, -10, 0, 0;
  std::vector<Poles> plans = planParts(below, at);
  for (const Poles& part : planParts(above, at)) plans.push_back(part);
  return plans;
}

/// One corner: a drop.
inline std::vector<Poles> dropPlan() {
  Poles right = Poles::Zero(4, 3), left = Poles::Zero(4, 3);
  right << 0, -10, 0, 5, -6, 0, 9, 8, 0, 0, 8, 0;
  left << 0, 8, 0, -9, 8, 0, -5, -6, 0, 0, -10, 0;
  std::vector<Poles> plans = planParts(right, 0.5);
  for (const Poles& part : planParts(left, 0.5)) plans.push_back(part);
  return plans;
}

/// A corner of more than 180 degrees between three others.
inline std::vector<Poles> arrowPlan() {
  const std::array<Eigen::Vector2d, 4> corners = {{{-10, -8}, {0, -2}, {10, -8}, {0, 10}}};
  std::vector<Poles> plans;
  for (int k = 0; k < 4; ++k) plans.push_back(planLine(corners.at(k), corners.at((k + 1) % 4)));
  return plans;
}

/// The seams between the patches of a ring.
inline std::vector<SeamFigures> ringSeams(const RingFill& fill,
                                          const ContinuityTolerance& tolerance) {
  constexpr std::array<PatchEdge, 4> middle = {PatchEdge::V0, PatchEdge::U1, PatchEdge::V1,
                                               PatchEdge::U0};
  std::vector<SeamFigures> seams;
  for (int k = 0; k < 4; ++k) {
    seams.push_back(encloseSeam(seamSide(fill.patches[(k + 3) % 4], PatchEdge::V1),
                                seamSide(fill.patches[k], PatchEdge::V0), tolerance));
    seams.push_back(encloseSeam(seamSide(fill.patches[4], middle.at(k), k >= 2),
                                seamSide(fill.patches[k], PatchEdge::U0), tolerance));
  }
  return seams;
}

/// The patch E + s T + s^2 W / 2 beyond a side; edge U0 is the side.
inline BezierPatch curvedNeighbour(const FillSide& side) {
  const int degree = static_cast<int>(std::max(
                         {side.edge.poles().rows(), side.cross->rows(), side.bend->rows()})) -
                     1;
  const auto raised = [degree](const Poles& poles) {
    return rows::elevated<3>(rows::Field<3>(poles), degree);
  };
  const Poles edge = raised(side.edge.poles()), first = raised(*side.cross),
              second = raised(*side.bend);
  Poles net(3 * (degree + 1), 3);
  net << edge, edge + first / 2, edge + first + second / 2;
  return {2, degree, net};
}

/// The seams between a ring and what is beyond its sides.
inline std::vector<SeamFigures> ringSideSeams(const RingFill& fill,
                                              const std::vector<FillSide>& sides,
                                              const ContinuityTolerance& tolerance) {
  std::vector<SeamFigures> seams;
  for (int k = 0; k < 4; ++k)
    seams.push_back(encloseSeam(seamSide(fill.patches[k], PatchEdge::U1),
                                seamSide(curvedNeighbour(sides[k]), PatchEdge::U0), tolerance));
  return seams;
}

inline double largestAngle_rad(const std::vector<SeamFigures>& seams) {
  double largest = 0;
  for (const SeamFigures& seam : seams) largest = std::max(largest, *seam.angle_rad->upper);
  return largest;
}

inline double largestCurvature_per_mm(const std::vector<SeamFigures>& seams) {
  double largest = 0;
  for (const SeamFigures& seam : seams)
    largest = std::max(largest, seam.curvature_per_mm->upper.value_or(HUGE_VAL));
  return largest;
}

}  // namespace seamwright::test
