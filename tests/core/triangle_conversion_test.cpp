// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <fstream>
#include <limits>
#include <seamwright/core/bezier/triangle_conversion.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>

#include "seam_sides.hpp"
#include "support/random.hpp"
#include "triangles.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::Vec;
using testing::HasSubstr;

const std::array<Barycentric, 3> kCorners = {Barycentric(1, 0, 0), Barycentric(0, 1, 0),
                                             Barycentric(0, 0, 1)};

Vec exactAt(const BezierTriangle& triangle, const Barycentric& l) {
  return test::exactPoint(triangle, l);
}

double largestPole(const BezierTriangle& triangle) {
  return triangle.poles().rowwise().norm().maxCoeff();
}

/// (1-u, u(1-v), uv) from corner \p apex on.
Barycentric degenerateAt(int apex, double u, double v) {
  Barycentric l;
  l(apex) = 1 - u;
  l((apex + 1) % 3) = u * (1 - v);
  l((apex + 2) % 3) = u * v;
  return l;
}

Barycentric quadrangleAt(int k, double u, double v) {
  const Barycentric& a = kCorners[k];
  const Barycentric b = 0.5 * (a + kCorners[(k + 1) % 3]), d = 0.5 * (a + kCorners[(k + 2) % 3]);
  const Barycentric c = Barycentric::Constant(1.0 / 3);
  return (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d;
}

const std::vector<double> kPlaces = {0, 0.13, 0.5, 0.71, 1};

BezierTriangle triangleOf(const json& net) {
  const int n = static_cast<int>(net.size()) - 1;
  Poles poles(BezierTriangle::row(n, n, 0) + 1, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(poles.rows());
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const Eigen::Index row = BezierTriangle::row(n, i, j);
      const json& pole = net[i][j];
      if (pole.size() == 4) weights(row) = test::number(pole[3]);
      poles.row(row) = test::vector(pole).transpose() / weights(row);
    }
  return {poles, weights};
}

void expectNet(const BezierPatch& patch, const json& net) {
  const BezierPatch wanted = test::patch(net);
  EXPECT_LT((patch.homogeneousPoles() - wanted.homogeneousPoles()).cwiseAbs().maxCoeff(),
            1e-14 * wanted.homogeneousPoles().cwiseAbs().maxCoeff());
}

TEST(TriangleConversion, NetsEqualThoseOfMultiPrecision) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/triangle_conversions.json");
  const json cases = json::parse(file).at("cases");
  ASSERT_EQ(cases.size(), 6U);
  for (const json& entry : cases) {
    SCOPED_TRACE(entry["id"]);
    const BezierTriangle triangle = triangleOf(entry["input"]["T"]);
    expectNet(degeneratePatch(triangle), entry["expected"]["degenerate"]);
    const std::array<BezierPatch, 3> patches = regularPatches(triangle);
    for (int k = 0; k < 3; ++k) expectNet(patches[k], entry["expected"]["quads"][k]);
    EXPECT_EQ(recogniseTriangle(test::patch(entry["expected"]["degenerate"])).triangle->degree(),
              triangle.degree());
  }
}

// Identity 1
TEST(TriangleConversion, TheDegeneratePatchIsTheTriangle) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 8; ++degree)
    for (const bool rational : {false, true})
      for (int apex = 0; apex < 3; ++apex) {
        const BezierTriangle triangle = test::randomTriangle(degree, rational, random);
        const BezierPatch patch = degeneratePatch(triangle, apex);
        EXPECT_EQ(patch.isRational(), triangle.isRational());
        for (const double u : kPlaces)
          for (const double v : kPlaces)
            EXPECT_LT((patch.point(u, v) - exactAt(triangle, degenerateAt(apex, u, v))).norm(),
                      1e-13 * largestPole(triangle));
        const BezierCurve seam = triangle.edgeCurve(static_cast<TriangleEdge>(apex));
        for (int j = 0; j <= degree; ++j) {
          EXPECT_EQ(patch.pole(0, j), patch.pole(0, 0));
          EXPECT_EQ(patch.pole(degree, j).transpose(), seam.poles().row(j));
        }
      }
}

