// SPDX-License-Identifier: LGPL-2.1-or-later
// Joins that are built against poles known to 60 digits, written-out formulas, and what is measured
// of them.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <optional>
#include <seamwright/core/join/curve/beta.hpp>

#include "curve_joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::CurveKind;
using test::fallingFactorial;
using test::Vec;
using testing::HasSubstr;

Eigen::VectorXd numbersOf(const json& values) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; i < result.size(); ++i) result(i) = test::number(values[i]);
  return result;
}

CurveJoinRule ruleOf(Eigen::VectorXd beta) {
  CurveJoinRule rule;
  rule.beta = std::move(beta);
  return rule;
}

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CurveConstruct, PolesOfSixtyDigits) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/curve_join_poles.json");
  const json data = json::parse(file);
  int compared = 0;
  for (const json& entry : data["cases"]) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const json &in = entry["in"], &out = entry["out"];
    const bool rational = in["kind"] == "rational";
    const BezierCurve a = test::bezierCurve(in["left"], rational ? in["left_weights"] : json());
    CurveJoinRule rule = ruleOf(numbersOf(in["beta"]));
    rule.length = test::number(in["h1"]);
    rule.next_length = test::number(in["h2"]);
    if (rational) rule.scale = numbersOf(in["e"]);
    const json& rows = out[rational ? "Q_homogeneous" : "Q"];
    HomogeneousPoles wanted(static_cast<Eigen::Index>(rows.size()), 4);
    for (Eigen::Index k = 0; k < wanted.rows(); ++k) {
      Eigen::VectorXd row = numbersOf(rows[k]);
      const double weight = rational ? row(row.size() - 1) : 1;
      if (rational) row.conservativeResize(row.size() - 1);
      wanted.row(k) << row(0), row(1), row.size() > 2 ? row(2) : 0, weight;
    }
    const int degree = in["right_degree"];
    if (wanted.col(3).minCoeff() <= 0) {
      EXPECT_THAT(refusal([&] { nextPoles(a, degree, rule); }),
                  HasSubstr("weight 2 comes out as -5.24737"));
      continue;
    }
    const HomogeneousPoles poles = nextPoles(a, degree, rule);
    ASSERT_EQ(poles.rows(), wanted.rows());
    EXPECT_LE((poles - wanted).cwiseAbs().maxCoeff(), 1e-13 * wanted.cwiseAbs().maxCoeff());
    ++compared;
  }
  EXPECT_EQ(compared, 23);
}

TEST(CurveConstruct, Identity8WrittenOutForSecondOrder) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 500; ++run) {
    const int m = test::wholeNumber(1, 9, random), n = test::wholeNumber(2, 9, random);
    const BezierCurve a = test::randomCurve(m, CurveKind::Space, true, 1, random);
    const Eigen::VectorXd beta = test::randomBeta(2, random);
    const Poles p = a.poles();
    const Vec last = p.row(m), first = p.row(m) - p.row(m - 1);
    Vec second = Vec::Zero();
    if (m >= 2) second = p.row(m) - 2 * p.row(m - 1) + p.row(m - 2);
    const Vec q1 = last + static_cast<double>(m) / n * beta(0) * first;
    const Vec q2 =
        2 * q1 - last +
        (m * (m - 1) * beta(0) * beta(0) * second + m * beta(1) * first) / (n * (n - 1.0));
    const HomogeneousPoles q = nextPoles(a, n, ruleOf(beta));
    EXPECT_EQ(Vec(q.row(0).head<3>()), last) << "bit by bit";
    EXPECT_LE((Vec(q.row(1).head<3>()) - q1).norm(), 1e-13 * m) << run;
    EXPECT_LE((Vec(q.row(2).head<3>()) - q2).norm(), 1e-12 * m * m) << run;
    EXPECT_EQ(q.col(3), Eigen::Vector3d::Ones()) << "a polynomial curve goes on as one";
  }
}

/// Judges by a thousandth of what the move of one pole of b, across the tangent, does to the defect
/// of its order.
struct Verdict {
  const BezierCurve& b;
  double length, move;

