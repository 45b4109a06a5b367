// SPDX-License-Identifier: LGPL-2.1-or-later
#include <limits>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bernstein/polynomial.hpp>
#include <thread>
#include <vector>

#include "bernstein_test.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Eigen::VectorXd;
using test::Dyadic;
using test::DyadicVector;
using test::Encloses;
using test::exactBernstein;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kUnit = 0x1p-52;
constexpr double kEta = std::numeric_limits<double>::denorm_min();

double gammaBound(int k) {
  return k * kUnit / (1 - k * kUnit);
}

double magnitude(const BernsteinPolynomial& p) {
  return p.coefficients().cwiseAbs().maxCoeff();
}

VectorXd randomCoefficients(std::mt19937_64& random, int degree, double lower_power = -3,
                            double upper_power = 3) {
  return VectorXd::NullaryExpr(degree + 1,
                               [&] { return test::spread(random, lower_power, upper_power); });
}

/// A polynomial and exact coefficients that its padding allows, often at the rim.
struct Known {
  BernsteinPolynomial stored;
  DyadicVector truth;
};

Known randomKnown(std::mt19937_64& random, int degree, double lower_power = -3,
                  double upper_power = 3) {
  const VectorXd c = randomCoefficients(random, degree, lower_power, upper_power);
  const double paddings[] = {0, 1e-15, 1e-12, 1e-3};
  const double padding = paddings[random() % 4] * std::pow(10, upper_power);
  DyadicVector truth = test::exact(c);
  for (Dyadic& value : truth) {
    const double share = random() % 2 ? (random() % 2 ? 1.0 : -1.0) : test::uniform(random, -1, 1);
    value = value + Dyadic(padding) * Dyadic(share);
  }
  return {BernsteinPolynomial(c, padding), truth};
}

Known ones(int degree) {
  return {BernsteinPolynomial(VectorXd::Ones(degree + 1)), DyadicVector(degree + 1, 1.0)};
}

/// Each weight x true coefficient, the weights 1 if none are given, is within padding of the
/// computed one.
void expectWithinPadding(const BernsteinPolynomial& computed, const DyadicVector& truth,
                         const DyadicVector& weights = {}) {
  ASSERT_EQ(computed.degree() + 1, static_cast<int>(truth.size()));
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const Dyadic weight = weights.empty() ? Dyadic(1) : weights[k];
    const Dyadic error =
        (Dyadic(computed.coefficients()(static_cast<int>(k))) * weight - truth[k]).abs();
    EXPECT_TRUE(error <= Dyadic(computed.padding()) * weight)
        << "coefficient " << k << " of degree " << computed.degree() << ": error "
        << static_cast<double>(error.approximate() / weight.approximate()) << ", padding ";
  }
}

/// The bounds in the header are upper bounds of what is reported, apart from their own rounding.
void expectPaddingAtMost(const BernsteinPolynomial& computed, long double bound) {
  EXPECT_LE(computed.padding(), bound * (1 + 1e-12L) + 16 * kEta)
      << computed.padding() / bound - 1 << " degree " << computed.degree();
}

DyadicVector sizes(const BernsteinPolynomial& p) {
  return test::exact(p.coefficients().cwiseAbs());
}

/// The largest coefficient of a product of polynomials with positive coefficients.
long double largestOfProduct(const DyadicVector& p, const DyadicVector& q) {
  const DyadicVector sums = test::exactProductTimesBinomials(p, q);
  const DyadicVector weights = test::exactBinomials(static_cast<int>(sums.size()) - 1);
  long double result = 0;
  for (std::size_t k = 0; k < sums.size(); ++k)
    result = std::max(result, sums[k].approximate() / weights[k].approximate());
  return result;
}

