// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>
#include <seamwright/core/bernstein/tensor.hpp>
#include <vector>

#include "bernstein_test.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Dyadic;
using test::DyadicVector;
using test::Encloses;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

using Edge = BernsteinTensor::Edge;
/// One exact row for each row of coefficients.
using DyadicMatrix = std::vector<DyadicVector>;

constexpr double kUnit = 0x1p-52;

struct Known {
  BernsteinTensor stored;
  DyadicMatrix truth;
};

Known randomKnown(std::mt19937_64& random, int degree_u, int degree_v, double lower_power = -3,
                  double upper_power = 3) {
  const MatrixXd c = MatrixXd::NullaryExpr(
      degree_u + 1, degree_v + 1, [&] { return test::spread(random, lower_power, upper_power); });
  const double paddings[] = {0, 1e-15, 1e-12, 1e-3};
  const double padding = paddings[random() % 4] * std::pow(10, upper_power);
  DyadicMatrix truth;
  for (int i = 0; i <= degree_u; ++i) {
    truth.push_back(test::exact(c.row(i).transpose()));
    for (Dyadic& value : truth.back()) value = value + Dyadic(random() % 2 ? padding : -padding);
  }
  return {BernsteinTensor(c, padding), truth};
}

Known randomKnown(std::mt19937_64& random) {
  const int degree_u = static_cast<int>(random() % 5), degree_v = static_cast<int>(random() % 5);
  return randomKnown(random, degree_u, degree_v);
}

Dyadic value(const DyadicMatrix& c, const Dyadic& u, const Dyadic& v) {
  DyadicVector rows;
  for (const DyadicVector& row : c) rows.push_back(test::exactBernstein(row, v));
  return test::exactBernstein(rows, u);
}

DyadicMatrix partialU(const DyadicMatrix& c) {
  const std::size_t m = c.size() - 1;
  if (m == 0) return {DyadicVector(c[0].size(), 0.0)};
  DyadicMatrix result(m, c[0]);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < c[i].size(); ++j)
      result[i][j] = Dyadic(static_cast<double>(m)) * (c[i + 1][j] - c[i][j]);
  return result;
}

DyadicMatrix transposed(const DyadicMatrix& c) {
  DyadicMatrix result(c[0].size(), DyadicVector(c.size()));
  for (std::size_t i = 0; i < c.size(); ++i)
    for (std::size_t j = 0; j < c[i].size(); ++j) result[j][i] = c[i][j];
  return result;
}

constexpr double kGrid[] = {0, 0.1875, 0.5, 0.875, 1};

/// f encloses the exact function on a grid that holds the corners.
template <class Truth>
void expectValues(const BernsteinTensor& f, const Truth& truth) {
  for (const double u : kGrid)
    for (const double v : kGrid)
      EXPECT_THAT(f.evaluate(u, v), Encloses(truth(u, v))) << "at " << u << ", " << v;
}

double magnitude(const BernsteinTensor& f) {
  return f.coefficients().cwiseAbs().maxCoeff();
}

class BernsteinTensors : public test::InEachRoundingMode {};
INSTANTIATE_TEST_SUITE_P(Modes, BernsteinTensors, test::kRoundingModes, test::roundingModeName);

TEST_P(BernsteinTensors, Identity1PartitionOfUnity) {
  for (const int m : {0, 1, 5, 60})
    for (const int n : {0, 3, 30}) {
      const Interval one = BernsteinTensor(MatrixXd::Ones(m + 1, n + 1)).evaluate(0.3, 0.7);
      EXPECT_TRUE(one.contains(1));
      EXPECT_LE(one.width(), 2 * (3 * m + 3 * n + 3) * kUnit * (1 + 1e-12));
    }
}

TEST_P(BernsteinTensors, Identity2ProductsAndSums) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const Known f = randomKnown(random), g = randomKnown(random);
    const double factor = test::spread(random, -3, 3);
    const auto F = [&](double u, double v) { return value(f.truth, u, v); };
    const auto G = [&](double u, double v) { return value(g.truth, u, v); };
    expectValues(f.stored * g.stored, [&](double u, double v) { return F(u, v) * G(u, v); });
    expectValues(f.stored + g.stored, [&](double u, double v) { return F(u, v) + G(u, v); });
    expectValues(f.stored - g.stored, [&](double u, double v) { return F(u, v) - G(u, v); });
    expectValues(factor * f.stored, [&](double u, double v) { return Dyadic(factor) * F(u, v); });
  }
}