// Identity 2
TEST(TriangleConversion, ThreeRegularPatchesAreTheTriangle) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 8; ++degree)
    for (const bool rational : {false, true}) {
      const BezierTriangle triangle = test::randomTriangle(degree, rational, random);
      const std::array<BezierPatch, 3> patches = regularPatches(triangle);
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(patches[k].isRational(), triangle.isRational());
        for (const double u : kPlaces)
          for (const double v : kPlaces)
            EXPECT_LT((patches[k].point(u, v) - exactAt(triangle, quadrangleAt(k, u, v))).norm(),
                      1e-13 * largestPole(triangle));
      }
    }
}

// Identity 3
TEST(TriangleConversion, ThreeRegularPatchesShareTheirBoundaries) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree)
    for (const bool rational : {false, true}) {
      const BezierTriangle triangle = test::randomTriangle(degree, rational, random);
      const std::array<BezierPatch, 3> patches = regularPatches(triangle);
      for (int k = 0; k < 3; ++k) {
        const BezierPatch& next = patches[(k + 1) % 3];
        const auto [half, rest] = triangle.edgeCurve(static_cast<TriangleEdge>((k + 2) % 3))
                                      .split(0.5);  // from Pk to Pk+1
        for (int i = 0; i <= degree; ++i) {
          EXPECT_EQ(patches[k].pole(degree, i), next.pole(i, degree));
          EXPECT_LT((patches[k].pole(i, 0).transpose() - half.poles().row(i)).norm(),
                    1e-15 * degree * 4);
          EXPECT_LT((next.pole(0, degree - i).transpose() - rest.poles().row(i)).norm(),
                    1e-15 * degree * 4);
        }
      }
    }
}

// Identity 3
TEST(TriangleConversion, RegularPatchesAndTheTriangleHaveTheSameNormalsAndCurvature) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 6; ++degree)
    for (const bool rational : {false, true}) {
      const BezierTriangle triangle = test::randomTriangle(degree, rational, random);
      const auto tensorAt = [](const SurfaceJet& x, const JetNoise& noise) {
        return curvatureTensor(x, unitNormal(x, noise).value());
      };
      const std::array<BezierPatch, 3> patches = regularPatches(triangle);
      for (int k = 0; k < 3; ++k)
        for (const auto& [u, v] : {std::pair(0.0, 0.0), std::pair(0.3, 0.8), std::pair(1.0, 1.0)}) {
          const Barycentric l = quadrangleAt(k, u, v);
          const auto wanted = tensorAt(triangle.jet(l(0), l(1)), triangle.noise());
          const auto found = tensorAt(patches[k].jet(u, v), patches[k].noise());
          EXPECT_LT((wanted - found).norm(), 1e-8 * (1 + wanted.norm())) << degree << ' ' << k;
        }
    }
}

/// The coefficients of the polynomials whose coefficients of one degree less are the rows.
template <class Rows>
Rows elevatedRows(const Rows& c) {
  Rows higher(c.rows() + 1, c.cols());
  for (Eigen::Index i = 0; i <= c.rows(); ++i) {
    higher.row(i).setZero();
    const auto share = static_cast<double>(i) / static_cast<double>(c.rows());
    if (i > 0) higher.row(i) += share * c.row(i - 1);
    if (i < c.rows()) higher.row(i) += (1 - share) * c.row(i);
  }
  return higher;
}

BezierPatch patchOf(int m, int n, const HomogeneousPoles& h) {
  return {m, n, h.leftCols<3>().array().colwise() / h.col(3).array(), h.col(3)};
}

BezierPatch elevatedU(const BezierPatch& patch) {
  using Net = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const int m = patch.degreeU(), n = patch.degreeV();
  Net net = patch.homogeneousPoles().reshaped<Eigen::RowMajor>(m + 1, 4 * (n + 1));
  net = elevatedRows(net);
  if (!patch.isRational())
    for (Eigen::Index j = 3; j < net.cols(); j += 4) net.col(j).setOnes();
  return patchOf(m + 1, n, net.reshaped<Eigen::RowMajor>((m + 2) * (n + 1), 4));
}

BezierPatch elevatedV(const BezierPatch& patch) {
  return elevatedU(patch.transposed()).transposed();
}

/// The same patch turned in its parameter plane so that its boundary u = 0 becomes that edge.
BezierPatch turned(const BezierPatch& patch, PatchEdge edge) {
  const BezierPatch quarter = patch.transposed().reversedU();  // u = 0 becomes v = 0
  if (edge == PatchEdge::V0) return quarter;
  const BezierPatch half = quarter.transposed().reversedU();
  if (edge == PatchEdge::U1) return half;
  return edge == PatchEdge::V1 ? half.transposed().reversedU() : patch;
}

