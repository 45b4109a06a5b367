// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <seamwright/core/spline/bezier_spline.hpp>

#include "splines.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::expectRefused;
using test::Vec;

constexpr double inf = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();

BezierSpline randomSpline(int degree, int segments, bool rational, std::mt19937_64& random) {
  return {degree, test::randomBreaks(segments, 0.4, random),
          test::randomPoles(segments * degree + 1, rational, random)};
}

std::vector<BezierCurve> segmentsOf(const BezierSpline& spline) {
  std::vector<BezierCurve> result;
  for (int i = 0; i < spline.segments(); ++i) result.push_back(segment(spline, i));
  return result;
}

/// A quarter of the unit circle from angle k pi / 2.
BezierCurve quarter(int k) {
  const double x[] = {1, 0, -1, 0}, y[] = {0, 1, 0, -1};
  Poles poles(3, 3);
  const int l = (k + 1) % 4;
  poles << x[k], y[k], 0, x[k] + x[l], y[k] + y[l], 0, x[l], y[l], 0;
  return {poles, Vec(1, std::sqrt(0.5), 1)};
}

TEST(BezierSpline, SegmentsThereAndBackBitByBit) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    BezierSpline spline = randomSpline(1 + i % 6, 1 + i % 5, i % 2 == 0, random);
    if (i % 3 == 0) {
      spline.closed = true;
      spline.poles.bottomRows<1>() = spline.poles.topRows<1>();
    }
    EXPECT_EQ(bezierSpline(segmentsOf(spline), spline.knots, spline.closed), spline);
  }
}

TEST(BezierSpline, DegreesAreRaisedAndWeightsMatched) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const bool closed = i % 2 == 0;
    std::vector<BezierCurve> curves;
    HomogeneousPoles first = test::randomPoles(2 + i % 4, true, random);
    Vec end = first.row(0).head<3>() / first(0, 3);
    const Vec start = end;
    for (int s = 0; s < 4; ++s) {
      HomogeneousPoles poles = test::randomPoles(2 + (i + s * s) % 5, true, random);
      poles.row(0).head<3>() = poles(0, 3) * end.transpose();
      if (closed && s == 3)
        poles.bottomRows<1>().leftCols<3>() = poles(poles.rows() - 1, 3) * start.transpose();
      curves.push_back(BezierCurve::fromHomogeneous(poles));
      end = curves.back().poles().bottomRows<1>().transpose();
    }
    const BezierSpline spline = bezierSpline(curves, {0, 1, 3, 4, 6}, closed, 1e-14);
    EXPECT_EQ(spline.closed, closed);
    for (int s = 0; s < 4; ++s)
      for (const double t : {0.0, 0.3, 0.7, 1.0})
        EXPECT_LT((segment(spline, s).point(t) - curves[s].point(t)).norm(), 1e-12) << i;
    if (closed) {
      const CurveJoint seam = measureJoints(spline, 1).back();
      EXPECT_LT(*seam.gap_mm, 1e-15 * 16);
    }
  }
}

TEST(BezierSpline, GapsAreRefusedWithTheirJointAndSize) {
  std::mt19937_64 random(testSeed());
  BezierSpline spline = randomSpline(3, 4, false, random);
  std::vector<BezierCurve> curves = segmentsOf(spline);
  HomogeneousPoles moved = curves[2].homogeneousPoles();
  moved(0, 2) += 0.25;
  curves[2] = BezierCurve::fromHomogeneous(moved);
  expectRefused([&] { bezierSpline(curves, spline.knots); }, "joint 2: the ends are 0.25");
  expectRefused([&] { bezierSpline(curves, spline.knots, false, 0.2); }, "allowed 0.2");
  const BezierSpline closedUp = bezierSpline(curves, spline.knots, false, 0.26);
  EXPECT_EQ(closedUp.poles.row(6), moved.row(0));
  expectRefused([&] { bezierSpline(segmentsOf(spline), spline.knots, true); }, "joint 4: ");
  expectRefused([&] { bezierSpline(std::vector<BezierCurve>{}, {0}); }, "no segments");
  expectRefused([&] { bezierSpline(segmentsOf(spline), {0, 1, 2}); }, "segments 4, knots 3");
  expectRefused([&] { bezierSpline(segmentsOf(spline), {0, 1, 2, 2, 3}); }, "knot 3 is 2");
  expectRefused([&] { bezierSpline(segmentsOf(spline), spline.knots, false, nan); },
                "gap_mm is nan");
}

