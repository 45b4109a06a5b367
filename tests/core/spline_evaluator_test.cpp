// SPDX-License-Identifier: LGPL-2.1-or-later
// Fields of spline surfaces and of their offsets along paths against de Boor's triangle on jets in
// long double.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <random>

#include "evaluator_oracle.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using namespace test::formulas;
using test::logUniform;
using test::Vec;

TEST(Evaluator, SplinesAreHeldWithinAndBeyondTheSpanMeant) {
  std::mt19937_64 random(testSeed());
  known = 0;
  for (int i = 0; i < 250; ++i) {
    const int p = i % 25 == 0 ? 25 : 1 + static_cast<int>(random() % 6);
    const int q = i % 50 == 0 ? 12 : 1 + static_cast<int>(random() % 5);
    SCOPED_TRACE(testing::Message() << i << " degrees " << p << ", " << q);
    const SplineData spline = randomSpline(p, q, i % 2 == 0, i % 5 == 0 ? 1e4 : 0, random);
    const double u = placeIn(spline.u, random), v = placeIn(spline.v, random);
    const Path path = randomPath(u, v, logUniform(random, -6, p > 10 ? -2 : -0.7), random);
    const Surface formula = formulaOf(spline, u, v);
    expectHeld(
        *splineEvaluator(spline.evaluator()),
        [&](Real a, Real b) { return fieldsAt(formula, a, b); }, path, u, v, 1e-18L);
  }
  EXPECT_GT(known, 20000);
}

/// A path along a whole span, in one of both senses, or along a part of it.
ChebyshevModel alongSpan(const SplineDirection& direction, double place, std::mt19937_64& random) {
  const int s = spanOf(direction, place);
  const double half = 0.5 * (direction.knots[s + 1] - direction.knots[s]);
  const double sense = random() % 2 == 0 ? 1 : -1;
  const double share = random() % 3 == 0 ? 0.3 : 1;
  return ChebyshevModel::linear(place, sense * share * half, random() % 2 == 0 ? 0 : 1e-13);
}

TEST(SplineEvaluator, FieldsAreHeldAlongParameterLines) {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> unit(-1, 1);
  known = 0;
  for (int i = 0; i < 300; ++i) {
    const int p = 1 + static_cast<int>(random() % 7), q = 1 + static_cast<int>(random() % 5);
    SCOPED_TRACE(testing::Message() << i << " degrees " << p << ", " << q);
    const SplineData spline = randomSpline(p, q, i % 2 == 0, i % 5 == 0 ? 1e4 : 0, random);
    const double u = placeIn(spline.u, random), v = placeIn(spline.v, random);
    const bool along_u = i % 4 < 2;
    const SplineDirection& across = along_u ? spline.v : spline.u;
    const int s = spanOf(across, along_u ? v : u);
    const double lower = across.knots[s], upper = across.knots[s + 1];
    const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
    const double places[] = {lower, upper, middle, middle + half * unit(random)};
    const double radius = random() % 2 == 0 ? 0 : half * logUniform(random, -15, -9);
    const auto constant = ChebyshevModel::linear(places[random() % 4], 0, radius);
    const Path path = along_u ? Path{alongSpan(spline.u, u, random), constant}
                              : Path{constant, alongSpan(spline.v, v, random)};
    const Surface formula = formulaOf(spline, u, v);
    expectHeld(
        *splineEvaluator(spline.evaluator()),
        [&](Real a, Real b) { return fieldsAt(formula, a, b); }, path, u, v, 1e-18L);
  }
  EXPECT_GT(known, 100000);
}

/// Knots so near to one another that differences of differences of poles are all rounding.
SplineDirection crowdedDirection(int degree, std::mt19937_64& random) {
  SplineDirection direction = randomDirection(degree, 0, random);
  double knot = std::uniform_real_distribution<double>(0.1, 0.5)(random);
  for (int k = 0; k < 3; ++k, knot += logUniform(random, -9, -1))
    direction.knots.insert(direction.knots.end() - degree - 1, knot);
  return direction;
}

TEST(SplineEvaluator, JetsAreHeldWhereRoundingIsAllThereIs) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 3000; ++i) {
    SplineData spline{
        crowdedDirection(1 + i % 5, random), crowdedDirection(1 + i % 3, random), {}, {}};
    const std::size_t count = (spline.u.knots.size() - spline.u.degree - 1) *
                              (spline.v.knots.size() - spline.v.degree - 1);
    for (std::size_t k = 0; k < count; ++k) spline.poles.push_back(test::randomVector(random));
    const double u = placeIn(spline.u, random), v = placeIn(spline.v, random);
    const JetModel jet = spline.evaluator()->jet(ChebyshevModel(u), ChebyshevModel(v), u, v, 3);
    const auto [x, y, z] = formulaOf(spline, u, v)(Jet(u, 1, 0), Jet(v, 0, 1));
    const std::array<Jet, 3> truth = {x, y, z};
    for (std::size_t d = 0; d < 3; ++d) {
      const auto held = [&](const VectorModel& model, Real value, const char* what) {
        const Real off = std::abs(value - model[d].coefficient(0));
        EXPECT_LE(off, model[d].radius() + 1e-18L * std::abs(value)) << i << " " << what;
      };
      held(jet.p, truth[d].f, "p");
      held(jet.u, truth[d].u, "u");
      held(jet.v, truth[d].v, "v");
      held(jet.uu, truth[d].uu, "uu");
      held(jet.uv, truth[d].uv, "uv");
      held(jet.vv, truth[d].vv, "vv");
      held(jet.uuu, truth[d].uuu, "uuu");
      held(jet.uuv, truth[d].uuv, "uuv");
      held(jet.uvv, truth[d].uvv, "uvv");
      held(jet.vvv, truth[d].vvv, "vvv");
    }
  }
}

