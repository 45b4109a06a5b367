// SPDX-License-Identifier: LGPL-2.1-or-later
// Models against the functions they stand for, evaluated in long double (2^-64).
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <seamwright/core/enclosure/chebyshev_model.hpp>
#include <seamwright/core/enclosure/vector_model.hpp>
#include <vector>

#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using test::logUniform;
using Real = long double;
using Function = std::function<Real(Real)>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Real u64 = 0x1p-60L;  // what long double may be off by in a few dozen operations

/// The series by T_k(x) = cos(k acos x), not by Clenshaw's recurrence.
Real seriesAt(const ChebyshevModel& model, Real x) {
  Real sum = 0;
  for (int k = 0; k <= model.degree(); ++k)
    sum += model.coefficient(k) * std::cos(k * std::acos(x));
  return sum;
}

Real size(const ChebyshevModel& model) {
  Real sum = 0;
  for (int k = 0; k <= model.degree(); ++k)
    sum += std::abs(static_cast<Real>(model.coefficient(k)));
  return sum;
}

/// A function and a model that holds it.
struct Sample {
  ChebyshevModel model;
  Function function;
};

std::vector<Real> places() {
  std::vector<Real> x;
  for (int i = 0; i <= 40; ++i) x.push_back(-1 + i / 20.0L);
  return x;
}

testing::AssertionResult holds(const Sample& sample, Real noise = 0) {
  for (const Real x : places()) {
    const Real truth = sample.function(x);
    const Real off = std::abs(seriesAt(sample.model, x) - truth);
    const Real may = sample.model.radius() + u64 * size(sample.model) + noise;
    if (std::isfinite(sample.model.radius()) && !(off <= may))
      return testing::AssertionFailure()
             << "at " << static_cast<double>(x) << " the function is " << static_cast<double>(truth)
             << ", " << static_cast<double>(off) << " from its model of radius "
             << sample.model.radius();
    const Interval range = sample.model.range();
    const Real noisy = noise + u64 * std::abs(truth);
    if (sample.model.isKnown() && !(range.lower - noisy <= truth && truth <= range.upper + noisy))
      return testing::AssertionFailure()
             << "the value " << static_cast<double>(truth) << " is outside [" << range.lower << ", "
             << range.upper << "]";
    if (sample.model.isKnown() && !(std::abs(truth) <= sample.model.magnitude() + noisy))
      return testing::AssertionFailure()
             << "the value " << static_cast<double>(truth) << " is above the "
             << "magnitude " << sample.model.magnitude();
  }
  return testing::AssertionSuccess();
}

class Models {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double sized(double exponent_low, double exponent_high) {
    return uniform(-1, 1) * logUniform(random_, exponent_low, exponent_high);
  }
  /// A random series and, within the radius, a wave on it.
  Sample sample(double exponent_low, double exponent_high) {
    const int degree = static_cast<int>(random_() % ChebyshevModel::size);
    std::vector<double> coefficients;
    for (int k = 0; k <= degree; ++k) coefficients.push_back(sized(exponent_low, exponent_high));
    return withWave(coefficients);
  }
  /// A constant and a variation that is smaller by up to 18 orders.
  Sample nearlyConstant(double constant) {
    std::vector<double> coefficients = {constant};
    for (int k = 1; k <= 5; ++k) coefficients.push_back(constant * sized(-18, -0.8));
    return withWave(coefficients);
  }

 private:
  Sample withWave(const std::vector<double>& coefficients) {
    Real total = 0;
    for (const double c : coefficients) total += std::abs(c);
    const double radius =
        random_() % 2 == 0 ? 0 : static_cast<double>(total) * logUniform(random_, -18, -2);
    const double frequency = uniform(0, 30), phase = uniform(0, 6);
    const Function function = [=](Real x) {
      Real sum = radius * (1 - 1e-15L) * std::cos(frequency * x + phase);
      for (std::size_t k = 0; k < coefficients.size(); ++k)
        sum += coefficients[k] * std::cos(static_cast<Real>(k) * std::acos(x));
      return sum;
    };
    return {ChebyshevModel::series(coefficients, radius), function};
  }

  std::mt19937_64 random_{testSeed()};
};

Real scaleOf(const Sample& a) {
  return size(a.model) + a.model.radius();
}