TEST(BezierSpline, DerivativesByTheSplinesOwnParameter) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const BezierSpline spline = randomSpline(1 + i % 5, 1 + i % 4, i % 2 == 0, random);
    const int s = i % spline.segments();
    const double h = spline.knots[s + 1] - spline.knots[s];
    const double local = i % 5 == 0 ? 0 : std::uniform_real_distribution<double>(0, 0.999)(random);
    const CurveDerivatives ours = derivatives(spline, spline.knots[s] + local * h, 3);
    const CurveDerivatives theirs = segment(spline, s).derivatives(local, 3);
    for (int k = 0; k <= 3; ++k)
      EXPECT_LT((ours.row(k) * std::pow(h, k) - theirs.row(k)).norm(),
                1e-10 * (1 + theirs.row(k).norm()))
          << i;
    const int last = spline.segments() - 1;
    const double length = spline.knots[last + 1] - spline.knots[last];
    for (const double beyond : {0.0, 0.25})
      EXPECT_LT((derivatives(spline, spline.knots.back() + beyond * length, 0) -
                 segment(spline, last).derivatives(1 + beyond, 0))
                    .norm(),
                1e-9);
    EXPECT_LT(
        (derivatives(spline, spline.knots.front() - 0.25 * (spline.knots[1] - spline.knots[0]), 0) -
         segment(spline, 0).derivatives(-0.25, 0))
            .norm(),
        1e-9);
  }
}

TEST(BezierSpline, JointsOfACircle) {
  std::vector<BezierCurve> quarters;
  for (int k = 0; k < 4; ++k) quarters.push_back(quarter(k));
  for (const bool closed : {false, true}) {
    const std::vector<CurveJoint> joints =
        measureJoints(bezierSpline(quarters, {0, 1, 2, 3, 4}, closed), 4);
    ASSERT_EQ(joints.size(), closed ? 4 : 3);
    for (const CurveJoint& joint : joints) {
      EXPECT_EQ(orderReached(joint, {}), 4);
      for (int k = 0; k <= 4; ++k) EXPECT_NEAR(joint.differences[k], 0, 1e-12);
      EXPECT_NEAR(joint.sizes[2], 1, 1e-14);
    }
  }
  HomogeneousPoles moved = quarters[2].homogeneousPoles();
  moved(1, 0) *= 1 + 1e-6;
  quarters[2] = BezierCurve::fromHomogeneous(moved);
  const std::vector<CurveJoint> joints =
      measureJoints(bezierSpline(quarters, {0, 1, 2, 3, 4}, true), 2);
  EXPECT_LT(joints[0].differences[2], 1e-14);
  EXPECT_GT(joints[1].differences[2], 1e-7);
  EXPECT_GT(joints[2].differences[2], 1e-7);
}

