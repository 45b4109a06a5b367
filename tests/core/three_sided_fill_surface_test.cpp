// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes of three sides in surfaces that are known, what is refused, and provedRegular() of
// triangles.
#include <gmock/gmock.h>

#include <seamwright/core/fill/regular.hpp>

#include "support/random.hpp"
#include "three_sided_fills.hpp"

namespace seamwright {
namespace {

using Eigen::Vector3d;
using testing::AllOf, testing::HasSubstr, testing::ThrowsMessage;

/// Largest distance in height.
double error(const ThreeSidedFill& fill, const test::Graph& graph) {
  double worst = 0;
  for (const BezierTriangle& triangle : fill.triangles)
    for (int i = 0; i <= 16; ++i)
      for (int j = 0; i + j <= 16; ++j) {
        const Vector3d point = triangle.point(i / 16.0, j / 16.0);
        worst = std::max(worst, std::abs(point.z() - test::at(graph, point.head<2>()).value));
      }
  return worst;
}

std::vector<FillSide> hole(const test::Graph& graph) {
  return test::graphHole(graph, test::polygon(3, 10));
}

std::vector<FillSide> skew(const test::Graph& graph) {
  return test::graphHole(graph, {{10, 1}, {-3, 8}, {-9, -7}});
}

Poles raised(const Poles& poles, int degrees) {
  BezierCurve curve(poles);
  for (int i = 0; i < degrees; ++i) curve = curve.elevated();
  return curve.poles();
}

/// The sides of a triangle of degree 2, in degrees higher by that number, with derivatives in
/// constant directions as fields.
std::vector<FillSide> sidesOf(const BezierTriangle& triangle, int degrees,
                              std::mt19937_64& random) {
  std::vector<FillSide> sides;
  for (int k = 0; k < 3; ++k) {
    const int apex = (k + 2) % 3;
    Vector3d direction = Vector3d::Zero();
    direction(apex) = -test::uniform(0.5, 2, random);
    direction(k) = test::uniform(-1, 1, random);
    direction((k + 1) % 3) = -direction(apex) - direction(k);
    Poles cross(2, 3);
    for (int end : {0, 1}) {
      const int corner = (k + end) % 3;
      const SurfaceJet jet = triangle.jet(corner == 0 ? 1 : 0, corner == 1 ? 1 : 0);
      cross.row(end) = (direction(0) * jet.u + direction(1) * jet.v).transpose();
    }
    const TriangleEdge edge = test::triangle_edges[apex];
    sides.push_back(
        {BezierCurve(raised(triangle.edgeCurve(edge).poles(), degrees)), raised(cross, degrees)});
  }
  return sides;
}

TEST(ThreeSidedFillOfSurface, Law6TrianglesOfDegreeTwoComeBack) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 20; ++run)
    for (int degrees : {0, 1, 3}) {
      const BezierTriangle triangle = test::gentleTriangle(2, false, random);
      const ThreeSidedFill fill = threeSidedFill(sidesOf(triangle, degrees, random));
      EXPECT_LT(fill.fairness_mm2, 1e-22);
      EXPECT_TRUE(fill.regular);
      const std::array<BezierTriangle, 3> cut = triangle.splitAt(1.0 / 3, 1.0 / 3);
      for (int k = 0; k < 3; ++k) {
        BezierTriangle wanted = cut[(k + 2) % 3].permuted({k, (k + 1) % 3, (k + 2) % 3});
        while (wanted.degree() < 3 + degrees) wanted = wanted.elevated();
        EXPECT_LT(test::difference(fill.triangles[k], wanted), 1e-11) << degrees;
      }
    }
}

// Fields of degree 2 along cubic sides: triangles of degree 4, of which the row behind the sides is
// that of the surface.
TEST(ThreeSidedFillOfSurface, FillsOfCubicTrianglesReproduceTheirRows) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 10; ++run) {
    const BezierTriangle triangle = test::gentleTriangle(3, false, random);
    std::vector<FillSide> sides;
    for (int k = 0; k < 3; ++k) {
      Poles cross(3, 3);
      for (int s = 0; s < 3; ++s) {
        const auto pole = [&](int begin, int end, int apex) {
          std::array<int, 3> index{};
          index[k] = begin, index[(k + 1) % 3] = end, index[(k + 2) % 3] = apex;
          return triangle.pole(index[0], index[1]);
        };
        cross.row(s) =
            1.5 * (pole(3 - s, s, 0) + pole(2 - s, s + 1, 0) - 2 * pole(2 - s, s, 1)).transpose();
      }
      sides.push_back({triangle.edgeCurve(test::triangle_edges[(k + 2) % 3]), cross});
    }
    const ThreeSidedFill fill = threeSidedFill(sides);
    const std::array<BezierTriangle, 3> cut = triangle.splitAt(1.0 / 3, 1.0 / 3);
    for (int k = 0; k < 3; ++k) {
      const BezierTriangle wanted =
          cut[(k + 2) % 3].permuted({k, (k + 1) % 3, (k + 2) % 3}).elevated();
      ASSERT_EQ(fill.triangles[k].degree(), 4);
      for (int s = 0; s <= 4; ++s) {
        EXPECT_LT((fill.triangles[k].pole(4 - s, s) - wanted.pole(4 - s, s)).norm(), 1e-12);
        if (s < 4) {
          EXPECT_LT((fill.triangles[k].pole(3 - s, s) - wanted.pole(3 - s, s)).norm(), 1e-12);
        }
      }
      EXPECT_LT((fill.triangles[k].pole(0, 0) - wanted.pole(0, 0)).norm(), 0.2);
    }
  }
}