void expectProduct(const Known& p, const Known& q) {
  const BernsteinPolynomial product = p.stored * q.stored;
  expectWithinPadding(product, test::exactProductTimesBinomials(p.truth, q.truth),
                      test::exactBinomials(product.degree()));
  const auto r = [](int degree) { return std::max(0, degree - 56); };
  const int m = p.stored.degree(), n = q.stored.degree(),
            k = std::min(m, n) + 4 + r(m) + r(n) + r(m + n);
  const DyadicVector size_p = sizes(p.stored), size_q = sizes(q.stored);
  const double e = p.stored.padding(), f = q.stored.padding();
  expectPaddingAtMost(product, e * largestOfProduct(DyadicVector(m + 1, 1.0), size_q) +
                                   f * largestOfProduct(size_p, DyadicVector(n + 1, 1.0)) + e * f +
                                   gammaBound(k + 2) * largestOfProduct(size_p, size_q) + kEta);
}

void expectPieces(const Known& p, double t) {
  const auto [left, right] = p.stored.split(t);
  expectWithinPadding(left, test::exactRestriction(p.truth, 0.0, t));
  expectWithinPadding(right, test::exactRestriction(p.truth, t, 1.0));
  const int n = p.stored.degree();
  const double error =
      t == 0 || t == 1 ? 0 : gammaBound(t == 0.5 ? n : 3 * n) * magnitude(p.stored) + 4 * n * kEta;
  expectPaddingAtMost(left, p.stored.padding() + error);
  expectPaddingAtMost(right, p.stored.padding() + error);
}

void expectRestriction(const Known& p, double a, double b) {
  const BernsteinPolynomial piece = p.stored.restricted({a, b});
  expectWithinPadding(piece, test::exactRestriction(p.truth, a, b));
  const int n = p.stored.degree();
  expectPaddingAtMost(piece,
                      p.stored.padding() + gammaBound(9 * n) * magnitude(p.stored) + 8 * n * kEta);
}

class BernsteinPolynomials : public test::InEachRoundingMode {};
INSTANTIATE_TEST_SUITE_P(Modes, BernsteinPolynomials, test::kRoundingModes, test::roundingModeName);

TEST_P(BernsteinPolynomials, Identity1PartitionOfUnity) {
  for (const int degree : {0, 1, 2, 7, 60, 300})
    for (const double t : {0.0, 1e-300, 0.1, 0.5, 0.77, 1.0}) {
      const Interval one = BernsteinPolynomial(VectorXd::Ones(degree + 1)).evaluate(t);
      EXPECT_TRUE(one.contains(1)) << degree << " at " << t;
      EXPECT_LE(one.width(), 2 * gammaBound(3 * degree + 2) * (1 + 1e-12) + 2 * kUnit);
    }
}

TEST_P(BernsteinPolynomials, Identity2ProductsAndSums) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 150; ++trial) {
    const Known p = randomKnown(random, static_cast<int>(random() % 9)),
                q = randomKnown(random, static_cast<int>(random() % 9));
    expectProduct(p, q);
    const int degree = std::max(p.stored.degree(), q.stored.degree());
    const DyadicVector weights = test::exactBinomials(degree);
    const auto raised = [&](const DyadicVector& c) {
      return test::exactProductTimesBinomials(c, DyadicVector(degree + 2 - c.size(), 1.0));
    };
    DyadicVector sum = raised(p.truth), difference = sum;
    const DyadicVector other = raised(q.truth);
    for (int k = 0; k <= degree; ++k) {
      sum[k] = sum[k] + other[k];
      difference[k] = difference[k] - other[k];
    }
    expectWithinPadding(p.stored + q.stored, sum, weights);
    expectWithinPadding(p.stored - q.stored, difference, weights);
    for (const double t : {0.0, 0.25, 0.8125, 1.0})
      EXPECT_THAT((p.stored * q.stored).evaluate(t),
                  Encloses(exactBernstein(p.truth, t) * exactBernstein(q.truth, t)));
  }
}

TEST_P(BernsteinPolynomials, Identity2OfEqualDegreesAndMultiplesRoundOnce) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 100; ++trial) {
    const int degree = static_cast<int>(random() % 12);
    const Known p = randomKnown(random, degree), q = randomKnown(random, degree);
    const double factor = test::spread(random, -200, 200);
    const BernsteinPolynomial sum = p.stored + q.stored, multiple = factor * p.stored;
    expectPaddingAtMost(sum, p.stored.padding() + q.stored.padding() + kUnit * magnitude(sum));
    expectPaddingAtMost(multiple,
                        std::abs(factor) * p.stored.padding() + kUnit * magnitude(multiple) + kEta);
    DyadicVector truth;
    for (const Dyadic& value : p.truth) truth.push_back(Dyadic(factor) * value);
    expectWithinPadding(multiple, truth);
  }
}

