// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <seamwright/core/bezier/triangle.hpp>

#include "support/random.hpp"
#include "triangles.hpp"

namespace seamwright {
namespace {

using test::Vec;
using testing::AllOf;
using testing::HasSubstr;

const std::array<Barycentric, 3> kCorners = {Barycentric(1, 0, 0), Barycentric(0, 1, 0),
                                             Barycentric(0, 0, 1)};

Vec pointAt(const BezierTriangle& triangle, const Barycentric& l) {
  return triangle.point(l(0), l(1));
}

/// Triangles whose poles all coincide, lie on a line, or lie on one point along an edge.
std::vector<BezierTriangle> degenerateTriangles(int degree, std::mt19937_64& random) {
  Poles equal = test::randomNet(degree, random), line = equal, edge = equal;
  equal.rowwise() = equal.row(0).eval();
  const Vec along = test::randomVector(random);
  for (Eigen::Index i = 0; i < line.rows(); ++i)
    line.row(i) = (test::randomVector(random).x() * along).transpose();
  edge.topRows(degree + 1).rowwise() = edge.row(0).eval();
  const Eigen::VectorXd weights = test::randomNetWeights(degree, random);
  return {BezierTriangle(equal), BezierTriangle(line), BezierTriangle(edge),
          BezierTriangle(edge, weights)};
}

std::vector<BezierTriangle> allTriangles(int degree, std::mt19937_64& random) {
  std::vector<BezierTriangle> triangles = degenerateTriangles(degree, random);
  for (const bool rational : {false, true})
    triangles.push_back(test::randomTriangle(degree, rational, random));
  return triangles;
}

TEST(BezierTriangle, PointsEqualTheDefinition) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 8; ++degree)
    for (const BezierTriangle& triangle : allTriangles(degree, random)) {
      EXPECT_EQ(triangle.degree(), degree);
      for (int i = 0; i < 5; ++i) {
        const Barycentric l = test::randomBarycentric(random);
        EXPECT_LT((pointAt(triangle, l) - test::exactPoint(triangle, l)).norm(), 3e-14) << degree;
      }
      EXPECT_EQ(triangle.point(1, 0), triangle.pole(degree, 0));
      EXPECT_EQ(triangle.point(0, 1), triangle.pole(0, degree));
      EXPECT_EQ(triangle.point(0, 0), triangle.pole(0, 0));
    }
}

/// The partial of order (a, b) of a jet.
Vec partial(const SurfaceJet& x, int a, int b) {
  const std::array<std::array<Vec, 4>, 4> table = {
      {{x.p, x.v, x.vv, x.vvv},
       {x.u, x.uv, x.uvv, Vec::Zero()},
       {x.uu, x.uuv, Vec::Zero(), Vec::Zero()},
       {x.uuu, Vec::Zero(), Vec::Zero(), Vec::Zero()}}};
  return table[a][b];
}

TEST(BezierTriangle, HomogeneousPolesAreTakenOverBitByBit) {
  HomogeneousPoles poles(6, 4);
  for (int i = 0; i < 6; ++i) poles.row(i) << 0.1, 0.2, i / 7.0, 1 + i / 3.0;
  const BezierTriangle triangle = BezierTriangle::fromHomogeneous(poles);
  EXPECT_EQ(triangle.homogeneousPoles(), poles);
  EXPECT_EQ(triangle.degree(), 2);
  EXPECT_THROW(BezierTriangle::fromHomogeneous(poles.topRows(5)), std::invalid_argument);
  poles(1, 3) = -2;
  EXPECT_THAT([&] { BezierTriangle::fromHomogeneous(poles); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("weight 1 is -2")));
}

