// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <seamwright/core/bezier/length.hpp>
#include <utility>

#include "curves.hpp"
#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::Vec;

constexpr int cases = 300;
/// A bracket that only rounding keeps apart is no wider, relative to the length.
constexpr double rounding = 4e-13;

BezierCurve randomCurve(int degree, bool rational, std::mt19937_64& random) {
  Poles poles(degree + 1, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(degree + 1);
  for (int i = 0; i <= degree; ++i) {
    poles.row(i) = test::randomVector(random).transpose();
    if (rational) weights(i) = test::logUniform(random, -0.3, 0.3);
  }
  return {poles, weights};
}

BezierCurve cusp() {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0;
  return BezierCurve(poles);
}

BezierCurve quarterCircle(double r) {
  Poles poles(3, 3);
  poles << r, 0, 0, r, r, 0, 0, r, 0;
  return {poles, Eigen::Vector3d(1, std::sqrt(0.5), 1)};
}

/// The speed of a polynomial or rational curve from powers of t in extended precision, not through
/// the library.
class Speed {
 public:
  explicit Speed(const BezierCurve& curve) {
    const HomogeneousPoles& h = curve.homogeneousPoles();
    const auto n = static_cast<int>(h.rows()) - 1;
    for (int c = 0; c < 4; ++c) {
      powers_[c].assign(n + 1, 0);
      for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n - i; ++k)
          powers_[c][i + k] += (k % 2 ? -1.0L : 1.0L) * choose(n, i) * choose(n - i, k) * h(i, c);
    }
  }

  long double operator()(long double t) const {
    long double value[4], slope[4];
    for (int c = 0; c < 4; ++c) {
      value[c] = slope[c] = 0;
      for (std::size_t i = powers_[c].size(); i-- > 0;) {
        slope[c] = slope[c] * t + value[c];
        value[c] = value[c] * t + powers_[c][i];
      }
    }
    long double square = 0;
    for (int c = 0; c < 3; ++c) {
      const long double v = (slope[c] * value[3] - value[c] * slope[3]) / (value[3] * value[3]);
      square += v * v;
    }
    return std::sqrt(square);
  }

 private:
  static long double choose(int n, int k) {
    long double result = 1;
    for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
    return result;
  }
  std::array<std::vector<long double>, 4> powers_;
};

/// Romberg's rule in extended precision until it stands still to 1e-15 of the whole; pieces meet at
/// \p breaks.
long double romberg(const Speed& speed, long double a, long double b) {
  std::vector<long double> row = {(b - a) / 2 * (speed(a) + speed(b))};
  for (int level = 1; level < 22; ++level) {
    const long count = 1L << (level - 1);
    long double sum = 0;
    for (long i = 0; i < count; ++i) sum += speed(a + (b - a) * (2 * i + 1) / (2 * count));
    std::vector<long double> next = {row[0] / 2 + (b - a) / (2 * count) * sum};
    long double power = 1;
    for (std::size_t k = 0; k < row.size(); ++k)
      next.push_back(next[k] + (next[k] - row[k]) / ((power *= 4) - 1));
    const long double change = std::abs(next.back() - row.back());
    row = next;
    if (level > 4 && change <= 1e-17L * row.back()) break;
  }
  return row.back();
}

void expectContains(const ArcLength& length, double wanted, double tolerance) {
  EXPECT_LE(length.lower_mm, wanted * (1 + 4e-16));
  EXPECT_GE(length.upper_mm, wanted * (1 - 4e-16));
  EXPECT_LE(length.lower_mm, length.value_mm);
  EXPECT_LE(length.value_mm, length.upper_mm);
  EXPECT_EQ(length.reached, length.upper_mm - length.lower_mm <= tolerance);
}