TEST_P(BernsteinPolynomials, Identity3Leibniz) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 100; ++trial) {
    const Known p = randomKnown(random, static_cast<int>(random() % 10)),
                q = randomKnown(random, static_cast<int>(random() % 10));
    const BernsteinPolynomial zero =
        (p.stored * q.stored).derivative() -
        (p.stored.derivative() * q.stored + p.stored * q.stored.derivative());
    EXPECT_LE(magnitude(zero), zero.padding());
    const int n = p.stored.degree();
    if (n == 0) {
      EXPECT_EQ(p.stored.derivative(), BernsteinPolynomial(VectorXd::Zero(1)));
      continue;
    }
    DyadicVector truth;
    for (int k = 0; k < n; ++k) truth.push_back(Dyadic(n) * (p.truth[k + 1] - p.truth[k]));
    const BernsteinPolynomial derivative = p.stored.derivative();
    expectWithinPadding(derivative, truth);
    expectPaddingAtMost(derivative,
                        2 * n * p.stored.padding() + gammaBound(3) * magnitude(derivative));
  }
}

TEST_P(BernsteinPolynomials, Identity4ElevationChangesNothing) {
  std::mt19937_64 random(testSeed());
  for (const int degree : {0, 1, 3, 8, 30, 55})
    for (const int by : {0, 1, 2, 5, 40}) {
      const Known p = randomKnown(random, degree);
      const BernsteinPolynomial raised = p.stored.elevated(by);
      expectWithinPadding(raised, test::exactProductTimesBinomials(p.truth, ones(by).truth),
                          test::exactBinomials(degree + by));
      EXPECT_EQ(raised.padding() == p.stored.padding(), by == 0 || magnitude(p.stored) == 0);
    }
}

TEST_P(BernsteinPolynomials, Identity5PiecesTakeTheValues) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 60; ++trial) {
    const Known p = randomKnown(random, static_cast<int>(random() % 12));
    for (const double t :
         {0.0, 5e-324, 1e-310, 1e-17, test::uniform(random, 0, 1), 0.5, 1 - 0x1p-53, 1.0})
      expectPieces(p, t);
    const double a = test::uniform(random, 0, 1), b = test::uniform(random, a, 1);
    expectRestriction(p, a, b);
    expectRestriction(p, 0, b);
    expectRestriction(p, a, 1);
    expectRestriction(p, a, std::nextafter(a, 2));
    expectRestriction(p, b, b);
    expectRestriction(p, 1 - 0x1p-53, 1);
    expectRestriction(p, 5e-324, 1e-323);
    expectRestriction(p, 1e-310, 3e-310);
    expectRestriction(p, 1, 1);
    EXPECT_EQ(p.stored.restricted({0, 1}), p.stored);
  }
}

TEST_P(BernsteinPolynomials, Identity6RangesContainAllValues) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const Known p = randomKnown(random, static_cast<int>(random() % 14));
    const Interval hull = p.stored.range(), fine = p.stored.range(1e-3 * magnitude(p.stored));
    EXPECT_TRUE(hull.contains(fine));
    for (int i = 0; i <= 64; ++i) {
      const Dyadic value = exactBernstein(p.truth, i / 64.0);
      EXPECT_THAT(hull, Encloses(value));
      EXPECT_THAT(fine, Encloses(value));
    }
  }
}

TEST_P(BernsteinPolynomials, Identity7EndsAreKnownAsWellAsTheCoefficients) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const BernsteinPolynomial exact(randomCoefficients(random, trial));
    EXPECT_EQ(exact.evaluate(0).lower, exact.coefficients()(0));
    EXPECT_EQ(exact.evaluate(0).upper, exact.coefficients()(0));
    EXPECT_EQ(exact.evaluate(1).lower, exact.coefficients()(trial));
    const Interval end = BernsteinPolynomial(exact.coefficients(), 1e-9).evaluate(1);
    EXPECT_THAT(end, Encloses(Dyadic(exact.coefficients()(trial)) + Dyadic(1e-9)));
    EXPECT_NEAR(end.width(), 2e-9, 1e-12);
  }
}