/// The same patch turned so that this edge becomes the boundary u = 0.
BezierPatch turnedBack(const BezierPatch& patch, PatchEdge edge) {
  if (edge == PatchEdge::V0) return turned(patch, PatchEdge::V1);
  return turned(patch, edge == PatchEdge::V1 ? PatchEdge::V0 : edge);
}

constexpr std::array kEdges = {PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1};

// Identity 5
TEST(TriangleConversion, TrianglesAreRecognisedAtAnyEdgeInAnyDegree) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree)
    for (const bool rational : {false, true})
      for (const PatchEdge edge : kEdges) {
        const BezierTriangle triangle = test::randomTriangle(degree, rational, random);
        BezierPatch patch = degeneratePatch(triangle);
        for (int k = static_cast<int>(random() % 4); k > 0; --k) patch = elevatedU(patch);
        for (int k = static_cast<int>(random() % 3); k > 0; --k) patch = elevatedV(patch);
        const TriangleRecognition found = recogniseTriangle(turned(patch, edge));
        ASSERT_TRUE(found.triangle) << degree << ' ' << patch.degreeU() << ' ' << patch.degreeV()
                                    << ' ' << found.deviation_mm << ' ' << found.tolerance_mm;
        EXPECT_EQ(found.triangle->degree(), degree);
        EXPECT_EQ(found.apex, edge);
        EXPECT_EQ(found.triangle->isRational(), triangle.isRational());
        EXPECT_LT(found.tolerance_mm, 1e-11);
        EXPECT_LT((found.triangle->poles() - triangle.poles()).cwiseAbs().maxCoeff(), 1e-11);
      }
}

// Identity 5
TEST(TriangleConversion, PolesOfTheEdgesComeBackAsTheyWere) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree) {
    const BezierTriangle triangle = test::randomTriangle(degree, false, random);
    const BezierTriangle back = recogniseTriangle(degeneratePatch(triangle)).triangle.value();
    for (const TriangleEdge edge : {TriangleEdge::L0, TriangleEdge::L1, TriangleEdge::L2})
      EXPECT_EQ(back.edgeCurve(edge), triangle.edgeCurve(edge));
  }
}

TEST(TriangleConversion, TheLowestDegreeIsFound) {
  std::mt19937_64 random(testSeed());
  for (int degree = 0; degree <= 5; ++degree)
    for (const bool rational : {false, true}) {
      const BezierTriangle triangle = test::randomTriangle(degree, rational && degree > 0, random);
      const BezierPatch patch = degeneratePatch(triangle.elevated().elevated().elevated());
      EXPECT_EQ(patch.degreeU(), degree + 3);
      EXPECT_EQ(recogniseTriangle(patch).triangle.value().degree(), degree);
    }
}

/// A polynomial patch with u = 0 collapsed whose row r has exactly that degree in v; highest is
/// degree_v.
BezierPatch patchWithRows(const std::vector<int>& row_degrees, int degree_v,
                          std::mt19937_64& random) {
  const int m = static_cast<int>(row_degrees.size()) - 1;
  Poles poles((m + 1) * (degree_v + 1), 3);
  for (int r = 0; r <= m; ++r) {
    Poles row(row_degrees[r] + 1, 3);
    for (Eigen::Index i = 0; i < row.rows(); ++i)
      row.row(i) = test::randomVector(random).transpose();
    while (row.rows() <= degree_v) row = elevatedRows(row);
    poles.middleRows(r * (degree_v + 1), degree_v + 1) = row;
  }
  return {m, degree_v, poles};
}