TEST(Length, EnclosesTheDataTo40Digits) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/frenet.json");
  const json data = json::parse(file);
  ASSERT_EQ(data["cases"].size(), 8u);
  for (const json& entry : data["cases"]) {
    SCOPED_TRACE(entry["name"]);
    const BezierCurve curve = test::bezierCurve(entry["in"]["points"], entry["in"]["weights"]);
    const double wanted = entry["out"]["arclength"], t = entry["in"]["t"];
    for (const double relative : {0.1, 1e-3, 1e-6, 1e-9, 1e-12}) {
      const double tolerance = relative * wanted;
      const ArcLength length = arcLength(curve, tolerance, 0, t);
      EXPECT_TRUE(length.reached);
      expectContains(length, wanted, tolerance);
    }
    EXPECT_NEAR(arcLength(curve, 1e-12 * wanted, 0, t).value_mm, wanted, 1e-15 * wanted);
    EXPECT_NEAR(parameterAtLength(curve, wanted, 1e-11), t, 1e-10);
    const ArcLength impossible = arcLength(curve, 1e-300, 0, t);
    EXPECT_FALSE(impossible.reached);
    EXPECT_LT(impossible.upper_mm - impossible.lower_mm, rounding * wanted);
    expectContains(impossible, wanted, 1e-300);
  }
}

TEST(Length, Identity1ALineIsAsLongAsItsChord) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const Vec p = test::randomVector(random),
              q = test::logUniform(random, -6, 6) * test::randomVector(random);
    Poles poles(2, 3);
    poles << p.transpose(), q.transpose();
    BezierCurve curve(poles, Eigen::Vector2d(1, i % 2 ? test::logUniform(random, -1, 1) : 1));
    for (int k = 0; k < i % 5; ++k) curve = curve.elevated();
    const double wanted = (curve.poles().bottomRows(1) - curve.poles().topRows(1)).norm();
    const ArcLength length = arcLength(curve, 1e-11 * wanted);
    EXPECT_TRUE(length.reached);
    EXPECT_NEAR(length.value_mm, wanted, 1e-12 * wanted);
    const bool plain = !curve.isRational() && curve.degree() == 1;
    EXPECT_LT(length.upper_mm - length.lower_mm, (plain ? 1e-14 : 1e-11) * wanted);
  }
}

TEST(Length, Identity2AQuarterOfACircleIsHalfPiRadii) {
  for (const double r : {1e-6, 0.3, 1.0, 47.0, 1e8}) {
    const double wanted = r * std::numbers::pi / 2;
    const ArcLength length = arcLength(quarterCircle(r), 1e-12 * r);
    EXPECT_TRUE(length.reached);
    expectContains(length, wanted, 1e-12 * r);
    EXPECT_NEAR(length.value_mm, wanted, 2e-15 * wanted);  // sqrt(1/2) is rounded
    EXPECT_NEAR(arcLength(quarterCircle(r), 1e-12 * r, 0, 0.5).value_mm, wanted / 2,
                2e-15 * wanted);
    EXPECT_NEAR(parameterAtLength(quarterCircle(r), wanted / 2, 1e-12 * r), 0.5, 1e-11);
  }
}

// Against Romberg's rule on powers of t in extended precision.
TEST(Length, BracketsHoldAnotherQuadrature) {
  std::mt19937_64 random(testSeed());
  int loose = 0;
  for (int i = 0; i < cases; ++i) {
    const BezierCurve curve = randomCurve(2 + i % 5, i % 2 == 1, random);
    const double a = i % 3 ? 0 : 0.2, b = i % 3 ? 1 : 0.7;
    const auto wanted = static_cast<double>(romberg(Speed(curve), a, b));
    const double tolerance = wanted * test::logUniform(random, -12, 0);
    const ArcLength length = arcLength(curve, tolerance, a, b);
    EXPECT_TRUE(length.reached) << i;
    EXPECT_LE(length.lower_mm, wanted * (1 + 1e-15)) << i;
    EXPECT_GE(length.upper_mm, wanted * (1 - 1e-15)) << i;
    loose += length.upper_mm - length.lower_mm > 0.1 * tolerance;
    // The bracket is not a decoration: the curve with a pole moved by 1e-6 is not in a tight one.
    Poles poles = curve.poles();
    poles.row(0) += 1e-6 * (poles.row(0) - poles.row(1));
    const ArcLength tight = arcLength(curve, 1e-11 * wanted, a, b);
    const double other = arcLength({poles, curve.weights()}, 1e-11 * wanted, a, b).value_mm;
    EXPECT_TRUE(other < tight.lower_mm || other > tight.upper_mm) << i;
  }
  EXPECT_GT(loose, 15);  // no more work than asked
}