TEST(ThreeSidedFillOfSurface, QuadraticGraphsAreReproduced) {
  for (const test::Graph& graph :
       {test::plane(), test::paraboloid(-0.1, -0.1), test::paraboloid(0.1, -0.1)})
    for (const std::vector<FillSide>& sides : {hole(graph), skew(graph)}) {
      const ThreeSidedFill fill = threeSidedFill(sides);
      EXPECT_LT(error(fill, graph), 1e-12);
      EXPECT_TRUE(fill.regular);
    }
}

TEST(ThreeSidedFillOfSurface, Law4PlanarSidesHaveAPlanarFill) {
  for (int order : {2, 3})
    for (bool position_alone : {false, true}) {
      std::vector<FillSide> sides = skew(test::plane());
      for (FillSide& side : sides) {
        Poles poles = side.edge.poles();
        poles.row(2) += Eigen::RowVector3d(1, 0, 0.3);
        side.edge = BezierCurve(poles);
        if (position_alone) side.cross.reset();
      }
      const ThreeSidedFill fill = threeSidedFill(sides, {.fairness_order = order});
      EXPECT_LT(error(fill, test::plane()), 1e-12);
      EXPECT_TRUE(fill.regular);
    }
}

// The distance found by another program of the same problem is 0.0279 mm; patches without tangent
// planes are off by 0.6 mm.
TEST(ThreeSidedFillOfSurface, FillsStayNearSphereAndTorus) {
  const ThreeSidedFill cap = threeSidedFill(hole(test::sphere(20)));
  EXPECT_NEAR(error(cap, test::sphere(20)), 0.0279, 1e-3);
  EXPECT_LT(error(threeSidedFill(skew(test::sphere(20))), test::sphere(20)), 0.06);
  EXPECT_LT(error(threeSidedFill(hole(test::torus(20, 15))), test::torus(20, 15)), 0.1);
  EXPECT_GT(cap.triangles[0].point(0, 0).z(), cap.triangles[0].point(0.5, 0.5).z());
  EXPECT_TRUE(cap.regular);
}