TEST(BezierTriangle, JetsEqualTheDefinitionToThirdOrder) {
  // A = (wx, wy, wz) and w from the definition, Leibniz' rule: A_ab = sum C(a,i) C(b,j) w_ij
  // X_(a-i)(b-j).
  constexpr int binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 8; ++degree)
    for (const bool rational : {false, true}) {
      const BezierTriangle triangle = test::randomTriangle(degree, rational, random);
      const Barycentric l = test::randomBarycentric(random);
      const SurfaceJet x = triangle.jet(l(0), l(1));
      for (int a = 0; a < 4; ++a)
        for (int b = 0; a + b < 4; ++b) {
          const test::LongVec4 h = test::exactPartial(triangle, a, b, l(0), l(1));
          Eigen::Matrix<long double, 3, 1> sum = Eigen::Matrix<long double, 3, 1>::Zero();
          long double size = 1;
          for (int i = 0; i <= a; ++i)
            for (int j = 0; j <= b; ++j) {
              const auto term = (binomial[a][i] * binomial[b][j] *
                                 test::exactPartial(triangle, i, j, l(0), l(1))(3) *
                                 partial(x, a - i, b - j).cast<long double>())
                                    .eval();
              sum += term;
              size += term.norm();
            }
          EXPECT_LT((sum - h.head<3>()).norm(), 1e-13L * size * std::pow(degree + 1, a + b))
              << degree << ' ' << a << ' ' << b;
        }
    }
}

TEST(BezierTriangle, NoiseBoundsTheRoundingOfFirstPartials) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const int degree = 1 + i % 7;
    const Poles poles =
        test::logUniform(random, -3, 4) * (test::randomNet(degree, random).array() + 100).matrix();
    const BezierTriangle triangle =
        i % 2 ? BezierTriangle(poles)
              : BezierTriangle(poles, test::randomNetWeights(degree, random));
    const Barycentric l = test::randomBarycentric(random);
    const SurfaceJet x = triangle.jet(l(0), l(1));
    const test::LongVec4 h = test::exactPartial(triangle, 0, 0, l(0), l(1));
    for (const int a : {0, 1}) {
      const test::LongVec4 d = test::exactPartial(triangle, a, 1 - a, l(0), l(1));
      const auto exact = ((d.head<3>() - d(3) * h.head<3>() / h(3)) / h(3)).eval();
      EXPECT_LE((partial(x, a, 1 - a).cast<long double>() - exact).norm(), triangle.noise().u)
          << degree;
    }
  }
}

// Identity 1
TEST(BezierTriangle, BlossomHasPointsOnItsDiagonalAndPolesAtCorners) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 8; ++degree)
    for (const BezierTriangle& triangle : allTriangles(degree, random)) {
      const Barycentric l = test::randomBarycentric(random);
      const Eigen::Vector4d h = triangle.blossom(std::vector<Barycentric>(degree, l));
      EXPECT_LT((h - test::exactPartial(triangle, 0, 0, l(0), l(1)).cast<double>()).norm(), 1e-13);
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j) {
          std::vector<Barycentric> arguments(i, kCorners[0]);
          arguments.insert(arguments.begin(), j, kCorners[1]);
          arguments.resize(degree, kCorners[2]);
          EXPECT_EQ(triangle.blossom(arguments).transpose(),
                    triangle.homogeneousPoles().row(BezierTriangle::row(degree, i, j)));
        }
    }
}

// Identity 2
TEST(BezierTriangle, BlossomIsSymmetricAndAffine) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree) {
    const BezierTriangle triangle = test::randomTriangle(degree, degree % 2 == 0, random);
    std::vector<Barycentric> arguments(degree);
    std::ranges::generate(arguments, [&] { return test::randomBarycentric(random); });
    const Eigen::Vector4d value = triangle.blossom(arguments);
    const Barycentric first = arguments.front(), other = test::randomBarycentric(random);
    for (int i = 0; i < 10; ++i) {
      std::ranges::shuffle(arguments, random);
      EXPECT_EQ(triangle.blossom(arguments), value);
    }
    const auto place = std::ranges::find(arguments, first);
    *place = other;
    const Eigen::Vector4d moved = triangle.blossom(arguments);
    *place = 0.3 * first + 0.7 * other;
    EXPECT_LT((triangle.blossom(arguments) - (0.3 * value + 0.7 * moved)).norm(), 1e-13);
  }
}

// Identity 3
TEST(BezierTriangle, ElevationAndPermutationKeepTheShape) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 8; ++degree)
    for (const BezierTriangle& triangle : allTriangles(degree, random)) {
      const BezierTriangle higher = triangle.elevated();
      EXPECT_EQ(higher.degree(), degree + 1);
      EXPECT_EQ(higher.isRational(), triangle.isRational());
      const Barycentric l = test::randomBarycentric(random);
      EXPECT_LT((pointAt(higher, l) - test::exactPoint(triangle, l)).norm(), 1e-13);
      for (const std::array<int, 3>& corners :
           {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{2, 0, 1}, std::array{0, 2, 1},
            std::array{1, 0, 2}, std::array{2, 1, 0}}) {
        Barycentric moved;
        for (int c = 0; c < 3; ++c) moved(corners[c]) = l(c);
        EXPECT_LT(
            (pointAt(triangle.permuted(corners), l) - test::exactPoint(triangle, moved)).norm(),
            3e-14);
      }
      EXPECT_EQ(triangle.permuted({1, 2, 0}).permuted({2, 0, 1}), triangle);
    }
}

