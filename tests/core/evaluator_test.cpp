// SPDX-License-Identifier: LGPL-2.1-or-later
// Fields of analytic, swept and placed surfaces along paths against the same surfaces as formulas.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "evaluator_oracle.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using namespace test::formulas;
using test::logUniform;
using test::randomRotation;
using test::Vec;

Frame randomFrame(std::mt19937_64& random) {
  Frame frame{10 * test::randomVector(random), randomRotation(random)};
  if (random() % 2 == 0) frame.axes.col(2) *= -1;  // left-handed
  return frame;
}

struct Kind {
  const char* name;
  std::unique_ptr<SurfaceEvaluator> evaluator;
  Surface formula;
};

Point turnedAbout(const Jet& u, const Jet& radius, const Jet& height) {
  return {radius * cosine(u), radius * sine(u), height};
}

std::vector<Kind> analyticKinds(std::mt19937_64& random) {
  const Frame frame = randomFrame(random);
  const double r = logUniform(random, -1, 2), R = logUniform(random, -1, 2);
  const double angle = std::uniform_real_distribution<double>(-1.4, 1.4)(random);
  std::vector<Kind> kinds;
  kinds.push_back({"plane", planeEvaluator(frame), [](const Jet& u, const Jet& v) {
                     return Point{u, v, Jet(0)};
                   }});
  kinds.push_back({"cylinder", cylinderEvaluator(frame, r),
                   [=](const Jet& u, const Jet& v) { return turnedAbout(u, Jet(r), v); }});
  kinds.push_back({"cone", coneEvaluator(frame, r, angle), [=](const Jet& u, const Jet& v) {
                     const Real a = angle;
                     return turnedAbout(u, Jet(r) + Jet(std::sin(a)) * v, Jet(std::cos(a)) * v);
                   }});
  kinds.push_back({"sphere", sphereEvaluator(frame, r), [=](const Jet& u, const Jet& v) {
                     return turnedAbout(u, Jet(r) * cosine(v), Jet(r) * sine(v));
                   }});
  kinds.push_back({"torus", torusEvaluator(frame, R, r), [=](const Jet& u, const Jet& v) {
                     return turnedAbout(u, Jet(R) + Jet(r) * cosine(v), Jet(r) * sine(v));
                   }});
  for (Kind& kind : kinds) kind.formula = inFrame(frame, kind.formula);
  return kinds;
}

TEST(Evaluator, AnalyticSurfacesAreHeld) {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> place(-3, 3);
  known = 0;
  for (int i = 0; i < 120; ++i)
    for (const Kind& kind : analyticKinds(random)) {
      SCOPED_TRACE(testing::Message() << kind.name << " " << i);
      const bool sphere = std::string_view(kind.name) == "sphere";  // turns over beyond its poles
      const double u = place(random), v = sphere ? place(random) / 3 : place(random);
      const Path path = randomPath(u, v, logUniform(random, -8, sphere ? -0.5 : 0), random);
      expectHeld(
          *kind.evaluator, [&](Real a, Real b) { return fieldsAt(kind.formula, a, b); }, path, u,
          v);
    }
  EXPECT_GT(known, 50000);
}