/// Each coefficient of a product, times the binomials it was divided by, against the exact sum.
TEST_P(BernsteinTensors, Identity2ProductsCoefficientByCoefficient) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const Known f = randomKnown(random), g = randomKnown(random);
    const BernsteinTensor product = f.stored * g.stored;
    const DyadicVector weights_u = test::exactBinomials(product.degreeU()),
                       weights_v = test::exactBinomials(product.degreeV());
    for (int k = 0; k <= product.degreeU(); ++k) {
      DyadicVector row(product.degreeV() + 1);
      for (int i = std::max(0, k - g.stored.degreeU()); i <= std::min(k, f.stored.degreeU()); ++i) {
        const DyadicVector part = test::exactProductTimesBinomials(f.truth[i], g.truth[k - i]);
        const Dyadic weight = test::exactBinomials(f.stored.degreeU())[i] *
                              test::exactBinomials(g.stored.degreeU())[k - i];
        for (std::size_t l = 0; l < row.size(); ++l) row[l] = row[l] + weight * part[l];
      }
      for (int l = 0; l <= product.degreeV(); ++l) {
        const Dyadic weight = weights_u[k] * weights_v[l];
        EXPECT_TRUE((Dyadic(product.coefficients()(k, l)) * weight - row[l]).abs() <=
                    Dyadic(product.padding()) * weight);
      }
    }
    const int rounded = (std::min(f.stored.degreeU(), g.stored.degreeU()) + 1) *
                            (std::min(f.stored.degreeV(), g.stored.degreeV()) + 1) +
                        8;
    EXPECT_LE(product.padding(),
              (f.stored.padding() * magnitude(g.stored) + g.stored.padding() * magnitude(f.stored) +
               f.stored.padding() * g.stored.padding() +
               rounded * kUnit * magnitude(f.stored) * magnitude(g.stored)) *
                      (1 + 1e-13) +
                  1e-300);
  }
}

TEST_P(BernsteinTensors, Identity3Leibniz) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const Known f = randomKnown(random), g = randomKnown(random);
    const BernsteinTensor zeros[] = {
        (f.stored * g.stored).partialU() -
            (f.stored.partialU() * g.stored + f.stored * g.stored.partialU()),
        (f.stored * g.stored).partialV() -
            (f.stored.partialV() * g.stored + f.stored * g.stored.partialV()),
        f.stored.partialU().partialV() - f.stored.partialV().partialU()};
    for (const BernsteinTensor& zero : zeros) EXPECT_LE(magnitude(zero), zero.padding());
    expectValues(f.stored.partialU(),
                 [&](double u, double v) { return value(partialU(f.truth), u, v); });
    expectValues(f.stored.partialV(), [&](double u, double v) {
      return value(transposed(partialU(transposed(f.truth))), u, v);
    });
  }
}

TEST_P(BernsteinTensors, Identity4ElevationChangesNothing) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 20; ++trial) {
    const Known f = randomKnown(random);
    const BernsteinTensor raised = f.stored.elevated(trial % 4, trial % 3);
    EXPECT_EQ(raised.degreeU(), f.stored.degreeU() + trial % 4);
    EXPECT_EQ(raised.degreeV(), f.stored.degreeV() + trial % 3);
    expectValues(raised, [&](double u, double v) { return value(f.truth, u, v); });
  }
}

TEST_P(BernsteinTensors, Identity5PiecesTakeTheValues) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 15; ++trial) {
    const Known f = randomKnown(random);
    for (const double t : {0.0, test::uniform(random, 0, 1), 0.5, 1.0}) {
      const Dyadic T = t, rest = Dyadic(1) - T;
      const auto [left, right] = f.stored.splitU(t);
      expectValues(left, [&](double u, double v) { return value(f.truth, Dyadic(u) * T, v); });
      expectValues(right,
                   [&](double u, double v) { return value(f.truth, T + rest * Dyadic(u), v); });
      const auto [lower, upper] = f.stored.splitV(t);
      expectValues(lower, [&](double u, double v) { return value(f.truth, u, Dyadic(v) * T); });
      expectValues(upper,
                   [&](double u, double v) { return value(f.truth, u, T + rest * Dyadic(v)); });
    }
    const double a = test::uniform(random, 0, 1), b = test::uniform(random, a, 1);
    const double c = test::uniform(random, 0, 1), d = test::uniform(random, c, 1);
    expectValues(f.stored.restricted({a, b}, {c, d}), [&](double u, double v) {
      return value(f.truth, Dyadic(a) + (Dyadic(b) - Dyadic(a)) * Dyadic(u),
                   Dyadic(c) + (Dyadic(d) - Dyadic(c)) * Dyadic(v));
    });
    expectValues(f.stored.restricted({b, b}, {0, 1}),
                 [&](double, double v) { return value(f.truth, b, v); });
  }
}