// Identity 3
TEST(BezierTriangle, PartsKeepTheShape) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 8; ++degree)
    for (const BezierTriangle& triangle : allTriangles(degree, random)) {
      Eigen::Matrix3d corners;
      for (int c = 0; c < 3; ++c) corners.col(c) = test::randomBarycentric(random);
      const BezierTriangle part =
          triangle.subtriangle({corners.col(0), corners.col(1), corners.col(2)});
      EXPECT_EQ(part.isRational(), triangle.isRational());
      const Barycentric l = test::randomBarycentric(random);
      EXPECT_LT((pointAt(part, l) - test::exactPoint(triangle, corners * l)).norm(), 1e-13);
    }
}

BezierCurve edgeFrom(const BezierTriangle& triangle, int from) {
  return triangle.edgeCurve(static_cast<TriangleEdge>((from + 2) % 3));
}

// Identities 3 and 4
TEST(BezierTriangle, SplitsFitTogether) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree)
    for (const BezierTriangle& triangle : allTriangles(degree, random)) {
      const Barycentric s = test::randomBarycentric(random), l = test::randomBarycentric(random);
      const std::array<BezierTriangle, 3> three = triangle.splitAt(s(0), s(1));
      for (int k = 0; k < 3; ++k) {
        const BezierTriangle& next = three[(k + 1) % 3];
        // Behind both lies corner k + 2: the edge from the point to it belongs to k and to k + 1.
        EXPECT_EQ(edgeFrom(three[k], (k + 2) % 3), edgeFrom(next, (k + 1) % 3).reversed());
        EXPECT_EQ(edgeFrom(three[k], (k + 1) % 3), edgeFrom(triangle, (k + 1) % 3));
        Barycentric inside = l;
        inside(k) = 0;
        EXPECT_LT((pointAt(three[k], l) - test::exactPoint(triangle, inside + l(k) * s)).norm(),
                  1e-13);
      }
      const std::array<BezierTriangle, 4> four = triangle.quartered();
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(four[3].edgeCurve(static_cast<TriangleEdge>(k)),
                  four[k].edgeCurve(static_cast<TriangleEdge>(k)).reversed());
        const Barycentric inside = 0.5 * (l + kCorners[k]);
        EXPECT_LT((pointAt(four[k], l) - test::exactPoint(triangle, inside)).norm(), 1e-13);
      }
      EXPECT_LT((pointAt(four[3], l) - test::exactPoint(triangle, 0.5 * (Barycentric::Ones() - l)))
                    .norm(),
                1e-13);
    }
}

TEST(BezierTriangle, EdgesRunInTheirOwnSense) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 6; ++degree)
    for (const BezierTriangle& triangle : allTriangles(degree, random))
      for (int k = 0; k < 3; ++k) {
        const BezierCurve curve = triangle.edgeCurve(static_cast<TriangleEdge>(k));
        EXPECT_EQ(curve.degree(), degree);
        for (const double t : {0.0, 0.3, 1.0}) {
          const Barycentric l = (1 - t) * kCorners[(k + 1) % 3] + t * kCorners[(k + 2) % 3];
          EXPECT_LT((curve.point(t) - test::exactPoint(triangle, l)).norm(), 1e-14);
        }
      }
}

TEST(BezierTriangle, MovesWithItsPoles) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 6; ++degree) {
    const Poles poles = test::randomNet(degree, random);
    const Eigen::VectorXd weights = test::randomNetWeights(degree, random);
    const Eigen::Matrix3d A = test::logUniform(random, -3, 3) * test::randomRotation(random);
    const Vec by = 10 * test::randomVector(random);
    const BezierTriangle moved((poles * A.transpose()).rowwise() + by.transpose(), 7 * weights);
    const Barycentric l = test::randomBarycentric(random);
    const SurfaceJet wanted = test::mapped(BezierTriangle(poles, weights).jet(l(0), l(1)), A, by);
    const SurfaceJet x = moved.jet(l(0), l(1));
    for (int a = 0; a < 4; ++a)
      for (int b = 0; a + b < 4; ++b)
        EXPECT_LT((partial(x, a, b) - partial(wanted, a, b)).norm(),
                  1e-11 * std::pow(degree, 3) * (by.norm() + A.norm()));
  }
}