// Identity 4
TEST(TriangleConversion, RowsOfNoHigherDegreeThanTheirNumberMakeATriangle) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    const int m = 1 + static_cast<int>(random() % 6), n = 1 + static_cast<int>(random() % 6);
    std::vector<int> degrees(m + 1, 0);
    for (int r = 1; r <= m; ++r) {
      const int beyond = random() % 4 == 0 ? 1 : 0;
      degrees[r] = static_cast<int>(random() % (std::min(n, r + beyond) + 1));
    }
    bool from_first = true, from_last = true;  // the row that is P0
    for (int r = 0; r <= m; ++r) {
      from_first = from_first && degrees[r] <= r;
      from_last = from_last && degrees[r] <= m - r;
    }
    const bool triangle = from_first || from_last;
    const BezierPatch patch = patchWithRows(degrees, n, random);
    const TriangleRecognition found = recogniseTriangle(patch);
    EXPECT_EQ(found.triangle.has_value(), triangle) << m << ' ' << n << ' ' << found.deviation_mm;
    if (!found.triangle || found.apex != PatchEdge::U0) continue;
    EXPECT_EQ(found.triangle->degree(), m);
    for (const double u : kPlaces)
      for (const double v : kPlaces)
        EXPECT_LT((patch.point(u, v) - exactAt(*found.triangle, degenerateAt(0, u, v))).norm(),
                  1e-12);
  }
}

TEST(TriangleConversion, TheDeviationBoundsTheDistance) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const int degree = 2 + i % 5;
    const BezierTriangle triangle = test::randomTriangle(degree, i % 2 == 0, random);
    const BezierPatch exact = degeneratePatch(triangle);
    HomogeneousPoles h = exact.homogeneousPoles();
    const double size = test::logUniform(random, -6, -1);
    for (double& value : h.reshaped()) value += size * test::randomVector(random).x();
    if (i % 2) h.col(3).setOnes();
    if (h.col(3).minCoeff() <= 0) continue;
    const BezierPatch moved = patchOf(degree, degree, h);
    const TriangleRecognition refused = recogniseTriangle(moved);
    EXPECT_FALSE(refused.triangle);
    EXPECT_GT(refused.deviation_mm, refused.tolerance_mm);
    const TriangleRecognition accepted = recogniseTriangle(moved, 1.001 * refused.deviation_mm);
    ASSERT_TRUE(accepted.triangle);
    EXPECT_LE(accepted.deviation_mm, accepted.tolerance_mm);
    const BezierPatch back = turnedBack(moved, accepted.apex);
    double largest = 0;
    for (const double u : kPlaces)
      for (const double v : kPlaces) {
        const Vec wanted = exactAt(*accepted.triangle, degenerateAt(0, u, v));
        largest = std::max(largest, (back.point(u, v) - wanted).norm());
      }
    EXPECT_LE(largest, accepted.deviation_mm * (1 + 1e-12));
    EXPECT_GT(largest, 1e-3 * accepted.deviation_mm);
  }
}

TEST(TriangleConversion, TheDeviationMovesWithThePatch) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const int degree = 2 + i % 5;
    HomogeneousPoles h =
        degeneratePatch(test::randomTriangle(degree, true, random)).homogeneousPoles();
    for (double& value : h.reshaped()) value += 0.01 * test::randomVector(random).x();
    const BezierPatch patch = patchOf(degree, degree, h);
    const double scale = test::logUniform(random, -3, 3);
    const Eigen::Matrix3d A = scale * test::randomRotation(random);
    const Eigen::RowVector3d by = scale * 100 * test::randomVector(random).transpose();
    const BezierPatch moved(degree, degree, (patch.poles() * A.transpose()).rowwise() + by,
                            7 * patch.weights());
    const double deviation = recogniseTriangle(patch).deviation_mm;
    EXPECT_NEAR(recogniseTriangle(moved).deviation_mm, scale * deviation, 1e-9 * scale * deviation);
    EXPECT_NEAR(recogniseTriangle(turned(patch, PatchEdge::V1)).deviation_mm, deviation,
                1e-12 * deviation);
  }
}

TEST(TriangleConversion, NaturalNormalsAgree) {
  std::mt19937_64 random(testSeed());
  const BezierTriangle triangle = test::randomTriangle(3, true, random);
  const auto expectSame = [](const SurfaceJet& a, const SurfaceJet& b) {
    EXPECT_LT((a.p - b.p).norm(), 1e-13);
    EXPECT_GT(unitNormal(a).value().dot(unitNormal(b).value()), 1 - 1e-12);
  };
  const auto jetAt = [](const BezierTriangle& t, const Barycentric& l) {
    return t.jet(l(0), l(1));
  };
  for (int k = 0; k < 3; ++k) {
    expectSame(degeneratePatch(triangle, k).jet(0.6, 0.3),
               jetAt(triangle, degenerateAt(k, 0.6, 0.3)));
    expectSame(regularPatches(triangle)[k].jet(0.6, 0.3),
               jetAt(triangle, quadrangleAt(k, 0.6, 0.3)));
  }
  for (const PatchEdge edge : kEdges) {
    const BezierPatch patch = turned(degeneratePatch(triangle), edge);
    const BezierTriangle found = recogniseTriangle(patch).triangle.value();
    expectSame(patch.jet(0.5, 0.5), jetAt(found, degenerateAt(0, 0.5, 0.5)));
  }
}

