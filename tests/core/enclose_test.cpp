// SPDX-License-Identifier: LGPL-2.1-or-later
// Enclosures against measurePair(), closed forms, and seams made to hide something.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/seam/judge.hpp>

#include "seam_sides.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using test::choose;
using test::linePath;
using test::logUniform;
using test::PatchSide;
using test::Vec;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Largest values of measurePair() at evenly spaced points and both ends.
struct Dense {
  double gap_mm = 0, angle_rad = 0, curvature_per_mm = 0, curvature_rel = 0, norm_per_mm = 0;
  bool fold = false;
};

Dense dense(const PatchSide& a, const PatchSide& b, const ContinuityTolerance& tolerance,
            int points) {
  Dense most;
  for (int i = 0; i < points; ++i) {
    const double s = static_cast<double>(i) / (points - 1);
    const PairMeasure pair = measurePair(a.at(s), b.at(s));
    most.gap_mm = std::max(most.gap_mm, *pair.gap_mm);
    if (!pair.angle_rad) continue;
    most.angle_rad = std::max(most.angle_rad, *pair.angle_rad);
    most.fold |= pair.fold;
    most.curvature_per_mm = std::max(most.curvature_per_mm, pair.curvature->difference_per_mm);
    most.norm_per_mm =
        std::max({most.norm_per_mm, pair.curvature->norm_a_per_mm, pair.curvature->norm_b_per_mm});
    most.curvature_rel =
        std::max(most.curvature_rel, relativeDifference(*pair.curvature, tolerance.flat_radius_mm));
  }
  return most;
}

/// No value seen is above the upper bound, and the lower bound is a value of its place, but for
/// noise.
void expectTrue(const std::optional<Figure>& figure, double seen, double there, double noise,
                const char* quantity) {
  if (!figure) return;
  if (figure->upper) {
    EXPECT_GE(*figure->upper, seen - noise) << quantity;
    EXPECT_GE(*figure->upper, figure->lower) << quantity;
  }
  EXPECT_LE(figure->lower, there * (1 + 1e-9) + noise) << quantity << " at " << figure->at;
  EXPECT_TRUE(std::isfinite(figure->lower)) << quantity;
}

void expectTrue(const SeamFigures& figures, const PatchSide& a, const PatchSide& b,
                const ContinuityTolerance& tolerance, int points) {
  const Dense seen = dense(a, b, tolerance, points);
  const auto at = [&](const std::optional<Figure>& figure) {
    return measurePair(a.at(figure->at), b.at(figure->at));
  };
  constexpr double noise = 1e-12;
  expectTrue(figures.gap_mm, seen.gap_mm, *at(figures.gap_mm).gap_mm, noise, "gap");
  if (!figures.angle_rad) return;
  expectTrue(figures.angle_rad, seen.angle_rad, at(figures.angle_rad).angle_rad.value_or(infinite),
             noise, "angle");
  if (!figures.curvature_per_mm) return;
  const auto difference = [&](const PairMeasure& pair) {
    if (pair.curvature) return pair.curvature->difference_per_mm;
    return infinite;
  };
  const auto relative = [&](const PairMeasure& pair) {
    return pair.curvature ? relativeDifference(*pair.curvature, tolerance.flat_radius_mm)
                          : infinite;
  };
  const double curvature_noise = 1e-11 * (1 + seen.norm_per_mm);
  expectTrue(figures.curvature_per_mm, seen.curvature_per_mm,
             difference(at(figures.curvature_per_mm)), curvature_noise, "curvature");
  expectTrue(figures.curvature_rel, seen.curvature_rel, relative(at(figures.curvature_rel)),
             1e-10 + curvature_noise / std::max(seen.norm_per_mm, 1e-300), "relative curvature");
}

/// upper - lower <= max(1 % of the figure, a hundredth of the tolerance), but for what rounding
/// adds.
void expectNarrow(const SeamFigures& figures, const ContinuityTolerance& tolerance,
                  double norm_per_mm) {
  ASSERT_TRUE(figures.certified) << figures.uncertified;
  const auto narrow = [](const Figure& figure, double tolerated, double rounding,
                         const char* quantity) {
    EXPECT_LE(*figure.upper - figure.lower, 0.01 * std::max(figure.lower, tolerated) + rounding)
        << quantity;
  };
  narrow(*figures.gap_mm, tolerance.gap_mm, 1e-9, "gap");
  narrow(*figures.angle_rad, tolerance.angle_rad, 1e-9, "angle");
  if (!figures.curvature_per_mm) return;
  narrow(*figures.curvature_per_mm, tolerance.curvature_rel * norm_per_mm, 1e-8, "curvature");
  narrow(*figures.curvature_rel, tolerance.curvature_rel, 1e-8, "relative curvature");
}