// Values are nearer to each other than the brackets asked for.
TEST(Length, Identity3PartsReversalElevationMotionScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const BezierCurve curve = randomCurve(2 + i % 5, i % 2 == 1, random);
    const double whole = arcLength(curve, 1e-8).value_mm, bound = 1e-10;
    const double t = static_cast<double>(i) / cases;
    EXPECT_NEAR(arcLength(curve, 1e-8, 0, t).value_mm + arcLength(curve, 1e-8, t, 1).value_mm,
                whole, 2 * bound);
    EXPECT_NEAR(arcLength(curve.reversed(), 1e-8).value_mm, whole, bound);
    EXPECT_NEAR(arcLength(curve.elevated(), 1e-8).value_mm, whole, bound);
    EXPECT_NEAR(arcLength(curve.split(t).first, 1e-8).value_mm,
                arcLength(curve, 1e-8, 0, t).value_mm, bound);
    const double scale = test::logUniform(random, -6, 6);
    const Poles poles = (scale * curve.poles() * test::randomRotation(random)).rowwise() +
                        Eigen::RowVector3d(scale, -scale, 2 * scale);
    EXPECT_NEAR(arcLength({poles, curve.weights()}, 1e-8 * scale).value_mm / scale, whole,
                2 * bound);
  }
}

// With u = 2 t - 1, X = (u^2, u^3) over [-1, 1]: twice the length (13 sqrt(13) - 8) / 27 of a
// branch of the semicubical parabola.
TEST(Length, Identity4BothBranchesOfACusp) {
  Poles poles(4, 3);
  poles << 1, -1, 0, -1.0 / 3, 1, 0, -1.0 / 3, -1, 0, 1, 1, 0;
  const BezierCurve curve(poles);
  const double wanted = 2 * (13 * std::sqrt(13.0) - 8) / 27;
  for (const double tolerance : {1.0, 1e-2, 1e-5, 1e-8, 1e-12}) {
    const ArcLength length = arcLength(curve, tolerance);
    EXPECT_TRUE(length.reached);
    expectContains(length, wanted, tolerance);
  }
  EXPECT_NEAR(arcLength(curve, 1e-12).value_mm, wanted, 1e-13);
  EXPECT_NEAR(parameterAtLength(curve, wanted / 2, 1e-10), 0.5,
              1e-4);  // within sqrt(1e-10) where the speed is 0
  for (int i = 0; i <= 40; ++i) {
    const double length = wanted * i / 40;
    EXPECT_NEAR(arcLength(curve, 1e-12, 0, parameterAtLength(curve, length, 1e-9)).value_mm, length,
                1e-9)
        << i;
  }
  EXPECT_TRUE(arcLength(cusp(), 1e-12).reached);
}