TEST(TriangleConversion, NoiseBoundsTheRoundingOfConversion) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const int degree = 1 + i % 8;
    const Poles poles =
        test::logUniform(random, -3, 4) * (test::randomNet(degree, random).array() + 100).matrix();
    const BezierTriangle triangle =
        i % 2 ? BezierTriangle(poles)
              : BezierTriangle(poles, test::randomNetWeights(degree, random));
    const BezierPatch patch = degeneratePatch(triangle);
    for (int r = 0; r <= degree; ++r)
      for (int j = 0; j <= degree; ++j) {
        // The pole (r, j) is the blossom of P0 n-r times, and of P1 and P2 as the hypergeometric
        // sum says.
        test::LongVec4 h = test::LongVec4::Zero();
        for (int c = std::max(0, r + j - degree); c <= std::min(r, j); ++c)
          h += static_cast<long double>(test::choose(r, c) * test::choose(degree - r, j - c)) /
               static_cast<long double>(test::choose(degree, j)) *
               triangle.homogeneousPoles()
                   .row(BezierTriangle::row(degree, degree - r, r - c))
                   .transpose()
                   .cast<long double>();
        const auto exact = (h.head<3>() / h(3)).eval();
        EXPECT_LE((patch.pole(r, j).cast<long double>() - exact).norm(), conversionNoise(triangle));
      }
  }
}

TEST(TriangleConversion, WhatIsNoTriangleIsRefused) {
  Poles square(4, 3);
  square << 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0;
  const TriangleRecognition plane = recogniseTriangle(BezierPatch(1, 1, square));
  EXPECT_FALSE(plane.triangle);
  EXPECT_NEAR(plane.deviation_mm, 0.5, 1e-15);  // half of the edge that is not a point

  // An octant of a sphere: one edge is a point, but the homogeneous poles on it differ by their
  // weights.
  const double w = std::sqrt(0.5);
  Poles octant(9, 3);
  octant << 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  Eigen::VectorXd weights(9);
  weights << 1, w, 1, w, w * w, w, 1, w, 1;
  const TriangleRecognition sphere = recogniseTriangle(BezierPatch(2, 2, octant, weights));
  EXPECT_FALSE(sphere.triangle);
  EXPECT_GT(sphere.deviation_mm, 0.01);
}

TEST(TriangleConversion, DegeneratePatchesOfAnySortAreAnswered) {
  const BezierPatch point(3, 2, Poles::Constant(12, 3, 0.1));
  const TriangleRecognition found = recogniseTriangle(point);
  EXPECT_EQ(found.triangle.value().degree(), 0);
  EXPECT_EQ(found.deviation_mm, 0);
  EXPECT_EQ(recogniseTriangle(BezierPatch(0, 0, Poles::Zero(1, 3))).triangle.value().degree(), 0);
  Poles line(4, 3);
  line << 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0;  // of degree 1 in u, constant in v
  EXPECT_EQ(recogniseTriangle(BezierPatch(1, 1, line)).triangle.value().degree(), 1);
  Poles curve(3, 3);
  curve << 0, 0, 0, 1, 2, 0, 3, 1, 0;
  EXPECT_EQ(recogniseTriangle(BezierPatch(2, 0, curve)).triangle.value().degree(), 2);
}

TEST(TriangleConversion, BadArgumentsAreNamed) {
  const BezierTriangle triangle(Poles::Zero(3, 3));
  const auto complaint = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(complaint([&] { degeneratePatch(triangle, 3); }), HasSubstr("apex 3"));
  EXPECT_THAT(complaint([&] { degeneratePatch(triangle, -1); }), HasSubstr("apex -1"));
  const BezierPatch patch = degeneratePatch(triangle);
  EXPECT_THAT(complaint([&] { recogniseTriangle(patch, -1); }), HasSubstr("tolerance_mm is -1"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(complaint([&] { recogniseTriangle(patch, nan); }), HasSubstr("tolerance_mm is nan"));
}

}  // namespace
}  // namespace seamwright
