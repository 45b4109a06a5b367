// SPDX-License-Identifier: LGPL-2.1-or-later
// Seams with maxima known to 32 digits (tests/data/seam_measures.json, made with multi-precision arithmetic).
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/seam/survey.hpp>

namespace seamwright {
namespace {

using nlohmann::json;

double number(const json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

BezierPatch patch(const json& net) {
  const int m = static_cast<int>(net.size()) - 1, n = static_cast<int>(net[0].size()) - 1;
  Poles poles((m + 1) * (n + 1), 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(poles.rows());
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const json& pole = net[i][j];
      const Eigen::Index row = i * (n + 1) + j;
      if (pole.size() == 4) weights(row) = number(pole[3]);
      for (int c = 0; c < 3; ++c) poles(row, c) = number(pole[c]) / weights(row);
    }
  return {m, n, poles, weights};
}

/// Patch and path of one side; without a pcurve the path is the edge u = const.
struct Side {
  BezierPatch surface;
  BezierCurve path;
  bool face_on_left = true;

  SidePoint at(double t) const {
    const CurveJet uv = path.jet(t);
    SidePoint point;
    point.jet = surface.jet(uv.p.x(), uv.p.y());
    point.noise = surface.noise();
    point.tangent = uv.d1.x() * point.jet.u + uv.d1.y() * point.jet.v;
    point.face_on_left = face_on_left;
    return point;
  }
};

BezierCurve path(const json& input, const char* key, double u) {
  Poles poles(2, 3);
  poles << u, 0, 0, u, 1, 0;
  if (input.contains(key)) {
    poles.setZero(static_cast<Eigen::Index>(input[key].size()), 3);
    for (Eigen::Index i = 0; i < poles.rows(); ++i)
      for (int c = 0; c < 2; ++c) poles(i, c) = number(input[key][i][c]);
  }
  return BezierCurve(poles);
}

class SeamOracle : public testing::TestWithParam<json> {
 protected:
  // P ends at the seam (s = 1, or the part below its pcurve), Q begins there.
  Side p_{patch(GetParam()["input"]["P"]), path(GetParam()["input"], "pcurve_P", 1), true};
  Side q_{patch(GetParam()["input"]["Q"]), path(GetParam()["input"], "pcurve_Q", 0), false};

  PairMeasure at(double t) const { return measurePair(p_.at(t), q_.at(t)); }
  double expected(const char* key) const { return number(GetParam()["expected"][key]["value"]); }
  bool hasPlace(const char* key) const { return !GetParam()["expected"][key]["t"].is_null(); }
  double place(const char* key) const { return number(GetParam()["expected"][key]["t"]); }
  double unfoldedAngle(const PairMeasure& pair) const {
    return pair.fold ? std::numbers::pi - *pair.angle_rad : *pair.angle_rad;
  }
};

// Absolute terms are the rounding of the nets, whose poles are about 10 in size.
constexpr double rounding = 3e-13;

TEST_P(SeamOracle, PairMeasureAtThePlaceOfTheMaximum) {
  if (hasPlace("max_gap")) {
    EXPECT_NEAR(*at(place("max_gap")).gap_mm, expected("max_gap"), 1e-9 * expected("max_gap") + 1e-14);
  }
  if (hasPlace("max_angle_rad")) {
    const double wanted = expected("max_angle_rad");
    EXPECT_NEAR(unfoldedAngle(at(place("max_angle_rad"))), wanted, 1e-9 * wanted + rounding);
  }
  if (hasPlace("max_spectral_II_difference") && expected("max_gap") < 1e-12 && !at(0.5).fold) {
    const double wanted = expected("max_spectral_II_difference");
    EXPECT_NEAR(at(place("max_spectral_II_difference")).curvature->difference_per_mm, wanted,
                1e-8 * wanted + 100 * rounding);
  }
}

TEST_P(SeamOracle, SurveyComesWithinOnePercentFromBelow) {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = tolerance.angle_rad = 1e-12;
  tolerance.curvature_rel = 1e-9;
  tolerance.crease_rad = std::numbers::pi / 2;
  const std::vector<double> breaks = {0, 1};
  const SeamFigures figures = surveySeam([&](double t) { return at(t); }, breaks, tolerance);
  const auto expectBelow = [](double seen, double truth, double noise) {
    EXPECT_LE(seen, truth * (1 + 1e-9) + noise);
    EXPECT_GE(seen, truth * 0.99 - noise);
  };
  expectBelow(figures.gap_mm->lower, expected("max_gap"), 1e-14);
  if (figures.fold_at) {
    EXPECT_GT(expected("max_angle_rad"), std::numbers::pi / 2);
    return;
  }
  expectBelow(figures.angle_rad->lower, expected("max_angle_rad"), rounding);
  if (expected("max_gap") < 1e-12)
    expectBelow(figures.curvature_per_mm->lower, expected("max_spectral_II_difference"), 100 * rounding);
  EXPECT_FALSE(figures.angle_rad->upper.has_value());
  EXPECT_FALSE(figures.certified);
}

bool hasPositiveWeights(const json& net) {
  for (const json& row : net)
    for (const json& pole : row)
      if (pole.size() == 4 && number(pole[3]) <= 0) return false;
  return true;
}

/// \param positive those whose weights are all positive, or the others.
std::vector<json> oracleCases(bool positive) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/seam_measures.json");
  const json data = json::parse(file);
  std::vector<json> cases;
  for (const json& entry : data["cases"])
    if ((hasPositiveWeights(entry["input"]["P"]) && hasPositiveWeights(entry["input"]["Q"])) == positive)
      cases.push_back(entry);
  return cases;
}

TEST(SeamOracleData, PatchesWithAWeightThatIsNotPositiveAreRefused) {
  ASSERT_EQ(oracleCases(false).size(), 1u);
  for (const json& entry : oracleCases(false))
    EXPECT_THROW(patch(entry["input"]["Q"]), std::invalid_argument);
}

std::string caseName(const testing::TestParamInfo<json>& info) {
  std::string name = info.param["id"];
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, SeamOracle, testing::ValuesIn(oracleCases(true)), caseName);

}  // namespace
}  // namespace seamwright