TEST_P(BernsteinTensors, Identity6RangesContainAllValues) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 40; ++trial) {
    const Known f = randomKnown(random);
    for (const double u : kGrid)
      for (const double v : kGrid) EXPECT_THAT(f.stored.range(), Encloses(value(f.truth, u, v)));
  }
}

TEST_P(BernsteinTensors, Identity7EdgesTakeTheValues) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 20; ++trial) {
    const Known f = randomKnown(random);
    for (const double t : kGrid) {
      EXPECT_THAT(f.stored.edge(Edge::U0).evaluate(t), Encloses(value(f.truth, 0, t)));
      EXPECT_THAT(f.stored.edge(Edge::U1).evaluate(t), Encloses(value(f.truth, 1, t)));
      EXPECT_THAT(f.stored.edge(Edge::V0).evaluate(t), Encloses(value(f.truth, t, 0)));
      EXPECT_THAT(f.stored.edge(Edge::V1).evaluate(t), Encloses(value(f.truth, t, 1)));
    }
  }
}

/// A parameter polynomial with exact coefficients that its padding allows.
struct KnownParameter {
  BernsteinPolynomial stored;
  DyadicVector truth;
};

KnownParameter randomParameter(std::mt19937_64& random, int degree, double lower = 0,
                               double upper = 1) {
  const VectorXd c =
      VectorXd::NullaryExpr(degree + 1, [&] { return test::uniform(random, lower, upper); });
  const double padding = random() % 2 ? 0 : 1e-9;
  DyadicVector truth = test::exact(c);
  for (Dyadic& value : truth) value = value + Dyadic(random() % 2 ? padding : -padding);
  return {BernsteinPolynomial(c, padding), truth};
}

void expectComposition(const Known& f, const KnownParameter& u, const KnownParameter& v) {
  const BernsteinPolynomial h = f.stored.composed(u.stored, v.stored);
  EXPECT_EQ(h.degree(),
            f.stored.degreeU() * u.stored.degree() + f.stored.degreeV() * v.stored.degree());
  for (const double t : kGrid)
    EXPECT_THAT(h.evaluate(t), Encloses(value(f.truth, test::exactBernstein(u.truth, t),
                                              test::exactBernstein(v.truth, t))))
        << "at " << t;
}

TEST_P(BernsteinTensors, Identity8CompositionEqualsEvaluation) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 25; ++trial) {
    const Known f = randomKnown(random);
    const auto degree = [&] { return static_cast<int>(random() % 4); };
    expectComposition(f, randomParameter(random, degree()), randomParameter(random, degree()));
    expectComposition(f, randomParameter(random, degree(), -1, 2),
                      randomParameter(random, degree(), 0.9, 1.5));
  }
}

TEST_P(BernsteinTensors, Identity8CompositionWithLinesIsRestriction) {
  std::mt19937_64 random(testSeed());
  const Known f = randomKnown(random, 3, 4);
  const BernsteinPolynomial from(Eigen::Vector2d(0, 1)), zero(VectorXd::Zero(1));
  const BernsteinPolynomial difference = f.stored.composed(from, zero) - f.stored.edge(Edge::V0);
  EXPECT_LE(difference.coefficients().cwiseAbs().maxCoeff(), difference.padding());
}

/// With parameters in [0, 1] paddings add up: bi-degree 12 would otherwise multiply them by 2^24.
TEST(BernsteinTensor, CompositionDoesNotMultiplyPaddings) {
  std::mt19937_64 random(testSeed());
  const MatrixXd c = MatrixXd::NullaryExpr(13, 13, [&] { return test::uniform(random, -1, 1); });
  const BernsteinPolynomial u(Eigen::Vector4d(0, 0.2, 0.9, 1)), v(Eigen::Vector4d(0.3, 1, 0, 0.5));
  EXPECT_LT(BernsteinTensor(c).composed(u, v).padding(), 1e-12);
  EXPECT_LT(BernsteinTensor(c, 1e-6).composed(u, v).padding(), 1.001e-6);
}