// Three quarters of cylinders of radius 10 end at the arcs; of the fields only their direction
// counts.
TEST(ThreeSidedFillOfSurface, EighthOfASphere) {
  const double handle = 4 * (std::sqrt(2.0) - 1) / 3;
  std::vector<FillSide> sides;
  for (int k = 0; k < 3; ++k) {
    const Vector3d a = 10 * Vector3d::Unit(k), b = 10 * Vector3d::Unit((k + 1) % 3);
    Poles arc(4, 3);
    arc << a.transpose(), (a + handle * b).transpose(), (handle * a + b).transpose(), b.transpose();
    sides.push_back({BezierCurve(arc), Poles(-Vector3d::Unit((k + 2) % 3).transpose() * (k + 1))});
  }
  const ThreeSidedFill fill = threeSidedFill(sides);
  EXPECT_TRUE(fill.regular);
  const Eigen::Matrix3d turn = (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();
  for (int k = 0; k < 3; ++k) {
    const BezierTriangle& triangle = fill.triangles[k];
    EXPECT_EQ(triangle.degree(), 4);
    EXPECT_LT(test::spokeAngle(fill, k), 1e-9);
    EXPECT_LT(test::sideAngle(fill, sides, k), 1e-9);
    EXPECT_LT((fill.triangles[(k + 1) % 3].poles() - triangle.poles() * turn.transpose())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
    for (double u : {0.0, 0.2, 0.4})
      for (double v : {0.1, 0.3, 0.6}) EXPECT_NEAR(triangle.point(u, v).norm(), 10, 0.35);
  }
}

template <class Matcher>
void expectRefused(const std::vector<FillSide>& sides, const Matcher& message,
                   ThreeSidedFillOptions options = {}) {
  EXPECT_THAT([&] { threeSidedFill(sides, options); },
              ThrowsMessage<std::invalid_argument>(message));
}

TEST(ThreeSidedFillLimits, RefusesBadNumbersAndOptions) {
  std::vector<FillSide> sides = hole(test::plane());
  for (int order : {1, 4})
    expectRefused(sides, HasSubstr("fairness order"), {.fairness_order = order});
  for (double bad : {-1e-3, 0.2, std::numeric_limits<double>::quiet_NaN()})
    expectRefused(sides, HasSubstr("corner tolerance"), {.corner_tolerance_rad = bad});
  expectRefused({}, HasSubstr("0 sides: a fill by triangles has 3"));
  sides.resize(2, sides[0]);
  expectRefused(sides, HasSubstr("2 sides"));
  sides.resize(4, sides[0]);
  expectRefused(sides, HasSubstr("4 sides"));
}

TEST(ThreeSidedFillLimits, RefusesBadEdgesAndFields) {
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<FillSide> sides = hole(test::plane());
    (*sides[2].cross)(3, 1) = bad;
    expectRefused(sides, HasSubstr("side 2: coefficient 3 of the cross-boundary derivative is "));
  }
  std::vector<FillSide> sides = hole(test::plane());
  expectRefused({sides[1], sides[0], sides[2]}, HasSubstr("side 0 begins"));
  sides[1].edge = BezierCurve(sides[1].edge.poles(), Eigen::VectorXd::LinSpaced(6, 1, 2));
  expectRefused(sides, HasSubstr("side 1: the edge is rational"));
  sides = hole(test::plane());
  sides[2].cross = Poles(sides[2].edge.poles().bottomRows(1) - sides[2].edge.poles().topRows(1));
  expectRefused(sides, AllOf(HasSubstr("side 2"), HasSubstr("parallel to the edge")));
  sides = hole(test::plane());
  for (FillSide& side : sides) side.cross = -*side.cross;
  expectRefused(sides, HasSubstr("split the hole"));
}

TEST(ThreeSidedFillLimits, RefusesAnAngleOfPi) {
  std::vector<FillSide> sides = test::graphHole(test::plane(), {{10, 0}, {-10, 10}, {-10, -10}});
  const auto [first, second] = sides[0].edge.split(0.5);
  const auto [before, after] = BezierCurve(*sides[0].cross).split(0.5);
  Poles close(3, 3);
  close << sides[1].edge.poles().topRows(1), sides[2].edge.poles().topRows(1),
      sides[0].edge.poles().topRows(1);
  expectRefused({{first, before.poles()}, {second, after.poles()}, {BezierCurve(close)}},
                HasSubstr("corner 1: the angle of the hole is 180 degrees: merge the two sides"));
}

TEST(ThreeSidedFillLimits, TangentPlanesOfACornerDiffer) {
  std::vector<FillSide> sides = hole(test::plane());
  sides[0].cross->col(2).array() += 0.003;
  expectRefused(sides, HasSubstr("corner 0: the tangent planes of its sides differ by"));
  const ThreeSidedFill fill = threeSidedFill(sides, {.corner_tolerance_rad = 2e-3});
  EXPECT_FALSE(fill.corners[0].exact || fill.corners[1].exact);
  EXPECT_TRUE(fill.corners[2].exact);
  for (int k = 0; k < 3; ++k) {
    EXPECT_LT(test::spokeAngle(fill, k), 1e-9);
    const double bound =
        std::max(fill.corners[k].angle_bound_rad, fill.corners[(k + 1) % 3].angle_bound_rad);
    EXPECT_GT(bound, 0);
    EXPECT_LT(bound, 4e-3);
    EXPECT_LE(test::sideAngle(fill, sides, k), bound + 1e-12);
  }
  EXPECT_GT(test::sideAngle(fill, sides, 0), 1e-5);
}

TEST(ThreeSidedFillLimits, BoundOfOneCornerAlone) {
  for (int end : {0, 1}) {
    std::vector<FillSide> sides = hole(test::plane());
    (*sides[0].cross)(3 * end, 2) += 0.003;
    const ThreeSidedFill fill = threeSidedFill(sides, {.corner_tolerance_rad = 2e-3});
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(fill.corners[k].exact, k != end);
      EXPECT_EQ(fill.corners[k].angle_bound_rad > 0, k == end);
    }
    const double angle = test::sideAngle(fill, sides, 0), bound = fill.corners[end].angle_bound_rad;
    EXPECT_LE(angle, bound + 1e-12);
    EXPECT_GT(angle, bound / 2);
    EXPECT_LT(test::sideAngle(fill, sides, 2 - end), 1e-9);
  }
}

TEST(ProvedRegularOfTriangle, FlatFoldedAndCollapsed) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 12; ++run)
    EXPECT_TRUE(provedRegular(test::gentleTriangle(1 + run % 4, false, random)));
  Poles line(3, 3), folded(6, 3);
  line << 0, 0, 0, 1, 1, 0, 2, 2, 0;
  EXPECT_FALSE(provedRegular(BezierTriangle(line)));
  // x = u (u - 1), y = v turns back at u = 1/2.
  folded << 0, 0, 0, 0, 0.5, 0, 0, 1, 0, -0.5, 0, 0, -0.5, 0.5, 0, 0, 0, 0;
  EXPECT_FALSE(provedRegular(BezierTriangle(folded)));
}

}  // namespace
}  // namespace seamwright