/// A patch over about [0, 10]^2, rows in u.
BezierPatch randomPatch(int m, int n, double roughness, bool rational, std::mt19937_64& random) {
  Poles poles((m + 1) * (n + 1), 3);
  Eigen::VectorXd weights(poles.rows());
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const Vec grid(10.0 * i / m, 10.0 * j / n, 0);
      poles.row(i * (n + 1) + j) = (grid + roughness * test::randomVector(random)).transpose();
      weights(i * (n + 1) + j) =
          rational ? std::uniform_real_distribution<double>(0.5, 2)(random) : 1;
    }
  return {m, n, poles, weights};
}

/// The patch with every pole moved at random.
BezierPatch shaken(const BezierPatch& patch, double by, int first_row, std::mt19937_64& random) {
  Poles poles = patch.poles();
  for (Eigen::Index i = static_cast<Eigen::Index>(first_row) * (patch.degreeV() + 1);
       i < poles.rows(); ++i)
    poles.row(i) += by * test::randomVector(random).transpose();
  return {patch.degreeU(), patch.degreeV(), poles, patch.weights()};
}

PatchSide endOf(const BezierPatch& patch) {
  return {patch, linePath(1, 0, 1, 1), true};
}
PatchSide beginOf(const BezierPatch& patch) {
  return {patch, linePath(0, 0, 0, 1), false};
}

BezierCurve randomPath(bool rational, std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(0.15, 0.85);
  Poles poles(4, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(4);
  for (int i = 0; i < 4; ++i) {
    poles.row(i) << place(random), 0.1 + 0.25 * i, 0;
    if (rational) weights(i) = std::uniform_real_distribution<double>(0.4, 2.5)(random);
  }
  return {poles, weights};
}

/// Sides of every kind: same path in a patch and one nearly like it.
std::pair<PatchSide, PatchSide> randomSeam(std::mt19937_64& random) {
  const bool rational = random() % 3 == 0;
  const int m = 1 + static_cast<int>(random() % 4), n = 1 + static_cast<int>(random() % 4);
  const double defect = random() % 8 == 0 ? 0 : logUniform(random, -9, -0.5);
  const BezierPatch patch = randomPatch(m, n, logUniform(random, -3, 0), rational, random);
  switch (random() % 3) {
    case 0: {  // trimmed, both on nearly the same surface
      const BezierCurve path = randomPath(random() % 2 == 0, random);
      return {{patch, path, true}, {shaken(patch, defect, 0, random), path, false}};
    }
    case 1: {  // untrimmed, a defect in the cross rows
      const auto [left, right] = patch.splitU(0.5);
      return {endOf(left), beginOf(shaken(right, defect, 1, random))};
    }
    default: {  // one trimmed by the edge of the other: transposed parametrisation
      const BezierPatch other = shaken(patch, defect, 0, random).transposed();
      const double u = std::uniform_real_distribution<double>(0.2, 0.8)(random);
      return {{patch, linePath(u, 0, u, 1), true}, {other, linePath(0, u, 1, u), true}};
    }
  }
}

/// The second side has a boundary that is one point, but for a scatter of its poles, at the begin
/// of the seam.
std::pair<PatchSide, PatchSide> scatteredSeam(std::mt19937_64& random) {
  const int n = 1 + static_cast<int>(random() % 3);
  const BezierPatch patch = randomPatch(2, n, logUniform(random, -3, 0), false, random);
  const auto [left, right] = patch.splitU(0.5);
  const double scatter = logUniform(random, -13, -5);
  Poles poles = right.poles();
  for (Eigen::Index i = 1; i < 3; ++i)
    poles.row(i * (n + 1)) = poles.row(0) + scatter * test::randomVector(random).transpose();
  return {endOf(left), beginOf({2, n, poles, right.weights()})};
}

ContinuityTolerance randomTolerance(std::mt19937_64& random) {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = logUniform(random, -5, -1);
  tolerance.angle_rad = logUniform(random, -5, -1.2);
  tolerance.curvature_rel = logUniform(random, -3, -0.5);
  tolerance.flat_radius_mm = logUniform(random, 2, 6);
  tolerance.crease_rad = std::max(tolerance.angle_rad, logUniform(random, -1, 0));
  return tolerance;
}

TEST(EncloseSeam, Identity1NoValueIsOutsideTheBounds) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 600; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = randomSeam(random);
    const ContinuityTolerance tolerance = randomTolerance(random);
    const SeamFigures figures = encloseSeam(a.seamSide(), b.seamSide(), tolerance);
    expectTrue(figures, a, b, tolerance, 201);
    if (HasFailure()) break;
  }
}