TEST(ChebyshevModel, Identity1SumsAndProducts) {
  Models models;
  for (int i = 0; i < 400; ++i) {
    const double wide = i % 3 == 0 ? 150 : i % 3 == 1 ? 9 : 1;
    const Sample a = models.sample(-wide, wide), b = models.sample(-wide, wide),
                 c = models.sample(-1, 1);
    const double factor = models.sized(-9, 9);
    const Real ab = scaleOf(a) + scaleOf(b);
    const auto &f = a.function, &g = b.function, &h = c.function;
    EXPECT_TRUE(holds({a.model + b.model, [=](Real x) { return f(x) + g(x); }}, u64 * ab)) << i;
    EXPECT_TRUE(holds({a.model - b.model, [=](Real x) { return f(x) - g(x); }}, u64 * ab)) << i;
    EXPECT_TRUE(holds({-a.model, [=](Real x) { return -f(x); }}, u64 * ab)) << i;
    EXPECT_TRUE(holds({factor * a.model, [=](Real x) { return factor * f(x); }},
                      u64 * std::abs(factor) * ab))
        << i;
    EXPECT_TRUE(holds({a.model * b.model, [=](Real x) { return f(x) * g(x); }},
                      u64 * scaleOf(a) * scaleOf(b)))
        << i;
    const ChebyshevModel sum = ProductSum()
                                   .add(a.model, b.model)
                                   .add(b.model, c.model, -1)
                                   .add(c.model, c.model, 0.5)
                                   .model();
    EXPECT_TRUE(holds({sum, [=](Real x) { return f(x) * g(x) - g(x) * h(x) + h(x) * h(x) / 2; }},
                      u64 * (ab + scaleOf(c)) * (ab + scaleOf(c))))
        << i;
  }
}

TEST(ChebyshevModel, Identity1AFactorOfAProductWidensBothErrors) {
  const std::vector<double> three = {3}, two = {2};
  const auto exact = ChebyshevModel::series(three, 0), wide = ChebyshevModel::series(two, 0.5);
  for (const double factor : {-2.0, -0.5, 1.0, 2.0, 10.0}) {
    for (const bool swapped : {false, true}) {
      const ChebyshevModel& a = swapped ? exact : wide;
      const ChebyshevModel& b = swapped ? wide : exact;
      const Interval range = ProductSum().add(a, b, factor).model().range();
      const auto [low, high] = std::minmax({factor * 3 * 1.5, factor * 3 * 2.5});
      EXPECT_LE(range.lower, low) << factor << ' ' << swapped;
      EXPECT_GE(range.upper, high) << factor << ' ' << swapped;
      EXPECT_LE(range.width(), (high - low) * (1 + 1e-12)) << factor << ' ' << swapped;
    }
  }
}

TEST(ChebyshevModel, Identity1LongSumsOfProductsThatCancel) {
  Models models;
  for (int i = 0; i < 300; ++i) {
    std::array<Sample, 3> a, b;
    Real all = 0;
    for (int k = 0; k < 3; ++k) {
      a[k] = models.sample(-2, 2), b[k] = models.sample(-2, 2);
      all += scaleOf(a[k]) * scaleOf(b[k]);
    }
    ProductSum sum;
    for (int k = 0; k < 3; ++k) sum.add(a[k].model, b[k].model);
    for (int k = 0; k < 3; ++k) sum.add(b[k].model, a[k].model, -1);
    EXPECT_TRUE(holds({sum.model(), [](Real) { return 0; }}, u64 * all)) << i;
  }
}

TEST(ChebyshevModel, Identity1Inverses) {
  Models models;
  int known = 0;
  for (int i = 0; i < 1500; ++i) {
    const double size = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, models.uniform(-100, 100));
    const Sample a = i % 3 == 0 ? models.sample(-3, 3) : models.nearlyConstant(size);
    const auto& f = a.function;
    const ChebyshevModel inverted = inverse(a.model);
    known += inverted.isKnown();
    if (inverted.isKnown()) {
      const Real lowest =
          a.model.range().lower > 0 ? a.model.range().lower : -a.model.range().upper;
      EXPECT_GT(lowest, 0);
      EXPECT_TRUE(
          holds({inverted, [=](Real x) { return 1 / f(x); }}, u64 * scaleOf(a) / (lowest * lowest)))
          << i;
    }
    const ChebyshevModel root = inverseSqrt(a.model);
    if (root.isKnown()) {
      const Real lowest = a.model.range().lower;
      EXPECT_GT(lowest, 0);
      EXPECT_TRUE(holds({root, [=](Real x) { return 1 / std::sqrt(f(x)); }},
                        u64 * scaleOf(a) / (lowest * std::sqrt(lowest))))
          << i;
    }
  }
  EXPECT_GT(known, 800);
}