TEST_P(BernsteinPolynomials, ValuesAreEnclosedAtAnyParameter) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 60; ++trial) {
    const Known p = randomKnown(random, static_cast<int>(random() % 20), -16, 16);
    for (const double t : {5e-324, 1e-9, 0.1, test::uniform(random, 0, 1), 0.5, 1 - 0x1p-53})
      EXPECT_THAT(p.stored.evaluate(t), Encloses(exactBernstein(p.truth, t)));
  }
}

/// prod_i (t - i/64), i = 1..degree, for which the coefficients are huge against the values; exact
/// at dyadic t.
TEST_P(BernsteinPolynomials, WilkinsonProductsAreEnclosedAtAndBetweenTheirRoots) {
  for (const int degree : {20, 60}) {
    BernsteinPolynomial p(VectorXd::Ones(1));
    double sizes = 1;
    for (int i = 1; i <= degree; ++i) {
      p = p * BernsteinPolynomial(Eigen::Vector2d(-i / 64.0, 1 - i / 64.0));
      sizes *= std::max(i / 64.0, 1 - i / 64.0);
    }
    ASSERT_EQ(p.degree(), degree);
    for (int j = 0; j <= 128; ++j) {
      const double t = j / 128.0;
      Dyadic truth = 1;
      for (int i = 1; i <= degree; ++i) truth = truth * Dyadic(t - i / 64.0);
      EXPECT_THAT(p.evaluate(t), Encloses(truth)) << "degree " << degree << " at " << t;
      EXPECT_THAT(p.range(), Encloses(truth));
    }
    EXPECT_LT(p.padding(), gammaBound(8 * degree) * sizes);
  }
}

TEST_P(BernsteinPolynomials, CancellingSumsKeepTheTruth) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 60; ++trial) {
    const int degree = 1 + static_cast<int>(random() % 8);
    const BernsteinPolynomial p(randomCoefficients(random, degree, 0, 16)),
        q(randomCoefficients(random, degree, -16, 0)), r(randomCoefficients(random, degree));
    // (p + q) r - p r = q r
    const BernsteinPolynomial small = (p + q) * r - p * r;
    expectWithinPadding(small,
                        test::exactProductTimesBinomials(test::exact(q.coefficients()),
                                                         test::exact(r.coefficients())),
                        test::exactBinomials(2 * degree));
  }
}

TEST_P(BernsteinPolynomials, DegreesBeyondExactBinomials) {
  std::mt19937_64 random(testSeed());
  for (const int degree : {56, 57, 60}) {
    const Known p = randomKnown(random, degree), q = randomKnown(random, 60);
    expectProduct(p, q);
    expectPieces(p, 0.5);
    expectPieces(p, 0.203125);
    for (const double t : {0.0, 0.25, 0.703125})
      EXPECT_THAT(p.stored.evaluate(t), Encloses(exactBernstein(p.truth, t)));
  }
  expectProduct(randomKnown(random, 140), randomKnown(random, 7));
}

/// A new thread, because each keeps the binomials that it has computed.
TEST_P(BernsteinPolynomials, BinomialsAreExactToDegree56AndRoundOnceADegreeAbove) {
  std::thread([mode = GetParam()] {
    std::fesetround(mode);
    for (const int n : {0, 1, 30, 56, 57, 60, 140}) {
      const DyadicVector truth = test::exactBinomials(n);
      const Dyadic relative = gammaBound(std::max(0, n - 56));
      for (int k = 0; k <= n; ++k)
        EXPECT_TRUE((Dyadic(bernstein::binomials(n)(k)) - truth[k]).abs() <= relative * truth[k])
            << n << ", " << k;
    }
    EXPECT_EQ(bernstein::binomialRoundings(56), 0);
    EXPECT_EQ(bernstein::binomialRoundings(60), 4);
  }).join();
}