/// A random spline all of whose poles on a boundary are one point.
struct CollapsedSpline {
  SplineData spline;
  int direction = 0;  ///< of the parameter that is constant on the boundary
  bool at_end = false;

  double boundary() const { return at_end ? 1 : 0; }
  double inside(double distance) const { return at_end ? 1 - distance : distance; }
};

CollapsedSpline collapsedSpline(std::mt19937_64& random) {
  const int p = 2 + static_cast<int>(random() % 4), q = 1 + static_cast<int>(random() % 5);
  CollapsedSpline result{randomSpline(p, q, random() % 2 == 0, 0, random),
                         static_cast<int>(random() % 2), random() % 2 == 0};
  SplineData& spline = result.spline;
  const int columns = static_cast<int>(spline.v.knots.size()) - q - 1;
  const int rows = static_cast<int>(spline.poles.size()) / columns;
  const Vec point = random() % 2 == 0 ? Vec(0, 0, 0) : test::randomVector(random);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int last = result.direction == 0 ? rows - 1 : columns - 1;
      if ((result.direction == 0 ? i : j) == (result.at_end ? last : 0))
        spline.poles[static_cast<std::size_t>(i) * columns + j] = point;
    }
  return result;
}

TEST(SplineEvaluator, FieldsAreHeldNextToABoundaryThatIsOnePoint) {
  std::mt19937_64 random(testSeed());
  known = 0;
  for (int i = 0; i < 300; ++i) {
    const CollapsedSpline collapsed = collapsedSpline(random);
    const SplineData& spline = collapsed.spline;
    const double distance = logUniform(random, -5, -1.5);
    double at[] = {placeIn(spline.u, random), placeIn(spline.v, random)};
    at[collapsed.direction] = collapsed.inside(distance);
    SCOPED_TRACE(testing::Message()
                 << i << " at " << distance << " from boundary " << collapsed.boundary()
                 << " of parameter " << collapsed.direction);
    const Path path = randomPath(at[0], at[1], 0.5 * distance, random);
    const Surface formula = formulaOf(spline, at[0], at[1]);
    // The formula divides its rounding by the square of the distance.
    expectHeld(
        *splineEvaluator(spline.evaluator()),
        [&](Real a, Real b) { return fieldsAt(formula, a, b); }, path, at[0], at[1],
        1e-17L / (distance * distance));
  }
  EXPECT_GT(known, 50000);
}

TEST(SplineEvaluator, TheNormalIsKnownUpToABoundaryThatIsOnePoint) {
  std::mt19937_64 random(testSeed());
  int held = 0;
  for (int i = 0; i < 200; ++i) {
    const CollapsedSpline collapsed = collapsedSpline(random);
    const double length = 1e-3;
    double at[] = {placeIn(collapsed.spline.u, random), placeIn(collapsed.spline.v, random)};
    std::array<ChebyshevModel, 2> path = {ChebyshevModel(at[0]), ChebyshevModel(at[1])};
    const double middle = at[collapsed.direction] = collapsed.inside(length / 2);
    path[collapsed.direction] = ChebyshevModel::linear(middle, length / 2, 1e-16);
    const SurfaceFields fields = splineEvaluator(collapsed.spline.evaluator())
                                     ->fields(path[0], path[1], at[0], at[1], Detail::TangentPlane);
    if (!fields.normal[0].isKnown()) continue;  // nearly parallel tangents
    ++held;
    at[collapsed.direction] = collapsed.inside(1e-9);
    const Vec3 near = fieldsAt(formulaOf(collapsed.spline, at[0], at[1]), at[0], at[1]).normal;
    const double end = collapsed.at_end ? 1 : -1;
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(fields.normal[d].seriesAt(end), static_cast<double>(near[d]),
                  fields.normal[d].radius() + 1e-5);
  }
  EXPECT_GT(held, 150);
}