TEST(BezierSpline, ConversionOracleOfSixtyDigits) {
  int compared = 0;
  for (const nlohmann::json& entry : test::splineCases("spline_conversions.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const std::string kind = in["kind"];
    if (kind == "circle") continue;
    const int continuity = kind == "cubicC1" ? 1 : kind == "quinticC2" ? 2 : 0;
    std::vector<BezierCurve> curves;
    if (kind == "arcs")
      for (const nlohmann::json& piece : in["pieces"])
        curves.push_back(test::bezierCurve(piece["points"], piece["weights"]));
    else
      for (const nlohmann::json& piece : in["segments"])
        curves.push_back(test::bezierCurve(piece, nullptr));
    const BezierSpline spline = bezierSpline(curves, test::numbers(in["breaks"]));
    const BSplineCurve curve = bsplineCurve(spline, continuity);
    const Poles wanted = test::points(out["poles"]);
    ASSERT_EQ(curve.poles.rows(), wanted.rows());
    EXPECT_EQ(curve.knots, test::flatKnots(curve.degree, test::numbers(out["knots"]),
                                           curve.degree - continuity));
    EXPECT_EQ(out["mults"][1], kind == "circle" ? 2 : curve.degree - continuity);
    const double size = wanted.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < wanted.rows(); ++i) {
      EXPECT_NEAR(curve.poles(i, 3), out["weights"].is_null() ? 1 : test::number(out["weights"][i]),
                  1e-15);
      EXPECT_LT((curve.poles.row(i).head<3>() / curve.poles(i, 3) - wanted.row(i)).norm(),
                1e-13 * size);
    }
    for (const nlohmann::json& sample : out["samples"])
      for (const CurveDerivatives& x : {derivatives(curve, test::number(sample["t"]), 0),
                                        derivatives(spline, test::number(sample["t"]), 0)})
        EXPECT_LT((x.row(0).transpose() - test::vector(sample["point"])).norm(), 1e-13 * size);
    if (continuity > 0) {
      expectRefused([&] { bsplineCurve(spline, continuity + 1); },
                    "derivative of order " + std::to_string(continuity + 1));
      BezierSpline moved = spline;
      moved.poles(spline.degree + 1, 1) += 1e-6 * size;
      expectRefused([&] { bsplineCurve(moved, continuity); },
                    "knot 1: the derivative of order 1 jumps by");
    }
    ++compared;
  }
  EXPECT_EQ(compared, 18);
}

/// The jump in the message is that of the closed form: X = 0 before, (t - 1)^2 after the knot 1.
TEST(BezierSpline, RefusalTellsTheJump) {
  BezierSpline spline{2, {0, 1, 3}, HomogeneousPoles::Zero(5, 4)};
  spline.poles.col(3).setOnes();
  spline.poles(4, 0) = 4;
  EXPECT_EQ(bsplineCurve(spline, 1).count(), 4);
  expectRefused([&] { bsplineCurve(spline, 2); }, "order is 2: 0 to degree - 1, 1, is possible");
  expectRefused([&] { bsplineCurve(spline, -1); }, "order is -1");
  spline.poles(3, 0) = 1;
  expectRefused([&] { bsplineCurve(spline, 1); },
                "knot 1: the derivative of order 1 jumps by 1, rounding");
}

/// A B-spline curve of any multiplicities is its segments, and these are it again.
TEST(BezierSpline, BSplineThereAndBack) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 2000; ++i) {
    const int degree = 1 + i % 7, continuity = i % degree;
    const BSplineCurve curve =
        test::randomCurve(degree, degree - continuity, 1 + i % 6, i % 2 == 0, random);
    const BezierSpline spline = bezierSpline(curve);
    const double t =
        std::uniform_real_distribution<double>(curve.knots.front(), curve.knots.back())(random);
    EXPECT_LT((derivatives(spline, t, 0) - derivatives(curve, t, 0)).norm(),
              1e-12 * (1 + curve.count()))
        << i;
    EXPECT_EQ((spline.poles.col(3).array() == 1).all(), i % 2 == 1);
    const BSplineCurve back = bsplineCurve(spline, continuity);
    EXPECT_EQ(back.knots, curve.knots);
    if (continuity == 0) {
      EXPECT_EQ(back, curve);
      EXPECT_EQ(bezierSpline(back), spline);
    }
    // Blossoms reach over as many spans as continuity, each extrapolation at worst (1 + the ratio
    // of lengths).
    double ratio = 1;
    for (int s = 1; s < spline.segments(); ++s) {
      const double h = spline.knots[s] - spline.knots[s - 1],
                   k = spline.knots[s + 1] - spline.knots[s];
      ratio = std::max({ratio, h / k, k / h});
    }
    EXPECT_LT((back.poles - curve.poles).cwiseAbs().maxCoeff(),
              1e-14 * curve.poles.cwiseAbs().maxCoeff() * std::pow(1 + 2 * ratio, continuity))
        << i;
  }
}