// Pythagorean hodographs: X' = (u^2 - v^2, 2 u v) with u, v linear has the speed u^2 + v^2.
TEST(Length, PythagoreanHodographsHaveAClosedForm) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const Vec u = test::randomVector(random), v = i % 5 ? test::randomVector(random) : Vec(0.5 * u);
    Poles poles = Poles::Zero(4, 3);
    const Eigen::Vector3d x(u(0) * u(0) - v(0) * v(0), u(0) * u(1) - v(0) * v(1),
                            u(1) * u(1) - v(1) * v(1));
    const Eigen::Vector3d y(2 * u(0) * v(0), u(0) * v(1) + u(1) * v(0), 2 * u(1) * v(1));
    for (int k = 0; k < 3; ++k)
      poles.row(k + 1) = poles.row(k) + Eigen::RowVector3d(x(k), y(k), 0) / 3;
    const auto quadratic = [](const Vec& f) { return f(0) * f(0) + f(0) * f(1) + f(1) * f(1); };
    const double wanted = (quadratic(u) + quadratic(v)) / 3;
    const ArcLength length = arcLength(BezierCurve(poles), 1e-11 * wanted);
    EXPECT_TRUE(length.reached) << i;
    EXPECT_LE(length.lower_mm, wanted * (1 + 2e-15)) << i;  // poles are rounded
    EXPECT_GE(length.upper_mm, wanted * (1 - 2e-15)) << i;
  }
}

// Of a curve of high degree that turns gently, Bernstein coefficients are near to the values: then
// the proved remainder is at least the largest |X'| - g, and less than twice that.
TEST(Length, TheRemainderIsTheLargestOfSpeedLessItsPolynomial) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 20; ++i) {
    Poles poles(4, 3);
    for (int k = 0; k < 4; ++k)
      poles.row(k) = (Vec(k, 0, 0) + 0.12 * test::randomVector(random)).transpose();
    BezierCurve curve(poles);
    const Speed speed(curve);
    while (curve.degree() < 40) curve = curve.elevated();
    const ArcLength length = arcLength(curve, 1e9);
    std::array<long double, 7> nodes{};  // the roots of Legendre's polynomial, by Newton's method
    for (int k = 0; k < 7; ++k) {
      long double x = std::cos(std::numbers::pi_v<long double> * (k + 0.75L) / 7.5L);
      for (int step = 0; step < 20; ++step) {
        long double before = 1, p = x;
        for (int n = 2; n <= 7; ++n)
          before = std::exchange(p, ((2 * n - 1) * x * p - (n - 1) * before) / n);
        x -= p * (x * x - 1) / (7 * (x * p - before));
      }
      nodes[k] = (1 + x) / 2;
    }
    long double most = 0, least = 0;
    for (int k = 0; k <= 1000; ++k) {
      const long double t = k / 1000.0L;
      long double g = 0;
      for (int a = 0; a < 7; ++a) {
        long double basis = speed(nodes[a]);
        for (int b = 0; b < 7; ++b)
          if (b != a) basis *= (t - nodes[b]) / (nodes[a] - nodes[b]);
        g += basis;
      }
      most = std::max(most, speed(t) - g);
      least = std::min(least, speed(t) - g);
    }
    ASSERT_GT(most, 1e-9) << "far above rounding";
    const double above = length.upper_mm - length.value_mm,
                 below = length.value_mm - length.lower_mm;
    EXPECT_GE(above, static_cast<double>(most) * (1 - 1e-5)) << i;
    EXPECT_GE(below, static_cast<double>(-least) * (1 - 1e-5)) << i;
    EXPECT_LT(above, 2.5 * static_cast<double>(most)) << i;
    EXPECT_LT(below, 2.5 * static_cast<double>(-least)) << i;
  }
}

TEST(Length, LineThatTurnsBack) {
  Poles poles(3, 3);
  poles << 0, 0, 0, 1, 2, 2, 0, 0, 0;  // up to half of (1, 2, 2) and back
  const ArcLength length = arcLength(BezierCurve(poles), 1e-12);
  EXPECT_TRUE(length.reached);
  expectContains(length, 3, 1e-12);
}

TEST(Length, ParameterAtLengthIsTheInverse) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const BezierCurve curve = randomCurve(1 + i % 6, i % 2 == 1, random);
    const double tolerance = test::logUniform(random, -10, -2), t = i / 300.0;
    const double length = arcLength(curve, 1e-12, 0, t).value_mm;
    const double found = parameterAtLength(curve, length, tolerance);
    EXPECT_NEAR(arcLength(curve, 1e-12, 0, found).value_mm, length, tolerance) << i;
  }
  EXPECT_EQ(parameterAtLength(cusp(), 0, 1e-9), 0);
  EXPECT_EQ(parameterAtLength(BezierCurve(Poles::Ones(3, 3)), 0, 1e-9), 0);
}