TEST(EncloseSeam, Identity1NoValueOf20001IsOutsideTheBounds) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 15; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = randomSeam(random);
    const ContinuityTolerance tolerance = randomTolerance(random);
    expectTrue(encloseSeam(a.seamSide(), b.seamSide(), tolerance), a, b, tolerance, 20001);
  }
}

TEST(EncloseSeam, TheBoundsAreAsNarrowAsPromised) {
  std::mt19937_64 random(testSeed());
  ContinuityTolerance tolerance;
  tolerance.crease_rad = 1.5;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = randomSeam(random);
    const Dense seen = dense(a, b, tolerance, 41);
    if (seen.angle_rad > 1) continue;
    tolerance.flat_radius_mm = 1e3 / std::max(seen.norm_per_mm, 1e-6);  // far from the flat radius
    expectNarrow(encloseSeam(a.seamSide(), b.seamSide(), tolerance, {.max_pieces = 100000}),
                 tolerance, std::max(seen.norm_per_mm * 1.1, 1 / tolerance.flat_radius_mm));
  }
}

TEST(EncloseSeam, ACertainVerdictIsThatOfTheDensestSampling) {
  std::mt19937_64 random(testSeed());
  int certain = 0;
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = randomSeam(random);
    const ContinuityTolerance tolerance = randomTolerance(random);
    for (const bool figures : {true, false}) {
      const SeamFigures enclosed =
          encloseSeam(a.seamSide(), b.seamSide(), tolerance, {.figures = figures});
      const Verdict verdict = judge(enclosed, tolerance, Level::G2);
      if (!verdict.certain) continue;
      ++certain;
      Dense seen = dense(a, b, tolerance, 201);
      if (enclosed.curvature_rel) {  // on the rounding of a flat radius a value may occur at one
                                     // place only
        const double at = enclosed.curvature_rel->at;
        const PairMeasure pair = measurePair(a.at(at), b.at(at));
        seen.curvature_rel = std::max(
            seen.curvature_rel, relativeDifference(*pair.curvature, tolerance.flat_radius_mm));
      }
      const auto beyond = [](double value, double limit) {
        return value > limit * (1 + 1e-9) + 1e-12;
      };
      if (verdict.level >= Level::G0) {
        EXPECT_FALSE(beyond(seen.gap_mm, tolerance.gap_mm));
      }
      if (verdict.level >= Level::G1) {
        EXPECT_FALSE(beyond(seen.angle_rad, tolerance.angle_rad));
      }
      if (verdict.level >= Level::G2) {
        EXPECT_FALSE(beyond(seen.curvature_rel, tolerance.curvature_rel));
      }
      // Sampling misses what is next to a maximum.
      const auto within = [](double value, double limit) { return value < limit * 0.99 - 1e-12; };
      const bool g0 = within(seen.gap_mm, tolerance.gap_mm);
      const bool g1 = g0 && within(seen.angle_rad, tolerance.angle_rad) && !seen.fold;
      const bool g2 = g1 && within(seen.curvature_rel, tolerance.curvature_rel);
      if (g0) {
        EXPECT_GE(verdict.level, Level::G0);
      }
      if (g1) {
        EXPECT_GE(verdict.level, Level::G1);
      }
      if (g2) {
        EXPECT_GE(verdict.level, Level::G2);
      }
    }
  }
  EXPECT_GT(certain, 600);
}