/// Spans from 1e-9 to 1: segments are convex combinations of the poles, so nothing is lost.
TEST(BezierSpline, TinySpansLoseNothing) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const int degree = 1 + i % 5;
    std::vector<double> breaks = {0};
    for (int s = 0; s < 5; ++s) breaks.push_back(breaks.back() + test::logUniform(random, -9, 0));
    BSplineCurve curve{degree, test::flatKnots(degree, breaks, 1 + i % degree), {}};
    curve.poles = test::randomPoles(curve.count(), i % 2 == 0, random);
    const BezierSpline spline = bezierSpline(curve);
    const double size = curve.poles.cwiseAbs().maxCoeff();
    EXPECT_LE(spline.poles.cwiseAbs().maxCoeff(), size);
    for (int s = 0; s < 5; ++s) {
      const double t = breaks[s] + 0.37 * (breaks[s + 1] - breaks[s]);
      EXPECT_LT((derivatives(spline, t, 0) - derivatives(curve, t, 0)).norm(), 1e-13 * size) << i;
    }
    const BSplineCurve back = bsplineCurve(spline, 0);
    EXPECT_EQ(bezierSpline(back), spline);
  }
}

/// Beside a span of 1e-9 the second derivative may jump by 1 unseen by rounding there; still the
/// curve is not C2.
TEST(BezierSpline, ShortSegmentsHideNoJump) {
  BezierSpline spline{3, {0, 1, 1 + 0x1p-30, 2 + 0x1p-30}, HomogeneousPoles::Zero(10, 4)};
  spline.poles.col(3).setOnes();
  spline.poles.col(1).setConstant(1);
  // X = t before; after the second knot u X = t + (t - u)^2.
  const double u = 1 + 0x1p-30;
  spline.poles.col(0) << 0, 1 / 3.0, 2 / 3.0, 1, 1 + 0x1p-30 / 3, 1 + 0x1p-29 / 3, u, u + 1 / 3.0,
      u + 1, u + 2;
  EXPECT_EQ(continuity(spline), 1);
  expectRefused([&] { bsplineCurve(spline, 2); }, "does not go into a curve of order 2");
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    std::vector<double> breaks = {0};
    for (int s = 0; s < 6; ++s) breaks.push_back(breaks.back() + test::logUniform(random, -8, 0));
    BSplineCurve curve{3, test::flatKnots(3, breaks, 1), {}};
    curve.poles = test::randomPoles(curve.count(), i % 2 == 0, random);
    const BezierSpline smooth = bezierSpline(curve);
    ASSERT_EQ(continuity(smooth), 2) << i;
    const BSplineCurve back = bsplineCurve(smooth, 2);
    const double t = std::uniform_real_distribution<double>(0, breaks.back())(random);
    EXPECT_LT((derivatives(back, t, 0) - derivatives(curve, t, 0)).norm(),
              1e-12 * curve.poles.cwiseAbs().maxCoeff());
  }
}

TEST(BezierSpline, ContinuityIsThatOfTheWorstKnot) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const int degree = 2 + i % 5, order = i % degree;
    BezierSpline spline =
        bezierSpline(test::randomCurve(degree, degree - order, 2 + i % 4, i % 2 == 0, random));
    EXPECT_EQ(continuity(spline), order) << i;
    EXPECT_EQ(continuity(spline, true), -1);
    const double size = spline.poles.cwiseAbs().maxCoeff();
    for (int r = 1; r <= order; ++r) {
      BezierSpline moved = spline;
      moved.poles(degree + r, 1) += 1e-6 * size;
      EXPECT_EQ(continuity(moved), spline.segments() > 2 ? std::min(r - 1, degree - r - 1) : r - 1)
          << i;
    }
  }
}