TEST(BezierTriangle, ANetOfAPolynomialIsPlacedAsItSays) {
  // X = (u, v, u^2 - 3 u v): degree 2 in u = l0, v = l1, from its blossom.
  const auto blossom = [](double u1, double v1, double u2, double v2) {
    return Eigen::RowVector3d((u1 + u2) / 2, (v1 + v2) / 2, u1 * u2 - 1.5 * (u1 * v2 + u2 * v1));
  };
  Poles poles(6, 3);
  poles << blossom(0, 0, 0, 0), blossom(0, 0, 0, 1), blossom(0, 1, 0, 1), blossom(1, 0, 0, 0),
      blossom(1, 0, 0, 1), blossom(1, 0, 1, 0);
  const SurfaceJet x = BezierTriangle(poles).jet(0.2, 0.5);
  EXPECT_LT((x.p - Vec(0.2, 0.5, 0.04 - 0.3)).norm(), 1e-15);
  EXPECT_LT((x.u - Vec(1, 0, 0.4 - 1.5)).norm(), 1e-15);
  EXPECT_LT((x.v - Vec(0, 1, -0.6)).norm(), 1e-15);
  EXPECT_LT((x.uu - Vec(0, 0, 2)).norm() + (x.uv - Vec(0, 0, -3)).norm() + x.vv.norm(), 1e-14);
  EXPECT_EQ(x.uuu.norm() + x.uuv.norm() + x.uvv.norm() + x.vvv.norm(), 0);
}

std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BezierTriangle, BadInputIsNamedByIndexAndValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Poles six = Poles::Zero(6, 3);
  Poles holed = six;
  holed(4, 2) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(complaint([&] { BezierTriangle(Poles(0, 3)); }), HasSubstr("no poles"));
  for (const int count : {2, 4, 5, 7, 9, 14})
    EXPECT_THAT(complaint([&] { BezierTriangle(Poles::Zero(count, 3)); }),
                HasSubstr("poles " + std::to_string(count)));
  EXPECT_THAT(complaint([&] { BezierTriangle{holed}; }), HasSubstr("pole 4"));
  EXPECT_THAT(complaint([&] { BezierTriangle(six, Eigen::VectorXd::Ones(5)); }),
              AllOf(HasSubstr("poles 6"), HasSubstr("weights 5")));
  for (const double bad : {0.0, -2.0, nan}) {
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(6);
    weights(3) = bad;
    EXPECT_THAT(complaint([&] { BezierTriangle(six, weights); }), HasSubstr("weight 3 is"));
  }
  const BezierTriangle triangle(six);
  EXPECT_THAT(complaint([&] { triangle.blossom(kCorners); }), HasSubstr("arguments 3, degree 2"));
  const std::array holed_arguments = {kCorners[0], Barycentric(0, 1, nan)};
  EXPECT_THAT(complaint([&] { triangle.blossom(holed_arguments); }), HasSubstr("argument 1"));
  EXPECT_THAT(complaint([&] { triangle.permuted({0, 1, 1}); }), HasSubstr("0, 1, 1"));
  EXPECT_THAT(complaint([&] { triangle.permuted({0, 1, 3}); }), HasSubstr("0, 1, 3"));
  EXPECT_THAT(complaint([&] {
                triangle.subtriangle({kCorners[0], Barycentric(0, nan, 0), kCorners[2]});
              }),
              HasSubstr("corner 1"));
  Eigen::VectorXd steep = Eigen::VectorXd::Ones(6);
  steep(5) = 9;
  EXPECT_THAT(complaint([&] {
                BezierTriangle(six, steep)
                    .subtriangle({kCorners[0], kCorners[1], Barycentric(-0.5, 1, 0.5)});
              }),
              HasSubstr("of the part is"));
}

}  // namespace
}  // namespace seamwright