TEST(EncloseSeam, AVerdictAloneIsThatOfAllFigures) {
  std::mt19937_64 random(testSeed());
  int below_g2 = 0;
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const bool is_scattered = i % 4 == 0;
    const auto [a, b] = is_scattered ? scatteredSeam(random) : randomSeam(random);
    const ContinuityTolerance tolerance =
        is_scattered ? ContinuityTolerance() : randomTolerance(random);
    const auto figures = [&](bool all) {
      return encloseSeam(a.seamSide(), b.seamSide(), tolerance, {.figures = all});
    };
    const SeamFigures full = figures(true), quick = figures(false);
    const Verdict wanted = judge(full, tolerance, Level::G2);
    const Verdict found = judge(quick, tolerance, Level::G2);
    if (!wanted.certain) continue;
    EXPECT_TRUE(found.certain) << quick.uncertified;
    EXPECT_EQ(found.level, wanted.level);
    EXPECT_EQ(found.seam_class, wanted.seam_class);
    EXPECT_LE(quick.gap_mm->lower, *full.gap_mm->upper);
    EXPECT_GE(*quick.gap_mm->upper, full.gap_mm->lower);
    below_g2 += found.level == Level::G1;
  }
  EXPECT_GT(below_g2, 20);
}

/// Tolerances up to a hundredth above the largest values.
ContinuityTolerance justAbove(const SeamFigures& figures, std::mt19937_64& random) {
  const auto above = [&](const std::optional<Figure>& figure, double otherwise) {
    return figure && figure->lower > 0 ? figure->lower * (1 + logUniform(random, -4, -2))
                                       : otherwise;
  };
  ContinuityTolerance tolerance;
  tolerance.gap_mm = above(figures.gap_mm, tolerance.gap_mm);
  tolerance.angle_rad = std::min(above(figures.angle_rad, tolerance.angle_rad), 0.5);
  tolerance.curvature_rel = above(figures.curvature_rel, tolerance.curvature_rel);
  tolerance.crease_rad = std::max(tolerance.crease_rad, tolerance.angle_rad);
  return tolerance;
}

// Pieces are cut until the verdict is certain, not until the figures are known to 1 %.
TEST(EncloseSeam, AVerdictAloneIsCertainAlsoNearATolerance) {
  std::mt19937_64 random(testSeed());
  int certain = 0, more = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = randomSeam(random);
    const auto figures = [&](const ContinuityTolerance& tolerance, bool all) {
      return encloseSeam(a.seamSide(), b.seamSide(), tolerance, {.figures = all});
    };
    const ContinuityTolerance tolerance = justAbove(figures({}, true), random);
    const Verdict wanted = judge(figures(tolerance, true), tolerance, Level::G2);
    const Verdict found = judge(figures(tolerance, false), tolerance, Level::G2);
    more += found.certain && !wanted.certain;
    if (!wanted.certain) continue;
    ++certain;
    EXPECT_TRUE(found.certain);
    EXPECT_EQ(found.level, wanted.level);
    EXPECT_EQ(found.seam_class, wanted.seam_class);
  }
  EXPECT_GT(certain, 20);
  EXPECT_GT(more, 20);
}

// Near a pole whose poles are scattered no fold can be excluded.
TEST(EncloseSeam, AFoldThatWouldChangeNothingLeavesTheVerdictCertain) {
  std::mt19937_64 random(testSeed());
  int sharp = 0;
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const auto [a, b] = scatteredSeam(random);
    const ContinuityTolerance tolerance = randomTolerance(random);
    for (const bool all : {true, false}) {
      const SeamFigures figures =
          encloseSeam(a.seamSide(), b.seamSide(), tolerance, {.figures = all});
      const bool is_sharp = figures.angle_rad && figures.angle_rad->lower > tolerance.crease_rad;
      const bool says_so = figures.uncertified.find("fold") != std::string::npos;
      sharp += is_sharp;
      EXPECT_FALSE(is_sharp && says_so);
    }
  }
  EXPECT_GT(sharp, 20);
}

// --- exact joins

/// Bernstein coefficients of a polynomial with values in space or of numbers.
template <class Value>
using Bernstein = std::vector<Value>;

Bernstein<Vec> operator*(const Bernstein<double>& a, const Bernstein<Vec>& b) {
  const int p = static_cast<int>(a.size()) - 1, q = static_cast<int>(b.size()) - 1;
  Bernstein<Vec> product(p + q + 1, Vec::Zero());
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j)
      product[i + j] += choose(p, i) * choose(q, j) / choose(p + q, i + j) * a[i] * b[j];
  return product;
}

