// SPDX-License-Identifier: LGPL-2.1-or-later
// Bezier patches that meet G2 to 40 digits (tests/data/g2_joins.json), continued to known third
// order.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <fstream>
#include <nlohmann/json.hpp>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/seam/judge.hpp>

#include "curves.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::number;
using test::Vec;
using test::vector;

/// Value at t of the polynomial of these Bernstein coefficients.
double bernsteinSum(const json& coefficients, double t) {
  const int n = static_cast<int>(coefficients.size()) - 1;
  double sum = 0, binomial = 1;
  for (int i = 0; i <= n; ++i) {
    sum += binomial * std::pow(t, i) * std::pow(1 - t, n - i) * number(coefficients[i]);
    binomial *= static_cast<double>(n - i) / (i + 1);
  }
  return sum;
}

class G2Join : public testing::TestWithParam<json> {
 protected:
  const json& input_ = GetParam()["input"];

  BezierPatch patchP() const {
    const json& net = input_["P"];
    const int m = static_cast<int>(net.size()) - 1, n = static_cast<int>(net[0].size()) - 1;
    Poles poles((m + 1) * (n + 1), 3);
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= n; ++j) poles.row(i * (n + 1) + j) = vector(net[i][j]).transpose();
    return {m, n, poles};
  }

  /// Rows 0, 1, 2 from the file, the others random. Degree across at least 3.
  BezierPatch patchQ(std::mt19937_64& random) const {
    const json& rows = GetParam()["expected"]["rows"];
    const int l = std::max(3, input_["l"].get<int>()), n = GetParam()["expected"]["along_degree"];
    Poles poles((l + 1) * (n + 1), 3);
    for (int i = 0; i <= l; ++i)
      for (int j = 0; j <= n; ++j)
        poles.row(i * (n + 1) + j) =
            (i < 3 ? vector(rows[i][j]) : Vec(vector(rows[2][j]) + 3 * test::randomVector(random)))
                .transpose();
    return {l, n, poles};
  }

  /// X3: what Q_uuu has beyond the third-order chain rule, up to tangent vectors.
  /// Source: docs/theory/surfaces.md S1.6.
  Vec thirdOrderExcess(const SurfaceJet& p, const SurfaceJet& q, double t) const {
    const double alpha = bernsteinSum(input_["alpha"], t), beta = bernsteinSum(input_["beta"], t);
    const double pp = bernsteinSum(input_["p"], t), qq = bernsteinSum(input_["q"], t);
    return q.uuu - (alpha * alpha * alpha * p.uuu + 3 * alpha * alpha * beta * p.uuv +
                    3 * alpha * beta * beta * p.uvv + beta * beta * beta * p.vvv +
                    3 * (alpha * pp * p.uu + (alpha * qq + beta * pp) * p.uv + beta * qq * p.vv));
  }
};

SidePoint sideOf(const BezierPatch& patch, double u, double t, bool face_on_left) {
  SidePoint side{patch.jet(u, t), patch.noise(), Vec::Zero(), face_on_left, true};
  side.tangent = side.jet.v;
  return side;
}

TEST_P(G2Join, Identity7DifferenceIsTheExcessOverTheCubeOfTheCrossSpeed) {
  std::mt19937_64 random(testSeed());
  const BezierPatch p = patchP();
  for (int trial = 0; trial < 20; ++trial) {
    const BezierPatch q = patchQ(random);
    for (const double t : {0.0, 0.13, 0.5, 0.8, 1.0}) {
      const SidePoint a = sideOf(p, 1, t, true), b = sideOf(q, 0, t, false);
      const PairMeasure pair = measurePair(a, b);
      const Vec normal = a.jet.u.cross(a.jet.v).normalized();
      const double across = b.jet.u.dot(normal.cross(a.jet.v.normalized()));
      const double wanted =
          std::abs(normal.dot(thirdOrderExcess(a.jet, b.jet, t))) / std::pow(std::abs(across), 3);
      ASSERT_TRUE(pair.curvature_change);
      // Rounding of the poles, magnified by the square and cube of a short cross step.
      const double speed = std::min(1.0, std::abs(across));
      EXPECT_LT(pair.curvature->difference_per_mm, 1e-12 / (speed * speed));
      EXPECT_NEAR(pair.curvature_change->difference_per_mm2, wanted,
                  1e-9 * wanted + 1e-11 / std::pow(speed, 3));
      EXPECT_GT(wanted, 0);
    }
  }
}

std::vector<json> oracleCases() {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/g2_joins.json");
  const json data = json::parse(file);
  return {data["cases"].begin(), data["cases"].end()};
}

std::string caseName(const testing::TestParamInfo<json>& info) {
  return info.param["id"];
}

INSTANTIATE_TEST_SUITE_P(All, G2Join, testing::ValuesIn(oracleCases()), caseName);

Poles randomPoles(int count, std::mt19937_64& random) {
  Poles poles(count, 3);
  for (int i = 0; i < count; ++i) poles.row(i) = test::randomVector(random).transpose();
  return poles;
}

/// A gently curved patch of that degree over about [0, 10] x [0, 10].
BezierPatch gentlePatch(int degree, std::mt19937_64& random) {
  Poles poles = 0.4 * randomPoles((degree + 1) * (degree + 1), random);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      poles.row(i * (degree + 1) + j) += 10.0 / degree * Vec(i, j, 0).transpose();
  return {degree, degree, poles};
}

SeamFigures surveyOf(const BezierPatch& p, const BezierPatch& q) {
  const std::vector<double> breaks = {0, 1};
  return surveySeam(
      [&](double t) { return measurePair(sideOf(p, 1, t, true), sideOf(q, 0, t, false)); }, breaks,
      {});
}

TEST(G3Join, ThePiecesOfOnePatchAreG3) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 30; ++i) {
    const auto [left, right] = gentlePatch(3 + i % 3, random).splitU(0.3 + 0.01 * i);
    const SeamFigures figures = surveyOf(left, right);
    ASSERT_TRUE(figures.curvature_change_rel);
    EXPECT_LT(figures.curvature_change_rel->lower, 1e-8);
    EXPECT_EQ(judge(figures, {}, Level::G3).level, Level::G3);
  }
}

TEST(G3Join, ADefectOfThirdOrderIsFoundWithItsSize) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 30; ++i) {
    const auto [left, right] = gentlePatch(3, random).splitU(0.5);
    // Row 3 moved across the patch: X_uuu changes by 6 e z, everything of lower order stays.
    const double e = test::logUniform(random, -2, 0);
    Poles poles = right.poles();
    poles.bottomRows(4).col(2).array() += e;
    const BezierPatch moved(3, 3, poles);
    double wanted = 0;
    for (int k = 0; k <= 2000; ++k) {
      const SurfaceJet x = right.jet(0, k / 2000.0);
      const Vec normal = x.u.cross(x.v).normalized();
      const double across = x.u.dot(normal.cross(x.v.normalized()));
      wanted = std::max(wanted, std::abs(6 * e * normal.z()) / std::pow(std::abs(across), 3));
    }
    const SeamFigures figures = surveyOf(left, moved);
    EXPECT_LE(figures.curvature_change_per_mm2->lower, wanted * (1 + 1e-6));
    EXPECT_GE(figures.curvature_change_per_mm2->lower, wanted * 0.99);
    EXPECT_LT(figures.curvature_rel->lower, 1e-9);
    EXPECT_EQ(judge(figures, {}, Level::G3).level,
              figures.curvature_change_rel->lower > 0.02 ? Level::G2 : Level::G3);
  }
}

}  // namespace
}  // namespace seamwright