TEST(Length, Identity6MarksAreTheLengthsUpToThem) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const BezierCurve curve = randomCurve(2 + i % 5, i % 2 == 1, random);
    constexpr double tolerance = 1e-10;
    const std::vector<LengthMark> marks = lengthMarks(curve, tolerance);
    ASSERT_GE(marks.size(), 2U);
    EXPECT_EQ(marks.front().t, 0);
    EXPECT_EQ(marks.front().length_mm, 0);
    EXPECT_EQ(marks.back().t, 1);
    const Speed speed(curve);
    for (std::size_t k = 1; k < marks.size(); ++k) {
      ASSERT_LT(marks[k - 1].t, marks[k].t);
      const double part = marks[k].length_mm - marks[k - 1].length_mm;
      EXPECT_NEAR(part, static_cast<double>(romberg(speed, marks[k - 1].t, marks[k].t)), tolerance);
      const double middle =
          parameterAtLength(curve, 0.5 * part, tolerance, marks[k - 1].t, marks[k].t);
      EXPECT_NEAR(static_cast<double>(romberg(speed, marks[k - 1].t, middle)), 0.5 * part,
                  tolerance);
    }
  }
}

// Weights so uneven that the bounds stay apart: the value goes on to meet what is asked, or comes
// as near as it can.
TEST(Length, Identity5TheValueMeetsTheLengthAsked) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 1, 0, 2, -1, 0.5, 3, 0, 0;
  for (const Eigen::Vector4d& weights :
       {Eigen::Vector4d(1, 1, 1e6, 1e6), Eigen::Vector4d(1, 1e-5, 1e5, 1),
        Eigen::Vector4d(1, 1e-4, 1e4, 1), Eigen::Vector4d(1, 1, 1, 1)}) {
    const BezierCurve curve(poles, weights);
    const double whole = arcLength(curve, 1e-9).value_mm, tolerance = 1e-9;
    for (const double share : {0.1, 0.5, 0.9}) {
      const double wanted = share * whole, t = parameterAtLength(curve, wanted, tolerance);
      const auto missing = [&](double at) {
        return std::abs(arcLength(curve, tolerance / 4, 0, at).value_mm - wanted);
      };
      const double neighbours =
          std::min(missing(std::nextafter(t, 0)), missing(std::nextafter(t, 1)));
      EXPECT_LE(missing(t), std::max(tolerance / 2, neighbours))
          << weights.transpose() << " " << share;
      const ArcLength length = arcLength(curve, tolerance / 4, 0, t);
      const auto truth = static_cast<double>(romberg(Speed(curve), 0, t));
      EXPECT_LE(std::abs(truth - wanted),
                tolerance + (length.reached ? 0 : length.upper_mm - length.lower_mm))
          << weights.transpose() << " " << share;
    }
  }
}

// What cannot be reached ends where rounding begins, for high degrees and uneven weights too.
TEST(Length, ImpossibleTolerancesEnd) {
  std::mt19937_64 random(testSeed());
  for (const int degree : {10, 25}) {
    BezierCurve curve = randomCurve(degree, true, random);
    Eigen::VectorXd weights = curve.weights();
    weights(3) = 40;
    curve = {curve.poles(), weights};
    const ArcLength best = arcLength(curve, 1e-300);
    EXPECT_FALSE(best.reached);
    EXPECT_LT(best.upper_mm - best.lower_mm, 1e-9 * best.value_mm);
    const ArcLength coarse = arcLength(curve, 1e-3 * best.value_mm);
    EXPECT_TRUE(coarse.lower_mm <= best.upper_mm && best.lower_mm <= coarse.upper_mm);
    EXPECT_NEAR(coarse.value_mm, best.value_mm, 1e-5 * best.value_mm);
  }
}