Bernstein<Vec> elevated(const Bernstein<Vec>& a, int degree) {
  return Bernstein<double>(degree + 2 - a.size(), 1.0) * a;
}

Bernstein<Vec> sum(const Bernstein<Vec>& a, const Bernstein<Vec>& b) {
  const int degree = static_cast<int>(std::max(a.size(), b.size())) - 1;
  Bernstein<Vec> total = elevated(a, degree);
  const Bernstein<Vec> other = elevated(b, degree);
  for (int i = 0; i <= degree; ++i) total[i] += other[i];
  return total;
}

Bernstein<Vec> derivative(const Bernstein<Vec>& a) {
  Bernstein<Vec> result;
  for (std::size_t i = 1; i < a.size(); ++i)
    result.push_back(static_cast<double>(a.size() - 1) * (a[i] - a[i - 1]));
  return result;
}

Bernstein<double> randomFactor(double middle, double spread, std::mt19937_64& random) {
  std::uniform_real_distribution<double> value(middle - spread, middle + spread);
  const double first = value(random);
  return {first, value(random)};
}

/// A patch Q with Q = P, Q_u = alpha P_u + beta P_v and (order 2) Q_uu by the chain rule along P's
/// edge u = 1.
/// Source: docs/theory/surfaces.md S1.1, S3.1.
BezierPatch joined(const BezierPatch& p, int order, std::mt19937_64& random) {
  const int m = p.degreeU(), n = p.degreeV();
  const auto row = [&](int i) {
    Bernstein<Vec> poles;
    for (int j = 0; j <= n; ++j) poles.push_back(p.pole(i, j));
    return poles;
  };
  const auto minus = [&](const Bernstein<Vec>& a) { return Bernstein<double>{-1} * a; };
  const Bernstein<Vec> x = row(m),
                       xu = Bernstein<double>{static_cast<double>(m)} * sum(x, minus(row(m - 1)));
  const Bernstein<Vec> xuu = Bernstein<double>{m * (m - 1.0)} *
                             sum(sum(x, row(m - 2)), Bernstein<double>{-2} * row(m - 1));
  const Bernstein<double> alpha = randomFactor(1, 0.4, random), beta = randomFactor(0, 0.4, random);
  const Bernstein<double> gamma = randomFactor(0, 2, random), delta = randomFactor(0, 2, random);
  const Bernstein<Vec> q1 = sum(alpha * xu, beta * derivative(x));
  const auto squared = [&](const Bernstein<double>& a, const Bernstein<double>& b,
                           const Bernstein<Vec>& c) { return a * (b * c); };
  Bernstein<Vec> q2 = sum(
      sum(squared(alpha, alpha, xuu), Bernstein<double>{2} * squared(alpha, beta, derivative(xu))),
      squared(beta, beta, derivative(derivative(x))));
  q2 = sum(q2, sum(gamma * xu, delta * derivative(x)));
  if (order < 2)
    for (Vec& pole : q2) pole += test::randomVector(random);
  const int degree = n + 2, cross = 3;
  const Bernstein<Vec> b0 = elevated(x, degree), d1 = elevated(q1, degree),
                       d2 = elevated(q2, degree);
  Poles poles((cross + 1) * (degree + 1), 3);
  for (int j = 0; j <= degree; ++j) {
    const Vec b1 = b0[j] + d1[j] / cross, b2 = d2[j] / (cross * (cross - 1)) + 2 * b1 - b0[j];
    poles.row(j) = b0[j].transpose();
    poles.row(degree + 1 + j) = b1.transpose();
    poles.row(2 * (degree + 1) + j) = b2.transpose();
    poles.row(3 * (degree + 1) + j) = (b2 + d1[j] + test::randomVector(random)).transpose();
  }
  return {cross, degree, poles};
}

/// So tight that bounds are only let off when rounding is all that is left of them.
ContinuityTolerance tight() {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = tolerance.angle_rad = 1e-7;
  tolerance.curvature_rel = 1e-4;
  return tolerance;
}