/// Quarters of a circle are C0 as homogeneous curves, whatever their smoothness.
TEST(BezierSpline, ContinuityCountsTheClosingJoint) {
  std::vector<BezierCurve> quarters;
  for (int k = 0; k < 4; ++k) quarters.push_back(quarter(k));
  EXPECT_EQ(continuity(bezierSpline(quarters, {0, 1, 2, 3, 4}, true), true), 0);
  BezierSpline lens{2, {0, 1, 3}, HomogeneousPoles::Zero(5, 4), true};
  lens.poles.col(3).setOnes();
  lens.poles.col(0) << 0, 1, 3, 7, 0;
  EXPECT_EQ(continuity(lens), 1);
  EXPECT_EQ(continuity(lens, true), 0);
  lens.poles.col(0) << 0, 1, 0, -2, 0;
  EXPECT_EQ(continuity(lens, true), 1);
  lens.knots = {0, 1, 2};
  lens.poles.col(0) << 0, 1, 0, -1, 0;
  EXPECT_EQ(continuity(lens, true), 1);
  lens.poles(4, 3) = 2;
  EXPECT_EQ(continuity(lens, true), -1);
}

TEST(BezierSpline, InnerPolesOfC1AreTakenOver) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const int degree = 2 + i % 5;
    const BezierSpline spline =
        bezierSpline(test::randomCurve(degree, degree - 1, 4, i % 2 == 0, random));
    const BSplineCurve curve = bsplineCurve(spline, 1);
    Eigen::Index row = 1;
    for (int s = 0; s < 4; ++s)
      for (int j = 1; j < degree; ++j)
        EXPECT_EQ(curve.poles.row(row++),
                  spline.poles.row(static_cast<Eigen::Index>(s) * degree + j));
    EXPECT_EQ(row + 1, curve.poles.rows());
  }
}