TEST_P(BernsteinPolynomials, SizesAtTheRimOfADouble) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 60; ++trial) {
    const int degree = static_cast<int>(random() % 9);
    const Known huge = randomKnown(random, degree, 290, 300),
                tiny = randomKnown(random, degree, -307, -300),
                wide = randomKnown(random, degree, -300, 300),
                denormal = randomKnown(random, degree, -323, -305);
    for (const Known* p : {&huge, &tiny, &wide, &denormal}) {
      expectPieces(*p, 0.5);
      expectPieces(*p, test::uniform(random, 0, 1));
      expectRestriction(*p, 0.2, 0.9);
      expectProduct(*p, ones(2));
      expectProduct(*p, tiny);
      expectProduct(*p, denormal);
      for (const double t : {0.1, 0.5})
        EXPECT_THAT(p->stored.evaluate(t), Encloses(exactBernstein(p->truth, t)));
      const Interval range = p->stored.range(0);
      for (int i = 0; i <= 16; ++i)
        EXPECT_THAT(range, Encloses(exactBernstein(p->truth, i / 16.0)));
    }
    expectProduct(
        Known{BernsteinPolynomial(VectorXd::Constant(61, 1e300)), DyadicVector(61, 1e300)}, tiny);
  }
}

TEST_P(BernsteinPolynomials, OverflowIsAnErrorWithNumbers) {
  const BernsteinPolynomial huge(VectorXd::Constant(4, 1e300)),
      steep(Eigen::Vector2d(-8e307, 8e307));
  const BernsteinPolynomial vague(VectorXd::Ones(2), 1e200);
  EXPECT_THAT([&] { huge* huge; }, ThrowsMessage<std::overflow_error>(
                                       AllOf(HasSubstr("product"), HasSubstr("coefficient 0"))));
  EXPECT_THAT([&] { vague* vague; }, ThrowsMessage<std::overflow_error>(HasSubstr("padding is")));
  EXPECT_THAT([&] { steep.derivative(); },
              ThrowsMessage<std::overflow_error>(HasSubstr("derivative")));
  EXPECT_THAT([&] { steep + steep; },
              ThrowsMessage<std::overflow_error>(HasSubstr("sum: coefficient 0")));
  EXPECT_THAT([&] { 1e10 * huge; }, ThrowsMessage<std::overflow_error>(HasSubstr("multiple")));
  const Interval middle = steep.evaluate(0.3);
  EXPECT_THAT(middle, Encloses(exactBernstein(test::exact(steep.coefficients()), 0.3)));
  EXPECT_TRUE(BernsteinPolynomial(VectorXd::Constant(1, 8e307), 8e307).range().contains(1.5e308));
}

TEST_P(BernsteinPolynomials, ConstantsAndZerosAreKeptExactly) {
  const BernsteinPolynomial constant(VectorXd::Constant(1, 0.1)), zero(VectorXd::Zero(4));
  for (const double t : {0.0, 0.3, 1.0}) EXPECT_EQ(constant.evaluate(t).width(), 0);
  EXPECT_EQ(constant.split(0.3).first, constant);
  EXPECT_EQ(constant.restricted({0.2, 0.3}), constant);
  EXPECT_EQ(constant.derivative(), BernsteinPolynomial(VectorXd::Zero(1)));
  EXPECT_EQ(constant.range(0).width(), 0);
  EXPECT_EQ((zero * constant), BernsteinPolynomial(VectorXd::Zero(4)));
  EXPECT_EQ(zero + zero, zero);
  EXPECT_EQ(0 * constant, BernsteinPolynomial(VectorXd::Zero(1)));
}

/// (t - 1/3)^2 on pieces of width 2^-L: 1/3 lies at a third or at two thirds of its piece, where
/// the lowest coefficient is -2/9 4^-L; the values reach 0 there.
TEST(BernsteinPolynomial, Identity6ExcessShrinksByFourAtEachHalving) {
  const BernsteinPolynomial p(Eigen::Vector3d(1.0 / 9, -2.0 / 9, 4.0 / 9));
  std::vector<BernsteinPolynomial> pieces{p};
  double excess = -p.range().lower;
  for (int level = 1; level <= 8; ++level) {
    std::vector<BernsteinPolynomial> halves;
    double lower = kInfinity;
    for (const BernsteinPolynomial& piece : pieces) {
      auto [left, right] = piece.split(0.5);
      lower = std::min({lower, left.range().lower, right.range().lower});
      halves.push_back(std::move(left));
      halves.push_back(std::move(right));
    }
    EXPECT_NEAR(excess / -lower, 4, 1e-8) << "level " << level;
    excess = -lower;
    pieces = std::move(halves);
  }
}