TEST(EncloseSeam, Identity3ExactJoinsLeaveOnlyRounding) {
  std::mt19937_64 random(testSeed());
  const ContinuityTolerance tolerance = tight();
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(i);
    const int n = 2 + static_cast<int>(random() % 3);
    const BezierPatch p = randomPatch(2 + static_cast<int>(random() % 2), n, 0.4, false, random);
    for (const int order : {1, 2}) {
      const PatchSide a = endOf(p), b = beginOf(joined(p, order, random));
      const SeamFigures figures = encloseSeam(a.seamSide(), b.seamSide(), tolerance);
      expectTrue(figures, a, b, tolerance, 51);
      EXPECT_LT(*figures.gap_mm->upper, 1e-8);
      EXPECT_LT(*figures.angle_rad->upper, 2e-9);
      const Verdict verdict = judge(figures, tolerance, Level::G2);
      EXPECT_TRUE(verdict.certain) << figures.uncertified;
      EXPECT_EQ(verdict.level, order == 2 ? Level::G2 : Level::G1);
      if (order == 2) {
        EXPECT_LT(*figures.curvature_per_mm->upper, 1e-7);
      }
    }
  }
}

TEST(EncloseSeam, Identity3RationalPatchesThatGoOnLeaveOnlyRounding) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const BezierPatch whole = randomPatch(3, 3, 0.4, true, random);
    const auto [left, right] = whole.splitU(0.4);
    const SeamFigures figures =
        encloseSeam(endOf(left).seamSide(), beginOf(right).seamSide(), tight());
    EXPECT_LT(*figures.gap_mm->upper, 1e-8);
    EXPECT_LT(*figures.angle_rad->upper, 1e-8);
    EXPECT_LT(*figures.curvature_per_mm->upper, 1e-6);
    const Verdict verdict = judge(figures, tight(), Level::G2);
    EXPECT_TRUE(verdict.certain);
    EXPECT_EQ(verdict.level, Level::G2);
  }
}

TEST(EncloseSeam, Identity3JoinsOfHighDegreeLeaveOnlyRounding) {
  std::mt19937_64 random(testSeed());
  for (const int degree : {9, 14, 19, 25}) {
    SCOPED_TRACE(degree);
    const auto [left, right] = randomPatch(3, degree, 0.3, false, random).splitU(0.5);
    const SeamFigures figures =
        encloseSeam(endOf(left).seamSide(), beginOf(right).seamSide(), tight());
    EXPECT_LT(*figures.angle_rad->upper, 1e-7);
    EXPECT_LT(*figures.curvature_rel->upper, 1e-4);
    EXPECT_TRUE(judge(figures, tight(), Level::G2).certain);
    EXPECT_EQ(judge(figures, tight(), Level::G2).level, Level::G2);
  }
}

// --- seams that hide something

BezierPatch mapped(const BezierPatch& patch, const Eigen::Matrix3d& matrix,
                   const Vec& translation) {
  Poles poles = patch.poles() * matrix.transpose();
  poles.rowwise() += translation.transpose();
  return {patch.degreeU(), patch.degreeV(), poles, patch.weights()};
}

PatchSide alongTheOtherWay(PatchSide side) {
  side.reversed = !side.reversed;
  side.face_on_left = !side.face_on_left;
  return side;
}

PatchSide transposed(const PatchSide& side) {
  Poles poles = side.path.poles();
  poles.col(0).swap(poles.col(1));
  return {side.surface.transposed(), BezierCurve(poles, side.path.weights()), !side.face_on_left,
          side.reversed};
}

PatchSide reversedU(const PatchSide& side) {
  Poles poles = side.path.poles();
  poles.col(0) = 1 - poles.col(0).array();
  return {side.surface.reversedU(), BezierCurve(poles, side.path.weights()), !side.face_on_left,
          side.reversed};
}