  double effect(int k) const {
    const Eigen::VectorXd w = b.weights();
    return fallingFactorial(b.degree(), k) * w(k) / w(0) * move * std::pow(length, k - 1) /
           std::pow(b.derivatives(0, 1).row(1).norm(), k);
  }
  /// Whether the rounding of so uneven a parameter is below all that.
  bool decided(const BetaFit& fit) const {
    for (int k = 0; k < static_cast<int>(fit.upper.size()); ++k)
      if (fit.upper[k] - fit.lower[k] > 1e-3 * effect(k)) return false;
    return true;
  }
  int order(const BetaFit& fit) const {
    int k = 0;
    while (k < static_cast<int>(fit.defects.size()) && fit.defects[k] <= 1e-3 * effect(k)) ++k;
    return k - 1;
  }
};

TEST(CurveConstruct, JoinsReachTheirOrderAndAHairLessDoesNot) {
  std::mt19937_64 random(testSeed());
  int decided = 0, undecided = 0;
  for (int run = 0; run < 4000; ++run) {
    const int order = 1 + run % 6;
    const auto kind = static_cast<CurveKind>(run / 6 % 5);
    const double size = test::logUniform(random, -3, 6);
    const BezierCurve a = test::randomCurve(test::wholeNumber(1, 9, random), kind, true, size,
                                            random),
                      given = test::randomCurve(test::wholeNumber(order, 9, random),
                                                static_cast<CurveKind>(run / 30 % 5), false, size,
                                                random);
    CurveJoinRule rule = ruleOf(test::randomBeta(order, random));
    rule.length = test::logUniform(random, -0.3, 0.3);
    rule.next_length = rule.length * test::logUniform(random, -0.3, 0.1);
    for (int k = 1; k < order; ++k) rule.beta(k) *= std::pow(rule.length, 1 - k);
    if (kind == CurveKind::Rational) {
      rule.scale = Eigen::VectorXd::Unit(order + 1, 0) * test::logUniform(random, -0.3, 0.3);
      for (int k = 1; k <= order; ++k)
        rule.scale(k) =
            0.2 * rule.scale(0) * test::randomVector(random).x() * std::pow(rule.next_length, -k);
    }
    std::optional<BezierCurve> made;
    try {
      made = joinedCurve(a, given, rule, run % 2 == 0);
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("weight ")) << run;  // the scale was too steep
      continue;
    }
    const BezierCurve& b = *made;
    const BetaFit fit = fitBeta(a, b, order);
    const double reach = std::max(a.poles().cwiseAbs().maxCoeff(),
                                  b.poles().topRows(order + 1).cwiseAbs().maxCoeff());
    const Verdict verdict{b, fit.length_mm, 1e-6 * reach};
    if (!verdict.decided(fit)) {
      ++undecided;
      continue;
    }
    ASSERT_EQ(verdict.order(fit), order) << run;
    const Vec tangent = a.derivatives(1, 1).row(1);
    const int pole = test::wholeNumber(0, order, random);
    const Vec move = verdict.move * test::across(tangent);
    const BetaFit missed = fitBeta(a, test::withMove(b, pole, move), order, fit.length_mm);
    EXPECT_EQ(verdict.order(missed), pole - 1) << run << " pole " << pole;
    EXPECT_GT(missed.lower[pole], 0) << run << ": proved to be missed";
    // The decisive pole of a in turn, where it has one.
    if (pole <= a.degree()) {
      const BetaFit turned =
          fitBeta(test::withMove(a, a.degree() - pole, move), b, order, fit.length_mm);
      EXPECT_GT(turned.lower[pole], 0) << run << ": proved to be missed";
    }
    ++decided;
  }
  EXPECT_GE(decided, 3500);
  EXPECT_LE(undecided, 100);
  RecordProperty("decided", decided);
}