/// Dyadic knots and poles leave nothing to round: Boehm's insertion by hand.
TEST(BezierSpline, KnotInsertionIsExact) {
  BSplineCurve curve{3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, HomogeneousPoles::Ones(6, 4)};
  curve.poles.col(0) << 0, 6, 12, 24, 36, 48;
  curve.poles.col(1) << 0, 12, 0, 12, 24, 0;
  curve.poles.col(2).setZero();
  const BezierSpline spline = bezierSpline(curve);
  HomogeneousPoles wanted = HomogeneousPoles::Ones(10, 4);
  wanted.col(2).setZero();
  wanted.col(0) << 0, 6, 9, 12.5, 16, 20, 25, 30, 36, 48;
  wanted.col(1) << 0, 12, 6, 5, 4, 8, 13, 18, 24, 0;
  EXPECT_LT((spline.poles - wanted).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(spline.knots, (std::vector<double>{0, 1, 2, 3}));
}

TEST(BezierSpline, RefusesWhatIsNoSpline) {
  BezierSpline good{2, {0, 1, 3}, HomogeneousPoles::Ones(5, 4)};
  good.closed = true;
  requireValid(good);
  const auto refused = [&](auto change, const std::string& part) {
    BezierSpline bad = good;
    change(bad);
    expectRefused([&] { requireValid(bad); }, part);
    expectRefused([&] { measureJoints(bad, 1); }, part);
    expectRefused([&] { bsplineCurve(bad, 0); }, part);
  };
  refused([](BezierSpline& s) { s.degree = 0; }, "degree is 0");
  refused([](BezierSpline& s) { s.degree = 3; }, "poles 5: 2 segments of degree 3 have 7");
  refused([](BezierSpline& s) { s.knots.resize(1); }, "knots are 1");
  refused([](BezierSpline& s) { s.knots.clear(); }, "knots are 0");
  refused([](BezierSpline& s) { s.knots[1] = nan; }, "knot 1 is nan");
  refused([](BezierSpline& s) { s.knots[2] = inf; }, "knot 2 is inf");
  refused([](BezierSpline& s) { s.knots[2] = 1; }, "knot 2 is 1, the one before 1");
  refused([](BezierSpline& s) { s.knots = {-1.5e308, 0, 1.5e308}; }, "the knots range over inf");
  refused([](BezierSpline& s) { s.poles(3, 0) = -inf; }, "pole 3 is not finite");
  refused([](BezierSpline& s) { s.poles(0, 3) = 0; }, "weight 0 is 0");
  refused([](BezierSpline& s) { s.poles(4, 2) += 0.5; },
          "the last pole, 4, is 0.5 mm from the first");
  refused([](BezierSpline& s) { s.poles(4, 2) = std::nextafter(1.0, 2.0); },
          "a closed spline ends where it begins");
  expectRefused([&] { segment(good, 2); }, "segment 2: there are 2");
  expectRefused([&] { segment(good, -1); }, "segment -1");
  expectRefused([&] { derivatives(good, nan, 1); }, "parameter t is nan");
  expectRefused([&] { derivatives(good, 0, -1); }, "order -1");
  expectRefused([&] { derivatives(BezierSpline{}, 0, 1); }, "degree is 0");
  BezierSpline high{26, {0, 1}, HomogeneousPoles::Ones(27, 4)};
  expectRefused([&] { bsplineCurve(high, 0); }, "degree is 26");
}

/// Knots [0, h, 30, .., 180] with X'' jumping at 0 alone: the same verdict whether 0 is the seam or
/// an inner knot.
TEST(BezierSpline, AShortSegmentBesideTheSeamHidesNoJump) {
  std::mt19937_64 random(testSeed());
  for (const double h : {1e-3, 1e-5, 1e-7, 1e-9})
    for (const int times : {1, 2}) {
      // A long curve of many equal turns in which 0 has that multiplicity.
      BSplineCurve turns{3, {-360, -360, -360, -360}, {}};
      for (const double start : {-360, -180, 0, 180}) {
        if (start > -360) turns.knots.insert(turns.knots.end(), times, start);
        for (const double knot : {h, 30.0, 60.0, 90.0, 120.0, 150.0})
          turns.knots.push_back(start + knot);
      }
      turns.knots.insert(turns.knots.end(), 4, 360);
      turns.poles.resize(turns.count(), 4);
      const HomogeneousPoles ring = test::randomPoles(6 + times, false, random);
      for (Eigen::Index i = 0; i < turns.count(); ++i)
        turns.poles.row(i) = ring.row(i % ring.rows());
      const BezierSpline whole = bezierSpline(turns);
      const auto cut = [&](int from) {
        const auto begin = whole.knots.begin() + from;
        BezierSpline result{3, {begin, begin + 8}, whole.poles.middleRows(3 * from, 22), true};
        result.poles.row(21) = result.poles.row(0);
        return result;
      };
      EXPECT_EQ(continuity(cut(14), true), 3 - times) << h << " seam";
      EXPECT_EQ(continuity(cut(11), true), 3 - times) << h << " inner knot";
      EXPECT_EQ(continuity(cut(14)), 2) << h;
    }
}

TEST(BezierSpline, DerivativesBeyondTheDegreeOfShortSegmentsAreZero) {
  BezierSpline line{1, {0, 1e-9}, HomogeneousPoles::Ones(2, 4)};
  line.poles.row(0).head<3>().setZero();
  const CurveDerivatives rows = derivatives(line, 0, 50);
  EXPECT_NEAR(rows(1, 0), 1e9, 1e-6);
  EXPECT_TRUE(rows.bottomRows(49).isZero(0));
}

/// 8 (degree + 4) eps of the poles, times n / h for each order on both sides: poles of size 4
/// either way, h = 1 and 2.
TEST(BezierSpline, RefusalTellsTheRounding) {
  BezierSpline spline{2, {0, 1, 3}, HomogeneousPoles::Zero(5, 4)};
  spline.poles.col(3).setOnes();
  spline.poles.col(0) << 4, 0, 0, 1, 4;
  try {
    bsplineCurve(spline, 1);
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    const std::string words = error.what(), part = "rounding ";
    const double told = std::stod(words.substr(words.find(part) + part.size()));
    EXPECT_NEAR(told, 8 * 6 * std::numeric_limits<double>::epsilon() * (4 * 4 / 1.0 + 4 * 4 / 2.0),
                1e-3 * told);
  }
}

}  // namespace
}  // namespace seamwright
