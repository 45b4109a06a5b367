// SPDX-License-Identifier: LGPL-2.1-or-later
// Round holes, lenses and others with smooth corners, in surfaces that are known.
#include <gmock/gmock.h>

#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/umbrella/ring_fill.hpp>

#include "fills.hpp"

namespace seamwright {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using test::Graph;

/// A quarter of an ellipse as a cubic, run counter-clockwise from quadrant k.
Poles quarter(int k, double a, double b) {
  constexpr double h = 0.5522847498307936;
  Eigen::Matrix<double, 4, 2> unit;
  unit << 1, 0, 1, h, h, 1, 0, 1;
  Poles poles = Poles::Zero(4, 3);
  for (int i = 0; i < 4; ++i) {
    Vector2d p = unit.row(i);
    for (int turn = 0; turn < k; ++turn) p = Vector2d(-p.y(), p.x());
    poles.row(i) << a * p.x(), b * p.y(), 0;
  }
  return poles;
}

/// A plane curve lifted to z = k1 x^2 / 2 + k2 y^2 / 2, exactly, with the conormal's lift as cross field.
FillSide lifted(const Poles& plan, double k1, double k2) {
  const auto square = [](const Eigen::VectorXd& f) { return rows::times(f, f); };
  const Eigen::VectorXd x = plan.col(0), y = plan.col(1);
  Poles edge = rows::elevated<3>(rows::Field<3>(plan), 6);
  edge.col(2) = k1 / 2 * square(x) + k2 / 2 * square(y);
  const Poles along = rows::derivative<3>(rows::Field<3>(plan));
  const Eigen::VectorXd out_x = along.col(1), out_y = -along.col(0);
  Poles cross(6, 3);
  cross.col(0) = rows::elevated<1>(out_x, 5);
  cross.col(1) = rows::elevated<1>(out_y, 5);
  cross.col(2) = k1 * rows::times(x, out_x) + k2 * rows::times(y, out_y);
  return {BezierCurve(edge), cross};
}

std::vector<FillSide> roundHole(double a, double b, double k1, double k2) {
  std::vector<FillSide> sides;
  for (int k = 0; k < 4; ++k) sides.push_back(lifted(quarter(k, a, b), k1, k2));
  return sides;
}

double worstSpoke(const RingFill& fill) {
  double worst = 0;
  const auto add = [&](const SeamFigures& figures) { worst = std::max(worst, *figures.angle_rad->upper); };
  constexpr std::array<PatchEdge, 4> inner = {PatchEdge::V0, PatchEdge::U1, PatchEdge::V1, PatchEdge::U0};
  for (int k = 0; k < 4; ++k) {
    add(encloseSeam(seamSide(fill.patches[(k + 3) % 4], PatchEdge::V1),
                    seamSide(fill.patches[k], PatchEdge::V0), test::fine()));
    add(encloseSeam(seamSide(fill.patches[4], inner[k], k >= 2), seamSide(fill.patches[k], PatchEdge::U0),
                    test::fine()));
  }
  return worst;
}

double worstSide(const RingFill& fill, const std::vector<FillSide>& sides) {
  double worst = 0;
  for (int k = 0; k < 4; ++k)
    worst = std::max(worst, *encloseSeam(seamSide(fill.patches[k], PatchEdge::U1),
                                         seamSide(test::neighbour(sides[k]), PatchEdge::U0), test::fine())
                                 .angle_rad->upper);
  return worst;
}

TEST(RingFill, ARoundHoleInAParaboloid) {
  const std::vector<FillSide> sides = roundHole(10, 10, -0.05, -0.05);
  const RingFill fill = ringFill(sides);
  EXPECT_TRUE(fill.regular);
  EXPECT_LT(worstSpoke(fill), 1e-10);
  EXPECT_LT(worstSide(fill, sides), 1e-10);
  double error = 0;
  for (const BezierPatch& patch : fill.patches)
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const Vector3d p = patch.point(i / 8.0, j / 8.0);
        error = std::max(error, std::abs(p.z() + 0.025 * p.head<2>().squaredNorm()));
      }
  std::printf("degree %d error %g fairness %g\n", fill.patches[0].degreeU(), error, fill.fairness_mm2);
  EXPECT_LT(error, 0.05);
}

}  // namespace
}  // namespace seamwright