/// (u - 1/3)^2 + (v - 1/3)^2 as in one variable: the excess over the minimum 0 is 4/9 4^-level.
TEST(BernsteinTensor, Identity6ExcessShrinksByFourWhenBothSidesAreHalved) {
  const Eigen::Vector3d square(1.0 / 9, -2.0 / 9, 4.0 / 9);
  BernsteinTensor f(square.replicate(1, 3) + square.transpose().replicate(3, 1));
  double excess = -f.range().lower;
  for (int level = 1; level <= 8; ++level) {
    std::vector<BernsteinTensor> quarters;
    for (const auto& half : {f.splitU(0.5).first, f.splitU(0.5).second})
      for (const auto& quarter : {half.splitV(0.5).first, half.splitV(0.5).second})
        quarters.push_back(quarter);
    f = *std::min_element(quarters.begin(), quarters.end(), [](const auto& a, const auto& b) {
      return a.range().lower < b.range().lower;
    });
    EXPECT_NEAR(excess / -f.range().lower, 4, 1e-8) << "level " << level;
    excess = -f.range().lower;
  }
}

TEST_P(BernsteinTensors, SizesAtTheRimOfADouble) {
  std::mt19937_64 random(testSeed());
  for (int trial = 0; trial < 5; ++trial) {
    const Known huge = randomKnown(random, 2, 3, 290, 300),
                tiny = randomKnown(random, 3, 2, -307, -300),
                denormal = randomKnown(random, 2, 2, -323, -305);
    for (const Known* f : {&huge, &tiny, &denormal}) {
      expectValues(f->stored * tiny.stored, [&](double u, double v) {
        return value(f->truth, u, v) * value(tiny.truth, u, v);
      });
      expectValues(f->stored.splitV(0.3).first,
                   [&](double u, double v) { return value(f->truth, u, Dyadic(v) * Dyadic(0.3)); });
      expectComposition(*f, randomParameter(random, 2), randomParameter(random, 1));
    }
    EXPECT_THAT([&] { huge.stored* huge.stored; },
                ThrowsMessage<std::overflow_error>(HasSubstr("product: coefficient (")));
  }
}

TEST_P(BernsteinTensors, HighDegreesAreEnclosed) {
  std::mt19937_64 random(testSeed());
  const Known f = randomKnown(random, 60, 2), g = randomKnown(random, 3, 1);
  const BernsteinTensor product = f.stored * g.stored;
  for (const double u : kGrid) {
    EXPECT_THAT(f.stored.evaluate(u, 0.5), Encloses(value(f.truth, u, 0.5)));
    EXPECT_THAT(product.evaluate(u, 0.5),
                Encloses(value(f.truth, u, 0.5) * value(g.truth, u, 0.5)));
  }
}

TEST(BernsteinTensor, BadInputIsRefusedWithItsNumbers) {
  const auto refused = [](const std::string& words) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(words));
  };
  MatrixXd c = MatrixXd::Ones(3, 2);
  const BernsteinTensor f(c);
  c(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { (void)BernsteinTensor(c); }, refused("coefficient (2, 1) is nan"));
  EXPECT_THAT([&] { BernsteinTensor(MatrixXd(0, 0)); }, refused("no coefficients"));
  EXPECT_THAT([&] { BernsteinTensor(MatrixXd::Ones(2, 2), -1); }, refused("padding is -1"));
  EXPECT_THAT([&] { f.evaluate(1.5, 0); }, refused("parameter 1.5"));
  EXPECT_THAT([&] { f.evaluate(0, -1); }, refused("parameter -1"));
  EXPECT_THAT([&] { f.splitU(2); }, refused("parameter 2"));
  EXPECT_THAT([&] { f.splitV(-2); }, refused("parameter -2"));
  EXPECT_THAT([&] { f.restricted({0, 1}, {0, 1.25}); }, refused("[0, 1.25]"));
  EXPECT_THAT([&] { f.elevated(0, -3); }, refused("elevation by 0, -3"));
  EXPECT_THAT([&] { f.elevated(400, 400); }, refused("degree 803"));
}

}  // namespace
}  // namespace seamwright