TEST(ChebyshevModel, Identity1InversesOfFunctionsThatNearlyVanish) {
  for (const int power : {1, 2, 4}) {
    for (double least = 1; least > 1e-14; least /= 7) {
      // least + (x - 1)^power, as a product, least at x = 1.
      ChebyshevModel f(1);
      for (int k = 0; k < power; ++k) f = f * ChebyshevModel::linear(1, -1, 0);
      f += ChebyshevModel(least);
      const auto function = [=](Real x) {
        return least + std::pow(1 - x, static_cast<Real>(power));
      };
      EXPECT_TRUE(
          holds({inverse(f), [=](Real x) { return 1 / function(x); }}, 1e-15L / (least * least)));
      EXPECT_TRUE(holds({inverseSqrt(f), [=](Real x) { return 1 / std::sqrt(function(x)); }},
                        1e-15L / (least * least)));
    }
  }
}

TEST(ChebyshevModel, InversesOfFunctionsThatMayVanishAreUnknown) {
  for (const ChebyshevModel& f :
       {ChebyshevModel::linear(0, 1, 0), ChebyshevModel::linear(1, 1, 0),
        ChebyshevModel::linear(1, 0, 1), ChebyshevModel(0), ChebyshevModel(infinite),
        ChebyshevModel(nan), ChebyshevModel::unknown()}) {
    EXPECT_FALSE(inverse(f).isKnown());
    EXPECT_FALSE(inverseSqrt(f).isKnown());
  }
  EXPECT_FALSE(inverseSqrt(ChebyshevModel(-1)).isKnown());
  EXPECT_TRUE(inverse(ChebyshevModel(-1)).isKnown());
}

TEST(ChebyshevModel, Identity1CosineAndSine) {
  Models models;
  for (int i = 0; i < 1000; ++i) {
    Sample a = models.sample(-3, 0);
    const double middle = models.sized(-3, 6);
    a.model += ChebyshevModel(middle);
    const Function f = [g = a.function, middle](Real x) { return g(x) + middle; };
    const auto [cosine, sine] = cosSin(a.model);
    const Real noise = u64 * (std::abs(middle) + 1);
    EXPECT_TRUE(holds({cosine, [=](Real x) { return std::cos(f(x)); }}, noise)) << i;
    EXPECT_TRUE(holds({sine, [=](Real x) { return std::sin(f(x)); }}, noise)) << i;
  }
  EXPECT_FALSE(cosSin(ChebyshevModel::linear(0, 2.1, 0)).first.isKnown());
  EXPECT_FALSE(cosSin(ChebyshevModel::linear(0, 0, infinite)).second.isKnown());
  EXPECT_TRUE(cosSin(ChebyshevModel::linear(0, 1.9, 0)).first.isKnown());
}

TEST(ChebyshevModel, Identity1HyperbolicCosineAndSine) {
  Models models;
  int known = 0;
  for (int i = 0; i < 500; ++i) {
    Sample a = models.sample(-3, 0);
    const double middle = models.sized(-3, 1.3);
    a.model += ChebyshevModel(middle);
    const Function f = [g = a.function, middle](Real x) { return g(x) + middle; };
    const auto [cosine, sine] = coshSinh(a.model);
    known += cosine.isKnown();
    const Real noise = 64 * u64 * std::cosh(std::abs(static_cast<Real>(middle)) + scaleOf(a));
    EXPECT_TRUE(holds({cosine, [=](Real x) { return std::cosh(f(x)); }}, noise)) << i;
    EXPECT_TRUE(holds({sine, [=](Real x) { return std::sinh(f(x)); }}, noise)) << i;
  }
  EXPECT_GT(known, 200);
  EXPECT_FALSE(coshSinh(ChebyshevModel::unknown()).first.isKnown());
}