TEST(CurveConstruct, Identity6TheFitReturnsBeta) {
  std::mt19937_64 random(testSeed());
  double worst = 0;
  for (int run = 0; run < 2000; ++run) {
    const int order = 1 + run % 6;
    const auto kind = static_cast<CurveKind>(run / 6 % 5);
    const BezierCurve a = test::randomCurve(test::wholeNumber(1, 9, random), kind, true, 1, random),
                      given = test::randomCurve(test::wholeNumber(order, 9, random), kind, false, 1,
                                                random);
    CurveJoinRule rule = ruleOf(test::randomBeta(order, random));
    const BezierCurve b = test::gentlyJoined(a, given, rule, false);
    for (int k = 0; k < order; ++k) rule.beta(k) *= std::pow(rule.next_length, k + 1);
    const BetaFit fit = fitBeta(a, b, order);
    ASSERT_EQ(fit.beta.size(), order) << run;
    const CurveDerivatives x = a.derivatives(1, order);
    // Rounding of the poles, times what differences and the terms of each row make of it.
    const double reach = std::max(a.poles().cwiseAbs().maxCoeff(),
                                  b.poles().topRows(order + 1).cwiseAbs().maxCoeff()) /
                         x.row(1).norm();
    const Eigen::MatrixXd B = betaMatrix(rule.beta).cwiseAbs();
    double loss = 1;
    for (int k = 1; k <= order; ++k) {
      const double rows = (B * x.rowwise().norm())(k) / x.row(1).norm();
      const double differences =
          std::pow(2, k) * fallingFactorial(std::max(a.degree(), b.degree()), k) * reach;
      loss = std::max(loss * (1 + B.row(k).sum()), rows + differences);
      worst = std::max(worst, std::abs(fit.beta(k - 1) - rule.beta(k - 1)) / loss);
    }
  }
  EXPECT_LE(worst, 1e-13);
}

TEST(CurveConstruct, Identity9DerivativesByTheCommonParameter) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 1500; ++run) {
    const int order = run % 7;
    const auto kind = static_cast<CurveKind>(run % 5);
    const BezierCurve a = test::randomCurve(test::wholeNumber(1, 9, random), kind, true, 1, random),
                      given = test::randomCurve(test::wholeNumber(1, 9, random), kind, false, 1,
                                                random);
    CurveJoinRule rule = ruleOf(Eigen::VectorXd::Zero(order));
    if (order > 0) rule.beta(0) = 1;
    if (run % 2 == 1) rule.beta = test::randomBeta(order, random);
    rule.length = test::logUniform(random, -0.5, 0.5);
    rule.next_length = rule.length * test::logUniform(random, -0.5, 0.1);
    std::optional<BezierCurve> made;
    try {
      made = joinedCurve(a, given, rule);
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("weight ")) << run;
      continue;
    }
    CurveDerivatives x = a.derivatives(1, order), y = made->derivatives(0, order);
    for (int k = 0; k <= order; ++k) {
      x.row(k) /= std::pow(rule.length, k);
      y.row(k) /= std::pow(rule.next_length, k);
    }
    const CurveDerivatives wanted = betaMatrix(rule.beta) * x;
    const double reach = std::max(a.poles().cwiseAbs().maxCoeff(),
                                  made->poles().topRows(order + 1).cwiseAbs().maxCoeff());
    for (int k = 0; k <= order; ++k) {
      const double terms = (betaMatrix(rule.beta).cwiseAbs() * x.rowwise().norm())(k);
      const double differences = fallingFactorial(made->degree(), k) * std::pow(2, k) * reach /
                                 std::pow(rule.next_length, k);
      const double rational = kind == CurveKind::Rational ? 1e3 : 1;
      EXPECT_LE((y.row(k) - wanted.row(k)).norm(), 1e-13 * rational * (terms + differences))
          << run << " " << k;
    }
    if (order == 0) continue;
    const BetaFit fit = fitBeta(a, *made, 1);
    EXPECT_NEAR(fit.beta(0), rule.beta(0) * rule.next_length / rule.length, 1e-11 * reach) << run;
  }
}

