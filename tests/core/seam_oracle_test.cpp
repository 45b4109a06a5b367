// SPDX-License-Identifier: LGPL-2.1-or-later
// Seams with maxima known to 32 digits (tests/data/seam_measures.json, made with multi-precision
// arithmetic).
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <seamwright/core/seam/survey.hpp>

#include "seam_sides.hpp"

namespace seamwright {
namespace {

using nlohmann::json;

using test::hasPositiveWeights;
using test::patch;
using test::path;

class SeamOracle : public testing::TestWithParam<json> {
 protected:
  // P ends at the seam (s = 1, or the part below its pcurve), Q begins there.
  test::PatchSide p_{patch(GetParam()["input"]["P"]), path(GetParam()["input"], "pcurve_P", 1),
                     true};
  test::PatchSide q_{patch(GetParam()["input"]["Q"]), path(GetParam()["input"], "pcurve_Q", 0),
                     false};

  PairMeasure at(double t) const { return measurePair(p_.at(t), q_.at(t)); }
  double expected(const char* key) const {
    return test::number(GetParam()["expected"][key]["value"]);
  }
  bool hasPlace(const char* key) const { return !GetParam()["expected"][key]["t"].is_null(); }
  double place(const char* key) const { return test::number(GetParam()["expected"][key]["t"]); }
  double unfoldedAngle(const PairMeasure& pair) const {
    return pair.fold ? std::numbers::pi - *pair.angle_rad : *pair.angle_rad;
  }
};

// Absolute terms are the rounding of the nets, whose poles are about 10 in size.
constexpr double rounding = 3e-13;

TEST_P(SeamOracle, PairMeasureAtThePlaceOfTheMaximum) {
  if (hasPlace("max_gap")) {
    EXPECT_NEAR(*at(place("max_gap")).gap_mm, expected("max_gap"),
                1e-9 * expected("max_gap") + 1e-14);
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
    expectBelow(figures.curvature_per_mm->lower, expected("max_spectral_II_difference"),
                100 * rounding);
  EXPECT_FALSE(figures.angle_rad->upper.has_value());
  EXPECT_FALSE(figures.certified);
}

TEST_P(SeamOracle, EnclosureHoldsTheMaximumAndIsAsNarrowAsPromised) {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = tolerance.angle_rad = 1e-9;
  tolerance.curvature_rel = 1e-7;
  tolerance.crease_rad = std::numbers::pi / 2;
  const SeamFigures figures =
      encloseSeam(p_.seamSide(), q_.seamSide(), tolerance, {.max_pieces = 20000});
  ASSERT_TRUE(figures.certified) << figures.uncertified;
  // noise: by which the poles as rounded to double are off. narrow: by which terms left out widen.
  constexpr double left_out = ChebyshevModel::negligible;
  const auto expectHeld = [](const Figure& figure, double truth, double noise, double allowed,
                             double narrow) {
    EXPECT_LE(figure.lower, truth * (1 + 1e-12) + noise);
    EXPECT_GE(*figure.upper, truth * (1 - 1e-12) - noise);
    EXPECT_LE(*figure.upper - figure.lower, std::max(0.01 * figure.lower, allowed) + narrow);
  };
  expectHeld(*figures.gap_mm, expected("max_gap"), 1e-14, tolerance.gap_mm / 100, 4 * left_out);
  EXPECT_EQ(figures.fold_at.has_value(), expected("max_angle_rad") > std::numbers::pi / 2);
  if (figures.fold_at) return;
  expectHeld(*figures.angle_rad, expected("max_angle_rad"), rounding, tolerance.angle_rad / 100,
             2 * left_out);
  if (expected("max_gap") > 1e-12) return;
  const double truth = expected("max_spectral_II_difference");
  expectHeld(*figures.curvature_per_mm, truth, 100 * rounding + 1e-9 * truth, truth / 100,
             16 * left_out);
}

/// \param positive those whose weights are all positive, or the others.
std::vector<json> oracleCases(bool positive) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/seam_measures.json");
  const json data = json::parse(file);
  std::vector<json> cases;
  for (const json& entry : data["cases"])
    if ((hasPositiveWeights(entry["input"]["P"]) && hasPositiveWeights(entry["input"]["Q"])) ==
        positive)
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