TEST(ChebyshevModel, Identity1DenormalsAndTheEdgeOfTheRange) {
  for (const double tiny : {5e-324, 1e-310, 2.3e-308}) {
    const ChebyshevModel a = ChebyshevModel::linear(3 * tiny, tiny, 0);
    const auto f = [=](Real x) { return 3 * static_cast<Real>(tiny) + tiny * x; };
    EXPECT_TRUE(holds({a * a, [=](Real x) { return f(x) * f(x); }}));
    EXPECT_TRUE(holds({0.3 * a, [=](Real x) { return 0.3 * f(x); }}));
    const ChebyshevModel inverted = inverse(a);
    if (inverted.isKnown()) {
      EXPECT_TRUE(holds({inverted, [=](Real x) { return 1 / f(x); }}, 1e-10L / tiny));
    }
  }
  const ChebyshevModel huge = ChebyshevModel::linear(1e308, 1e307, 0);
  EXPECT_FALSE((huge + huge).isKnown());
  EXPECT_FALSE((huge * huge).isKnown());
  EXPECT_TRUE(holds({inverse(ChebyshevModel::linear(1e300, 1e299, 0)),
                     [](Real x) { return 1 / (1e300L + 1e299L * x); }},
                    1e-316L));
}

TEST(ChebyshevModel, Identity2TheExcessOfTheRangeFallsWithTheSquareOfTheLength) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const double middle = std::uniform_real_distribution<double>(-3, 3)(random);
    for (double half = 0.5; half > 1e-3; half /= 2) {
      const Interval range = cosSin(ChebyshevModel::linear(middle, half, 0)).first.range();
      Real low = 1, high = -1;
      for (int k = 0; k <= 400; ++k) {
        const Real value = std::cos(static_cast<Real>(middle) + half * (k / 200.0L - 1));
        low = std::min(low, value), high = std::max(high, value);
      }
      EXPECT_LE(range.lower, low);
      EXPECT_GE(range.upper, high);
      const Real excess = std::max(range.upper - high, low - range.lower);
      EXPECT_LE(excess, half * half / 2 + 1e-12) << "middle " << middle << " half " << half;
    }
  }
}

TEST(ChebyshevModel, Identity3HalvingDividesTheRadiusBy2ToThe8) {
  std::mt19937_64 random(testSeed());
  const auto check = [&](const auto& operation, double first) {
    int checked = 0;
    for (int i = 0; i < 100; ++i) {
      const double middle = std::uniform_real_distribution<double>(1, 2)(random);
      double before = operation(ChebyshevModel::linear(middle, first, 0)).radius();
      for (const double part : {2, 4}) {
        const ChebyshevModel model = operation(ChebyshevModel::linear(middle, first / part, 0));
        const double radius = model.radius();
        if (radius < 8 * ChebyshevModel::negligible * model.magnitude())
          break;  // of terms left out
        EXPECT_GT(before / radius, 0x1p6);
        EXPECT_LT(before / radius, 0x1p12);
        before = radius;
        ++checked;
      }
    }
    EXPECT_GE(checked, 20);
  };
  check([](const ChebyshevModel& x) { return inverse(x); }, 0.8);
  check([](const ChebyshevModel& x) { return inverseSqrt(x); }, 0.8);
  check([](const ChebyshevModel& x) { return cosSin(x).first; }, 1.95);
  check([](const ChebyshevModel& x) { return x * x * x * x * x * x * x * x * x; }, 2);
}

TEST(ChebyshevModel, NothingKnownStaysUnknown) {
  const ChebyshevModel unknown = ChebyshevModel::unknown();
  const ChebyshevModel around_zero = ChebyshevModel::linear(0, 0, 1e-3);
  const ChebyshevModel one(1), zero(0);
  EXPECT_FALSE(unknown.isKnown());
  for (const ChebyshevModel& model :
       {unknown + one, one - unknown, -unknown, 2 * unknown, unknown * one, one * unknown,
        unknown * unknown, around_zero * unknown, unknown * around_zero, inverse(unknown),
        inverseSqrt(unknown), cosSin(unknown).first, cosSin(unknown).second}) {
    EXPECT_FALSE(model.isKnown());
    EXPECT_FALSE((model * ChebyshevModel(3)).isKnown());
    EXPECT_FALSE((ChebyshevModel::linear(3, 1, 0) * model).isKnown());
    EXPECT_FALSE((model * model + one).isKnown());
    EXPECT_FALSE(ProductSum().add(one, model).add(one, one).model().isKnown());
    EXPECT_FALSE(ProductSum().add(model, one).add(one, one, -1).model().isKnown());
    EXPECT_FALSE(inverse(model).isKnown());
  }
}