TEST(Evaluator, ConesNearTheApexAndSpindlesAreHeldOrUnknown) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const Frame frame = randomFrame(random);
    const double angle = std::uniform_real_distribution<double>(0.1, 1.4)(random);
    const double off = (i % 2 == 0 ? 1 : -1) * logUniform(random, -6, 0);
    const auto cone = coneEvaluator(frame, 2, angle);
    const double apex = -2 / std::sin(angle);
    const Surface formula = inFrame(frame, [=](const Jet& u, const Jet& v) {
      const Real a = angle;
      return turnedAbout(u, Jet(2) + Jet(std::sin(a)) * v, Jet(std::cos(a)) * v);
    });
    // Relative to the apex the parameter is known to rounding only; the models must say so
    // themselves.
    const Path path = randomPath(1, apex + off, std::abs(off) / 3, random);
    expectHeld(
        *cone, [&](Real a, Real b) { return fieldsAt(formula, a, b); }, path, 1, apex + off);
    const Path across = randomPath(1, apex, std::abs(off), random);
    const SurfaceFields fields =
        cone->fields(across.u, ChebyshevModel::linear(apex, off, 0), 1, apex, Detail::Curvature);
    EXPECT_FALSE(fields.normal[0].isKnown());
    EXPECT_TRUE(fields.point[0].isKnown());

    const double r = 2, R = i % 3 == 0 ? 0.5 : i % 3 == 1 ? 2 : 1.999;  // spindle, horn
    const auto torus = torusEvaluator(frame, R, r);
    const Surface ring = inFrame(frame, [=](const Jet& u, const Jet& v) {
      return turnedAbout(u, Jet(R) + Jet(r) * cosine(v), Jet(r) * sine(v));
    });
    const double inner = std::uniform_real_distribution<double>(2, 4)(random);
    const Path inside = randomPath(0.3, inner, logUniform(random, -5, -1), random);
    expectHeld(
        *torus, [&](Real a, Real b) { return fieldsAt(ring, a, b); }, inside, 0.3, inner);
  }
}

TEST(Evaluator, TheSphereHasATangentPlaneAtItsPoles) {
  for (const double pole : {std::numbers::pi / 2, -std::numbers::pi / 2}) {
    const auto sphere = sphereEvaluator(Frame(), 3);
    const SurfaceFields fields = sphere->fields(ChebyshevModel::linear(0, 0.5, 0),
                                                ChebyshevModel(pole), 0, pole, Detail::Curvature);
    ASSERT_TRUE(fields.normal[2].isKnown());
    for (const double x : {-1.0, 0.0, 1.0}) {
      const auto held = [x](const ChebyshevModel& model, double truth) {
        EXPECT_NEAR(model.seriesAt(x), truth, model.radius() + 1e-16);
        EXPECT_LT(model.radius(), 1e-7);
      };
      held(fields.normal[2], pole > 0 ? 1 : -1);
      held(fields.tensor[0], -1 / 3.0);
      held(fields.tensor[1], -1 / 3.0);
      held(fields.tensor[2], 0);
    }
  }
}

struct CurveKind {
  const char* name;
  CurveEvaluator evaluator;
  Curve formula;
};

std::vector<CurveKind> curveKinds(std::mt19937_64& random) {
  const Vec a = 3 * test::randomVector(random), b = test::randomVector(random),
            c = test::randomVector(random);
  SplineData data{randomDirection(4, 2, random), {0, {0, 1}, 0}, {}, {}};
  for (std::size_t i = 0; i + 5 < data.u.knots.size(); ++i) {
    data.poles.push_back(Vec(static_cast<double>(i), 0, 0) + test::randomVector(random));
    data.weights.push_back(std::uniform_real_distribution<double>(0.3, 3)(random));
  }
  const Surface spline = formulaOf(data, 0.05, 0);
  return {
      {"line", LineEvaluator{a, b}, [=](const Jet& t) { return constant(a) + t * constant(b); }},
      {"ellipse", EllipseEvaluator{a, b, c},
       [=](const Jet& t) { return constant(a) + cosine(t) * constant(b) + sine(t) * constant(c); }},
      {"hyperbola", HyperbolaEvaluator{a, b, c},
       [=](const Jet& t) {
         return constant(a) + hyperbolicCosine(t) * constant(b) + hyperbolicSine(t) * constant(c);
       }},
      {"parabola", ParabolaEvaluator{a, b, c},
       [=](const Jet& t) { return constant(a) + t * t * constant(b) + t * constant(c); }},
      {"spline", data.evaluator(), [=](const Jet& t) { return spline(t, Jet(0)); }}};
}