/// Chebyshev's polynomial of degree n on [0, 1] has range [-1, 1], attained n + 1 times; Bernstein
/// coefficients (-1)^(n-i) C(2n, 2i) / C(n, i).
TEST(BernsteinPolynomial, RangeIsAsTightAsAskedFor) {
  for (const int n : {2, 5, 12, 20}) {
    VectorXd c(n + 1);
    const DyadicVector upper = test::exactBinomials(2 * n), lower = test::exactBinomials(n);
    for (int i = 0; i <= n; ++i)
      c(i) = ((n - i) % 2 ? -1 : 1) *
             static_cast<double>(upper[2 * i].approximate() / lower[i].approximate());
    const BernsteinPolynomial chebyshev(c, kUnit * c.cwiseAbs().maxCoeff());
    EXPECT_GT(chebyshev.range().width(), 2.9);
    for (const double tolerance : {0.5, 1e-3, 1e-8}) {
      const Interval range = chebyshev.range(tolerance);
      EXPECT_TRUE(range.contains(Interval{-1, 1}));
      EXPECT_LE(range.width(), 2 + tolerance) << "degree " << n;
    }
    const Interval best = chebyshev.range(0);
    EXPECT_TRUE(best.contains(Interval{-1, 1}));
    EXPECT_LE(best.width() - 2,
              6 * (chebyshev.padding() + 40 * gammaBound(n) * magnitude(chebyshev)));
  }
}

TEST(BernsteinPolynomial, BadInputIsRefusedWithItsNumbers) {
  const auto make = [](double value, double padding) {
    return [=] { BernsteinPolynomial(Eigen::Vector3d(0, 1, value), padding); };
  };
  const auto refused = [](const std::string& words) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(words));
  };
  EXPECT_THAT(make(kNaN, 0), refused("coefficient 2 is nan"));
  EXPECT_THAT(make(-kInfinity, 0), refused("coefficient 2 is -inf"));
  EXPECT_THAT(make(1.7e308, 0), refused("coefficient 2 is 1.69"));
  EXPECT_THAT(make(0, -1e-20), refused("padding is -"));
  EXPECT_THAT(make(0, kNaN), refused("padding is nan"));
  EXPECT_THAT(make(0, kInfinity), refused("padding is inf"));
  EXPECT_THAT([] { BernsteinPolynomial(VectorXd(0)); }, refused("no coefficients"));
  const BernsteinPolynomial p(Eigen::Vector3d(0, 1, 3));
  for (const double t : {-5e-324, 1 + kUnit, kNaN, kInfinity}) {
    EXPECT_THAT([&] { p.evaluate(t); }, refused("is not in [0, 1]"));
    EXPECT_THAT([&] { p.split(t); }, refused("is not in [0, 1]"));
    EXPECT_THAT([&] { p.restricted({t, 1}); }, refused("is not an interval in [0, 1]"));
  }
  EXPECT_THAT([&] { p.evaluate(-0.25); }, refused("parameter -0.25"));
  EXPECT_THAT([&] { p.restricted({0.5, 0.25}); }, refused("[0.5, 0.25]"));
  EXPECT_THAT([&] { p.elevated(-1); }, refused("elevation by -1"));
  EXPECT_THAT([&] { p.elevated(799); }, refused("degree 801"));
  EXPECT_THAT([&] { p.range(-1); }, refused("tolerance is -1"));
  EXPECT_THAT([&] { p.range(kNaN); }, refused("tolerance is nan"));
  EXPECT_THAT([&] { kInfinity* p; }, refused("factor is inf"));
}

}  // namespace
}  // namespace seamwright