TEST(CurveConstruct, TheOwnEndStays) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 500; ++run) {
    const int order = run % 6;
    const auto kind = static_cast<CurveKind>(run % 5);
    const BezierCurve a = test::randomCurve(3, kind, true, 1, random),
                      given = test::randomCurve(test::wholeNumber(1, 9, random), kind, false, 1,
                                                random);
    CurveJoinRule rule = ruleOf(test::randomBeta(order, random));
    const BezierCurve b = test::gentlyJoined(a, given, rule, true);
    EXPECT_EQ(b.degree(), std::max(given.degree(), 2 * order + 1));
    BezierCurve raised = given;
    while (raised.degree() < b.degree()) raised = raised.elevated();
    EXPECT_EQ(b.homogeneousPoles().bottomRows(b.degree() - order),
              raised.homogeneousPoles().bottomRows(b.degree() - order));
    const CurveDerivatives x = given.derivatives(1, order), y = b.derivatives(1, order);
    for (int k = 0; k <= order; ++k)
      EXPECT_LE((x.row(k) - y.row(k)).norm(),
                1e-12 * fallingFactorial(b.degree(), k) * std::pow(4, k))
          << run;
    EXPECT_EQ(test::gentlyJoined(a, given, rule, false).degree(), std::max(given.degree(), order));
  }
}

/// One curve cut in two: the second half is what the rule C^n of both lengths gives from the first.
TEST(CurveConstruct, TheSecondHalfOfACurve) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 300; ++run) {
    const int degree = 1 + run % 7;
    const BezierCurve whole =
        test::randomCurve(degree, static_cast<CurveKind>(run % 5), true, 1, random);
    const double t = test::uniformNumber(0.3, 0.7, random);
    const auto [left, right] = whole.split(t);
    CurveJoinRule rule = ruleOf(Eigen::VectorXd::Unit(degree, 0));
    rule.length = t;
    rule.next_length = 1 - t;
    const HomogeneousPoles poles = nextPoles(left, degree, rule);
    EXPECT_LE((poles - right.homogeneousPoles()).norm(), 1e-13 * std::pow(10, degree)) << run;
  }
}

TEST(CurveConstruct, BridgesJoinBothEnds) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 1000; ++run) {
    const int order = run % 6, order_end = run % 7 == 0 ? (run / 7) % 4 : order;
    const auto kind = static_cast<CurveKind>(run % 4);
    const double size = test::logUniform(random, -3, 6);
    const BezierCurve a =
        test::randomCurve(test::wholeNumber(1, 9, random), kind, true, size, random);
    const BezierCurve b =
        test::randomCurve(test::wholeNumber(1, 9, random), kind, false, size, random);
    const Eigen::VectorXd beta = test::randomBeta(order, random),
                          beta_end = test::randomBeta(order_end, random);
    const BezierCurve bridge = bridgeCurve(a, b, beta, beta_end);
    ASSERT_EQ(bridge.degree(), order + order_end + 1);
    EXPECT_FALSE(bridge.isRational());
    EXPECT_EQ(bridge.point(0), a.point(1));
    const CurveDerivatives start = bridge.derivatives(0, order),
                           end = bridge.derivatives(1, order_end),
                           next = b.derivatives(0, order_end);
    const CurveDerivatives from = betaMatrix(beta) * a.derivatives(1, order),
                           to = betaMatrix(beta_end) * end;
    const double reach = bridge.poles().cwiseAbs().maxCoeff();
    for (int k = 0; k <= order; ++k)
      EXPECT_LE((start.row(k) - from.row(k)).norm(),
                1e-13 * reach * std::pow(2, k) * fallingFactorial(bridge.degree(), k))
          << run;
    const Eigen::MatrixXd B = betaMatrix(beta_end).cwiseAbs();
    for (int k = 0; k <= order_end; ++k) {
      double terms = 0;
      for (int j = 0; j <= k; ++j)
        terms += B(k, j) * std::pow(2, j) * fallingFactorial(bridge.degree(), j) * reach;
      EXPECT_LE((next.row(k) - to.row(k)).norm(), 1e-13 * (terms + fallingFactorial(9, k) * reach))
          << run;
    }
  }
}