TEST(EncloseSeam, Identity2TheVerdictDoesNotDependOnTheDescription) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(i);
    const auto seam = randomSeam(random);
    const PatchSide& a = std::get<0>(seam);
    const PatchSide& b = std::get<1>(seam);
    const ContinuityTolerance tolerance = randomTolerance(random);
    const SeamFigures figures = encloseSeam(a.seamSide(), b.seamSide(), tolerance);
    const Verdict verdict = judge(figures, tolerance, Level::G2);
    const auto expectSame = [&](const PatchSide& x, const PatchSide& y,
                                const ContinuityTolerance& limits, double scale, const char* law) {
      const SeamFigures other = encloseSeam(x.seamSide(), y.seamSide(), limits);
      const Verdict same = judge(other, limits, Level::G2);
      if (verdict.certain && same.certain) {
        EXPECT_EQ(verdict.level, same.level) << law;
        EXPECT_EQ(verdict.seam_class, same.seam_class) << law;
      }
      const auto overlap = [&](const std::optional<Figure>& p, const std::optional<Figure>& q,
                               double factor, double noise) {
        if (!p || !q || !p->upper || !q->upper) return;
        EXPECT_LE(p->lower * factor, *q->upper * (1 + 1e-9) + noise) << law;
        EXPECT_LE(q->lower, *p->upper * factor * (1 + 1e-9) + noise) << law;
      };
      overlap(figures.gap_mm, other.gap_mm, scale, 1e-12 * scale);
      overlap(figures.angle_rad, other.angle_rad, 1, 1e-12);
      overlap(figures.curvature_per_mm, other.curvature_per_mm, 1 / scale, 1e-10 / scale);
      overlap(figures.curvature_rel, other.curvature_rel, 1, 1e-9);
    };
    expectSame(b, a, tolerance, 1, "swap");
    expectSame(alongTheOtherWay(a), alongTheOtherWay(b), tolerance, 1, "reversal");
    expectSame(transposed(a), b, tolerance, 1, "flip of a");
    expectSame(a, reversedU(b), tolerance, 1, "flip of b");
    const auto both = [&](const Eigen::Matrix3d& matrix, const ContinuityTolerance& limits,
                          double scale, const char* law) {
      const Vec translation = 3 * test::randomVector(random);
      PatchSide x = a, y = b;
      x.surface = mapped(a.surface, matrix, translation);
      y.surface = mapped(b.surface, matrix, translation);
      expectSame(x, y, limits, scale, law);
    };
    both(test::randomRotation(random), tolerance, 1, "motion");
    both(Vec(1, 1, -1).asDiagonal(), tolerance, 1, "mirror");
    ContinuityTolerance scaled = tolerance;
    const double scale = std::exp2(static_cast<int>(random() % 21) - 10);
    scaled.gap_mm *= scale;
    scaled.flat_radius_mm *= scale;
    both(scale * Eigen::Matrix3d::Identity(), scaled, scale, "scale");
    SeamSide half = a.seamSide(), other_half = b.seamSide();
    half.s = other_half.s = {0, 0.3, 1};  // the same pairs, met at another place
    half.t = other_half.t = {0, 0.6, 1};
    const Verdict same = judge(encloseSeam(half, other_half, tolerance), tolerance, Level::G2);
    if (verdict.certain && same.certain) {
      EXPECT_EQ(verdict.level, same.level) << "another correspondence";
    }
  }
}

TEST(EncloseSeam, DegenerateEdgesAreNeverCertainlySmoothWithoutAPlane) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const auto [patch, next] = randomPatch(3, 3, 0.3, i % 2 == 0, random).splitU(0.5);
    Poles poles = next.poles();
    const int kind = i % 4;
    const auto pole = [&](int row, int column) { return poles.row(row * 4 + column); };
    if (kind == 0) pole(1, 0) = pole(0, 0);  // corner collapsed in the cross direction
    if (kind == 1)
      for (int j = 0; j < 4; ++j) pole(1, j) = pole(0, j);  // no cross derivative at all
    if (kind == 2)
      for (int j = 0; j < 4; ++j)  // cross derivative within 1e-7 of the seam's direction
        pole(1, j) = pole(0, j) + (pole(0, 3) - pole(0, 0)) / 4 +
                     1e-7 * test::randomVector(random).transpose();
    if (kind == 3)
      for (int j = 0; j < 4; ++j) {  // cross derivative turns round: a cusp inside
        const Eigen::RowVector3d across = pole(1, j) - pole(0, j);
        pole(1, j) = pole(0, j) + (j < 2 ? 1 : -1) * across;
      }
    const PatchSide a = endOf(patch), b = beginOf({3, 3, poles, next.weights()});
    const SeamFigures figures = encloseSeam(a.seamSide(), b.seamSide(), {}, {.max_pieces = 2000});
    expectTrue(figures, a, b, {}, 101);
    const Verdict verdict = judge(figures, {}, Level::G1);
    if (kind == 1 || kind == 3) {
      EXPECT_FALSE(verdict.certain && verdict.seam_class == SeamClass::Smooth);
    }
  }
}

}  // namespace
}  // namespace seamwright