TEST(ChebyshevModel, WhatIsNotFiniteIsNotKnown) {
  for (const double bad : {nan, infinite, -infinite}) {
    EXPECT_FALSE(ChebyshevModel(bad).isKnown());
    EXPECT_FALSE(ChebyshevModel::linear(1, bad, 0).isKnown());
    EXPECT_FALSE(ChebyshevModel::linear(1, 1, std::abs(bad)).isKnown());
    std::vector<double> coefficients(12, 1.0);
    for (const int k : {0, 3, 7, 8, 11}) {
      std::vector<double> with = coefficients;
      with[k] = bad;
      EXPECT_FALSE(ChebyshevModel::series(with, 0).isKnown()) << bad << " at " << k;
      EXPECT_FALSE((ChebyshevModel::series(with, 0) * ChebyshevModel::linear(2, 1, 0)).isKnown())
          << k;
      EXPECT_FALSE((ChebyshevModel::series(with, 0) + ChebyshevModel(1)).isKnown()) << k;
      EXPECT_FALSE((ChebyshevModel::series(with, 0) - ChebyshevModel::series(with, 0)).isKnown())
          << k;
    }
    ChebyshevModel widened(1);
    widened.widen(std::abs(bad));
    EXPECT_FALSE(widened.isKnown());
    EXPECT_FALSE((widened * ChebyshevModel(1)).isKnown());
  }
}

TEST(ChebyshevModel, TermsBeyondTheDegreeAreInTheRadius) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    std::vector<double> coefficients(1 + random() % 26);
    for (double& c : coefficients)
      c = std::normal_distribution<double>()(random) * logUniform(random, -12, 2);
    Real total = 0;
    for (const double c : coefficients) total += std::abs(c);
    const auto function = [=](Real x) {
      Real sum = 0;
      for (std::size_t k = 0; k < coefficients.size(); ++k)
        sum += coefficients[k] * std::cos(static_cast<Real>(k) * std::acos(x));
      return sum;
    };
    EXPECT_TRUE(holds({ChebyshevModel::series(coefficients, 0), function}, u64 * total)) << i;
  }
  EXPECT_GE(ChebyshevModel::series({}, 0.5).magnitude(), 0.5);
}

TEST(ChebyshevModel, TheBernsteinFormIsTheSeries) {
  Models models;
  for (int i = 0; i < 300; ++i) {
    const Sample a = models.sample(-6, 6);
    for (int degree = a.model.degree(); degree <= ChebyshevModel::max_degree; ++degree) {
      const ChebyshevModel::Coefficients control = a.model.bernstein(degree);
      for (const Real x : places()) {
        std::vector<Real> level(control.begin(), control.begin() + degree + 1);
        for (int left = degree; left > 0; --left)
          for (int k = 0; k < left; ++k)
            level[k] = (1 - x) / 2 * level[k] + (1 + x) / 2 * level[k + 1];
        EXPECT_NEAR(static_cast<double>(level[0] - seriesAt(a.model, x)), 0,
                    a.model.bernsteinRounding() + static_cast<double>(u64 * 128 * size(a.model)));
      }
    }
  }
}

TEST(ControlPolygon, HoldsTheVector) {
  Models models;
  for (int i = 0; i < 200; ++i) {
    const std::array<Sample, 3> a = {models.sample(-3, 3), models.sample(-3, 3),
                                     models.sample(-3, 3)};
    const auto polygon = controlPolygon(VectorModel{a[0].model, a[1].model, a[2].model});
    for (const Real x : places()) {
      Eigen::Matrix<Real, 3, 1> curve = Eigen::Matrix<Real, 3, 1>::Zero(), truth;
      Real choose = 1;
      for (int k = 0; k <= polygon.degree; ++k) {
        const Real b = choose * std::pow((1 + x) / 2, static_cast<Real>(k)) *
                       std::pow((1 - x) / 2, static_cast<Real>(polygon.degree - k));
        curve += b * polygon.points[k].cast<Real>();
        choose = choose * (polygon.degree - k) / (k + 1);
      }
      for (int d = 0; d < 3; ++d) truth[d] = a[d].function(x);
      const Real noise = u64 * 128 * (scaleOf(a[0]) + scaleOf(a[1]) + scaleOf(a[2]));
      EXPECT_LE((curve - truth).norm(), polygon.radius + noise) << i;
    }
  }
}

}  // namespace
}  // namespace seamwright