TEST(CurveConstruct, BridgeOfOrderOneIsTheCubicOfHermite) {
  Poles a(2, 3), b(2, 3), wanted(4, 3);
  a << -2, 0, 0, 0, 0, 0;
  b << 3, 3, 0, 3, 6, 0;
  const Eigen::VectorXd beta = Eigen::VectorXd::Constant(1, 1.5),
                        beta_end = Eigen::VectorXd::Constant(1, 2);
  wanted << 0, 0, 0, 1, 0, 0, 3, 2.5, 0, 3, 3, 0;
  const BezierCurve bridge = bridgeCurve(BezierCurve(a), BezierCurve(b), beta, beta_end);
  EXPECT_LE((bridge.poles() - wanted).norm(), 1e-15);
}

TEST(CurveConstruct, RefusesBadInput) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 3, 1;
  const BezierCurve a(poles);
  const auto with = [&](auto change) {
    CurveJoinRule rule = ruleOf(Eigen::Vector2d(1, 0.5));
    change(rule);
    return refusal([&] { nextPoles(a, 3, rule); });
  };
  const double nan = std::nan("");
  EXPECT_EQ(with([](CurveJoinRule&) {}), "accepted");
  EXPECT_THAT(with([&](auto& r) { r.beta(1) = nan; }), HasSubstr("beta_2 is nan"));
  EXPECT_THAT(with([&](auto& r) { r.beta(0) = 0; }), HasSubstr("beta_1 is 0"));
  EXPECT_THAT(with([&](auto& r) { r.length = 0; }), HasSubstr("length is 0: it must be positive"));
  EXPECT_THAT(with([&](auto& r) { r.next_length = -1; }), HasSubstr("next_length is -1"));
  EXPECT_THAT(with([&](auto& r) { r.length = nan; }), HasSubstr("length is nan"));
  EXPECT_THAT(with([&](auto& r) { r.scale = Eigen::Vector2d(1, 0); }),
              HasSubstr("scale has 2 numbers: 3 are"));
  EXPECT_THAT(with([&](auto& r) { r.scale = Eigen::Vector3d(-1, 0, 0); }),
              HasSubstr("scale e_0 is -1"));
  EXPECT_THAT(with([&](auto& r) { r.scale = Eigen::Vector3d(1, 0, nan); }),
              HasSubstr("scale e_2 is nan"));
  EXPECT_THAT(with([&](auto& r) { r.scale = Eigen::Vector3d(1, -6, 0); }),
              HasSubstr("weight 1 comes out as -1"));
  EXPECT_THAT(with([&](auto& r) { r.next_length = 1e200; }), HasSubstr("pole 2 comes out beyond"));
  const CurveJoinRule rule = ruleOf(Eigen::Vector2d(1, 0));
  EXPECT_THAT(refusal([&] { nextPoles(a, 1, rule); }),
              HasSubstr("degree 1: it must be within 2 to 100"));
  EXPECT_THAT(refusal([&] { nextPoles(a, 101, rule); }), HasSubstr("degree 101"));
  poles.row(2) = poles.row(3);
  const BezierCurve still(poles);
  EXPECT_THAT(refusal([&] { nextPoles(still, 3, rule); }),
              HasSubstr("no tangent at its end: speed 0"));
  EXPECT_NO_THROW(nextPoles(still, 3, CurveJoinRule{})) << "a point has one";
  EXPECT_THAT(refusal([&] { joinedCurve(a, a, ruleOf(Eigen::VectorXd::Constant(1, -1))); }),
              HasSubstr("beta_1 is -1"));
  const BezierCurve rational(a.poles(), Eigen::Vector4d(1, 1, 2, 1));
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  EXPECT_THAT(refusal([&] { bridgeCurve(a, rational, one, one); }),
              HasSubstr("b is rational, weight 0 is 1, weight 2 is 2"));
  EXPECT_THAT(refusal([&] { bridgeCurve(rational, a, one, one); }), HasSubstr("a is rational"));
  EXPECT_THAT(refusal([&] { bridgeCurve(a, a, one, -one); }), HasSubstr("beta_1 is -1"));
}

}  // namespace
}  // namespace seamwright