TEST(Evaluator, PeriodicSplinesRepeat) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    SplineData spline = randomSpline(3, 2, i % 2 == 0, 0, random);
    spline.u.period = 1;
    const double u = placeIn(spline.u, random), v = placeIn(spline.v, random);
    const Surface formula = formulaOf(spline, u, v);
    for (const int turns : {-3, 1, 40}) {
      const Path path = randomPath(u + turns, v, 0.01, random);
      expectHeld(
          *splineEvaluator(spline.evaluator()),
          [&](Real a, Real b) { return fieldsAt(formula, a - turns, b); }, path, u + turns, v,
          1e-18L);
      const std::vector<double> knots =
          spline.evaluator()->knotsInside(0, {turns - 1e-9, turns + 1e-9});
      ASSERT_EQ(knots.size(), 1u);
      EXPECT_EQ(knots[0], turns);
    }
  }
}

/// The offset's fields from those of the basis: the tensor W (I - d W)^-1, the normal turned where
/// the area does. As a form of parameter vectors the change is that of the basis: with S the
/// Weingarten map, -(n_uu + S X_uu).X_u becomes -(I - d S)^-1 (n_uu + S X_uu).(I - d S) X_u.
Fields offsetAt(const Fields& basis, Real distance) {
  const Matrix3 interval = Matrix3::Identity() - distance * basis.tensor;
  const Real side = interval.determinant() < 0 ? -1 : 1;
  const Matrix3 inverse = interval.inverse();
  return {basis.point + distance * basis.normal,
          side * basis.normal,
          side * basis.tensor * inverse,
          interval * basis.u,
          interval * basis.v,
          [=](const Vec3& d) { return side * basis.change(inverse * d); }};
}

TEST(Evaluator, OffsetsAreHeldOnBothSidesOfTheFocus) {
  std::mt19937_64 random(testSeed());
  known = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const SplineData spline = randomSpline(3, 3, i % 2 == 0, 0, random);
    const double u = placeIn(spline.u, random), v = placeIn(spline.v, random);
    const Surface formula = formulaOf(spline, u, v);
    const double distance = (i % 2 == 0 ? 1 : -1) * logUniform(random, -2, 1.5);
    const Path path = randomPath(u, v, logUniform(random, -6, -1.5), random);
    expectHeld(
        *offsetEvaluator(splineEvaluator(spline.evaluator()), distance),
        [&](Real a, Real b) { return offsetAt(fieldsAt(formula, a, b), distance); }, path, u, v,
        1e-17L);
  }
  EXPECT_GT(known, 10000);
  for (int i = 0; i < 50; ++i) {  // the offset of a torus is a torus
    SCOPED_TRACE(i);
    const double minor = logUniform(random, -1, 1), distance = minor * logUniform(random, -2, 0.3);
    const Path path = randomPath(0.3, 1, logUniform(random, -6, -1.5), random);
    const Surface torus = [=](const Jet& u, const Jet& v) {
      const Jet radius(static_cast<Real>(minor) + distance);
      return Point{(Jet(3 * minor) + radius * cosine(v)) * cosine(u),
                   (Jet(3 * minor) + radius * cosine(v)) * sine(u), radius * sine(v)};
    };
    expectHeld(
        *offsetEvaluator(torusEvaluator({}, 3 * minor, minor), distance),
        [&](Real a, Real b) { return fieldsAt(torus, a, b); }, path, 0.3, 1);
  }
  // By the focal distance: a cylinder moved onto its axis.
  const auto axis = offsetEvaluator(cylinderEvaluator(Frame(), 2), -2);
  const SurfaceFields fields =
      axis->fields(ChebyshevModel::linear(0, 0.1, 0), ChebyshevModel(0), 0, 0, Detail::Curvature);
  EXPECT_FALSE(fields.normal[0].isKnown());
  EXPECT_FALSE(fields.tensor[0].isKnown());
}

TEST(SplineEvaluator, RefusesWhatIsNoSpline) {
  const auto make = [](SplineDirection u, SplineDirection v, std::size_t poles,
                       std::vector<double> weights) {
    return SplineEvaluator(std::move(u), std::move(v), std::vector<Vec>(poles, Vec::Zero()),
                           std::move(weights));
  };
  const SplineDirection line{1, {0, 0, 1, 1}, 0}, point{0, {0, 1}, 0};
  EXPECT_NO_THROW(make(line, point, 2, {}));
  EXPECT_THROW(make(line, point, 3, {}), std::invalid_argument);
  EXPECT_THROW(make(line, point, 2, {1}), std::invalid_argument);
  EXPECT_THROW(make(line, point, 2, {1, 0}), std::invalid_argument);
  EXPECT_THROW(make(line, point, 2, {1, NAN}), std::invalid_argument);
  EXPECT_THROW(make({1, {0, 0, 0, 0}, 0}, point, 2, {}), std::invalid_argument);
  EXPECT_THROW(make({1, {0, 1, 0, 1}, 0}, point, 2, {}), std::invalid_argument);
  EXPECT_THROW(make({1, {0, 0, 1, NAN}, 0}, point, 2, {}), std::invalid_argument);
  EXPECT_THROW(make({-1, {0}, 0}, point, 1, {}), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