TEST(Evaluator, SweptSurfacesAreHeld) {
  std::mt19937_64 random(testSeed());
  known = 0;
  for (int i = 0; i < 60; ++i) {
    const Frame frame = randomFrame(random);
    const Vec direction = test::randomVector(random);
    for (const CurveKind& curve : curveKinds(random)) {
      SCOPED_TRACE(testing::Message() << curve.name << " " << i);
      const double t = 0.04, other = std::uniform_real_distribution<double>(-2, 2)(random);
      const double half = logUniform(random, -6, -1.4);
      const Surface extruded = [&](const Jet& u, const Jet& v) {
        return curve.formula(u) + v * constant(direction);
      };
      expectHeld(
          *extrusionEvaluator(curve.evaluator, direction),
          [&](Real a, Real b) { return fieldsAt(extruded, a, b); },
          randomPath(t, other, half, random), t, other, 1e-17L);
      const Surface turned = [&](const Jet& u, const Jet& v) {
        const Point local = transformed(frame.axes.transpose(), curve.formula(v),
                                        Vec(-frame.axes.transpose() * frame.origin));
        const Point rotated = {cosine(u) * local[0] - sine(u) * local[1],
                               sine(u) * local[0] + cosine(u) * local[1], local[2]};
        return transformed(frame.axes, rotated, frame.origin);
      };
      expectHeld(
          *revolutionEvaluator(frame, curve.evaluator),
          [&](Real a, Real b) { return fieldsAt(turned, a, b); },
          randomPath(other, t, half, random), other, t, 1e-14L);
    }
  }
  EXPECT_GT(known, 100000);
}

TEST(Evaluator, ACurveThatTouchesTheAxisHasNoBoundedPlaneThere) {
  const auto cone = revolutionEvaluator(Frame(), LineEvaluator{{0, 0, 0}, {1, 0, 1}});
  const SurfaceFields at =
      cone->fields(ChebyshevModel(0), ChebyshevModel::linear(0, 0.1, 0), 0, 0, Detail::Curvature);
  EXPECT_FALSE(at.normal[0].isKnown());
  EXPECT_TRUE(at.point[0].isKnown());
  EXPECT_TRUE(cone->fields(ChebyshevModel(0), ChebyshevModel(0.1), 0, 0.1, Detail::Curvature)
                  .normal[0]
                  .isKnown());
}

TEST(Evaluator, PlacedSurfacesAreHeld) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    Placement placement{(i % 3 == 0 ? -1 : 1) * logUniform(random, -3, 3), randomRotation(random),
                        100 * test::randomVector(random)};
    if (i % 2 == 0) placement.orthogonal.col(1) *= -1;  // a mirror
    for (Kind& kind : analyticKinds(random)) {
      const Surface formula = [&](const Jet& u, const Jet& v) {
        return transformed(placement.scale * placement.orthogonal, kind.formula(u, v),
                           placement.translation);
      };
      const Path path = randomPath(0.4, 0.2, logUniform(random, -6, -0.5), random);
      expectHeld(
          *placedEvaluator(std::move(kind.evaluator), placement),
          [&](Real a, Real b) { return fieldsAt(formula, a, b); }, path, 0.4, 0.2, 2e-15L);
    }
  }
}

TEST(SurfaceEvaluator, BeyondItsPolesASphereIsSeenFromInside) {
  const auto sphere = sphereEvaluator({}, 3);
  for (const double v : {0.0, 1.5, 1.7, 3.0}) {
    const SurfaceFields fields =
        sphere->fields(ChebyshevModel(0.3), ChebyshevModel(v), 0.3, v, Detail::TangentPlane);
    double outward = 0;
    for (int i = 0; i < 3; ++i)
      outward += fields.point[i].coefficient(0) * fields.normal[i].coefficient(0);
    EXPECT_NEAR(outward, std::cos(v) < 0 ? -3 : 3, 1e-12) << v;
  }
}

}  // namespace
}  // namespace seamwright