TEST(Length, ExtremeSizesAndPoints) {
  for (const double size : {1e-150, 1e-12, 1e12, 1e150}) {
    const ArcLength length = arcLength(quarterCircle(size), 1e-11 * size);
    EXPECT_TRUE(length.reached) << size;
    EXPECT_NEAR(length.value_mm / size, std::numbers::pi / 2, 1e-14) << size;
  }
  const ArcLength point = arcLength(BezierCurve(Poles::Constant(4, 3, 0.1)), 1e-9);
  EXPECT_EQ(point.value_mm, 0);
  EXPECT_TRUE(point.reached);
  EXPECT_EQ(arcLength(BezierCurve(Poles::Ones(1, 3)), 1).upper_mm, 0);
  EXPECT_EQ(arcLength(cusp(), 1, 0.3, 0.3).upper_mm, 0);
  // Far from the origin: poles are exact, so only their differences count.
  Poles far(3, 3);
  far << 1e9, 0, 0, 1e9 + 1, 0, 0, 1e9 + 1, 1, 0;
  Poles near = far;
  near.col(0).array() -= 1e9;
  EXPECT_EQ(arcLength(BezierCurve(far), 1e-12).value_mm,
            arcLength(BezierCurve(near), 1e-12).value_mm);
}

TEST(Length, RefusesBadArguments) {
  const auto message = [](auto call) {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message([] { arcLength(cusp(), 0); }), testing::HasSubstr("tolerance is 0"));
  EXPECT_THAT(message([] { arcLength(cusp(), std::nan("")); }),
              testing::HasSubstr("tolerance is nan"));
  EXPECT_THAT(message([] { arcLength(cusp(), std::numeric_limits<double>::infinity()); }),
              testing::HasSubstr("tolerance is inf"));
  const Poles many = Poles::Ones(403, 3);
  EXPECT_THAT(message([&] { arcLength(BezierCurve(many), 1); }),
              testing::HasSubstr(
                  "degree is 402: the length of a polynomial curve is known up to degree 401"));
  EXPECT_THAT(message([&] {
                arcLength({many.topRows(199), Eigen::VectorXd::LinSpaced(199, 1, 2)}, 1);
              }),
              testing::HasSubstr(
                  "degree is 198: the length of a rational curve is known up to degree 197"));
  std::mt19937_64 random(testSeed());
  EXPECT_EQ(message([&] { arcLength(randomCurve(401, false, random), 1e9); }), "");
  EXPECT_EQ(message([&] { arcLength(randomCurve(197, true, random), 1e9); }), "");
  EXPECT_THAT(message([] { arcLength(cusp(), 1, 0.5, 0.25); }),
              testing::HasSubstr("range is 0.5 .. 0.25"));
  EXPECT_THAT(message([] { arcLength(cusp(), 1, 0, std::nan("")); }),
              testing::HasSubstr("range is 0 .. nan"));
  EXPECT_THAT(message([] { arcLength(cusp(), 1, -1, 1); }), testing::HasSubstr("range is -1"));
  EXPECT_THAT(message([] { parameterAtLength(cusp(), 2, 1e-9); }),
              testing::AllOf(testing::HasSubstr("length is 2"), testing::HasSubstr("0 .. 1.828")));
  EXPECT_THAT(message([] { parameterAtLength(cusp(), -1, 1e-9); }),
              testing::HasSubstr("length is -1"));
  EXPECT_THAT(message([] { parameterAtLength(cusp(), std::nan(""), 1e-9); }),
              testing::HasSubstr("length is nan"));
  EXPECT_THAT(message([] { parameterAtLength(cusp(), 1, -1); }),
              testing::HasSubstr("tolerance is -1"));
}

}  // namespace
}  // namespace seamwright
