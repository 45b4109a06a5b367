// SPDX-License-Identifier: LGPL-2.1-or-later
// Fields of surfaces along paths against the same surfaces as formulas of second-order jets in long double.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <seamwright/core/enclosure/surface.hpp>

#include "surfaces.hpp"

namespace seamwright {
namespace {

using test::logUniform;
using test::randomRotation;
using test::Vec;
using Real = long double;
using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

/// Value and partial derivatives to second order of a function of (u, v).
struct Jet {
  Real f = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  Jet() = default;
  Jet(Real value) : f(value) {}  // NOLINT(google-explicit-constructor)
  Jet(Real value, Real du, Real dv) : f(value), u(du), v(dv) {}
};

Jet operator+(const Jet& a, const Jet& b) {
  Jet c(a.f + b.f, a.u + b.u, a.v + b.v);
  c.uu = a.uu + b.uu, c.uv = a.uv + b.uv, c.vv = a.vv + b.vv;
  return c;
}
Jet operator*(const Jet& a, const Jet& b) {
  Jet c(a.f * b.f, a.u * b.f + a.f * b.u, a.v * b.f + a.f * b.v);
  c.uu = a.uu * b.f + 2 * a.u * b.u + a.f * b.uu;
  c.uv = a.uv * b.f + a.u * b.v + a.v * b.u + a.f * b.uv;
  c.vv = a.vv * b.f + 2 * a.v * b.v + a.f * b.vv;
  return c;
}
Jet operator-(const Jet& a, const Jet& b) {
  return a + Jet(-1) * b;
}
/// g(a) from the derivatives of g.
Jet chain(const Jet& a, Real g, Real g1, Real g2) {
  Jet c(g, g1 * a.u, g1 * a.v);
  c.uu = g1 * a.uu + g2 * a.u * a.u;
  c.uv = g1 * a.uv + g2 * a.u * a.v;
  c.vv = g1 * a.vv + g2 * a.v * a.v;
  return c;
}
Jet operator/(const Jet& a, const Jet& b) {
  return a * chain(b, 1 / b.f, -1 / (b.f * b.f), 2 / (b.f * b.f * b.f));
}
Jet cosine(const Jet& a) {
  return chain(a, std::cos(a.f), -std::sin(a.f), -std::cos(a.f));
}
Jet sine(const Jet& a) {
  return chain(a, std::sin(a.f), std::cos(a.f), -std::sin(a.f));
}

Jet hyperbolicCosine(const Jet& a) {
  return chain(a, std::cosh(a.f), std::sinh(a.f), std::cosh(a.f));
}
Jet hyperbolicSine(const Jet& a) {
  return chain(a, std::sinh(a.f), std::cosh(a.f), std::sinh(a.f));
}

using Point = std::array<Jet, 3>;
using Surface = std::function<Point(const Jet& u, const Jet& v)>;
using Curve = std::function<Point(const Jet& t)>;

Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Point operator*(const Jet& a, const Point& b) {
  return {a * b[0], a * b[1], a * b[2]};
}
Point constant(const Vec& a) {
  return {Jet(a[0]), Jet(a[1]), Jet(a[2])};
}
Point transformed(const Eigen::Matrix3d& matrix, const Point& p, const Vec& translation) {
  Point q;
  for (int i = 0; i < 3; ++i)
    q[i] =
        Jet(matrix(i, 0)) * p[0] + Jet(matrix(i, 1)) * p[1] + Jet(matrix(i, 2)) * p[2] + Jet(translation[i]);
  return q;
}
Surface inFrame(const Frame& frame, const Surface& local) {
  return [=](const Jet& u, const Jet& v) { return transformed(frame.axes, local(u, v), frame.origin); };
}

struct Fields {
  Vec3 point, normal;
  Matrix3 tensor;
};

/// X_u x X_v normalised and J I^-1 II I^-1 J^T.
Fields fieldsAt(const Surface& surface, Real u, Real v) {
  const Point x = surface(Jet(u, 1, 0), Jet(v, 0, 1));
  const auto part = [&](Real Jet::*which) { return Vec3(x[0].*which, x[1].*which, x[2].*which); };
  Eigen::Matrix<Real, 3, 2> jacobian;
  jacobian << part(&Jet::u), part(&Jet::v);
  Fields fields;
  fields.point = part(&Jet::f);
  fields.normal = part(&Jet::u).cross(part(&Jet::v)).normalized();
  Eigen::Matrix<Real, 2, 2> second;
  second << fields.normal.dot(part(&Jet::uu)), fields.normal.dot(part(&Jet::uv)),
      fields.normal.dot(part(&Jet::uv)), fields.normal.dot(part(&Jet::vv));
  const Eigen::Matrix<Real, 2, 2> inverse = (jacobian.transpose() * jacobian).inverse();
  fields.tensor = jacobian * inverse * second * inverse * jacobian.transpose();
  return fields;
}

/// A path (u(x), v(x)) with x in [-1, 1], lines or parabolas, each off by a radius.
struct Path {
  ChebyshevModel u, v;
  static Real at(const ChebyshevModel& model, Real x, Real off) {
    Real sum = off * model.radius();
    for (int k = 0; k <= model.degree(); ++k) sum += model.coefficient(k) * std::cos(k * std::acos(x));
    return sum;
  }
};

Path randomPath(double u, double v, double half, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto coordinate = [&](double middle) {
    const std::array<double, 3> series = {middle, half * unit(random), 0.3 * half * unit(random)};
    return ChebyshevModel::series(series, random() % 2 == 0 ? 0 : half * 1e-6);
  };
  ChebyshevModel first = coordinate(u);
  return {first, coordinate(v)};
}

int known = 0;

void expectHeld(const ChebyshevModel& model, Real x, Real truth, Real noise, const char* field) {
  if (!model.isKnown()) return;
  ++known;
  Real series = 0;
  for (int k = 0; k <= model.degree(); ++k) series += model.coefficient(k) * std::cos(k * std::acos(x));
  EXPECT_LE(std::abs(series - truth), model.radius() + noise)
      << field << " is " << static_cast<double>(truth) << " at " << static_cast<double>(x);
}

/// \param noise of the input, absolute for the normal, relative to the size of the others: frames are
/// orthonormal but for rounding.
void expectHeld(const SurfaceEvaluator& evaluator, const std::function<Fields(Real, Real)>& truth,
                const Path& path, double hint_u, double hint_v, Real noise = 4e-16L) {
  const SurfaceFields fields = evaluator.fields(path.u, path.v, hint_u, hint_v, Detail::Curvature);
  for (const Real off : {-1, 0, 1})
    for (int i = 0; i <= 8; ++i) {
      const Real x = -1 + i / 4.0L;
      const Fields there = truth(Path::at(path.u, x, off), Path::at(path.v, x, -off));
      const Real size = there.point.norm(), bent = there.tensor.norm();
      if (!there.normal.allFinite() || !there.tensor.allFinite()) continue;
      for (int d = 0; d < 3; ++d) {
        expectHeld(fields.point[d], x, there.point[d], noise * (1 + size), "point");
        expectHeld(fields.normal[d], x, there.normal[d], noise, "normal");
      }
      constexpr int rows[] = {0, 1, 2, 0, 1, 2}, columns[] = {0, 1, 2, 1, 2, 0};
      for (int k = 0; k < 6; ++k)
        expectHeld(fields.tensor[k], x, there.tensor(rows[k], columns[k]), 4 * noise * bent, "tensor");
    }
}

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
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> place(-3, 3);
  known = 0;
  for (int i = 0; i < 120; ++i)
    for (const Kind& kind : analyticKinds(random)) {
      SCOPED_TRACE(testing::Message() << kind.name << " " << i);
      const bool sphere = std::string_view(kind.name) == "sphere";  // turns over beyond its poles
      const double u = place(random), v = sphere ? place(random) / 3 : place(random);
      const Path path = randomPath(u, v, logUniform(random, -8, sphere ? -0.5 : 0), random);
      expectHeld(
          *kind.evaluator, [&](Real a, Real b) { return fieldsAt(kind.formula, a, b); }, path, u, v);
    }
  EXPECT_GT(known, 50000);
}

TEST(Evaluator, ConesNearTheApexAndSpindlesAreHeldOrUnknown) {
  std::mt19937_64 random(32);
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
    // Relative to the apex the parameter is known to rounding only; the models must say so themselves.
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
    const SurfaceFields fields =
        sphere->fields(ChebyshevModel::linear(0, 0.5, 0), ChebyshevModel(pole), 0, pole, Detail::Curvature);
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

// --- splines -----------------------------------------------------------------------------------------------

struct SplineData {
  SplineDirection u, v;
  std::vector<Vec> poles;
  std::vector<double> weights;

  std::shared_ptr<const SplineEvaluator> evaluator() const {
    return std::make_shared<SplineEvaluator>(u, v, poles, weights);
  }
};

using Homogeneous = std::array<Jet, 4>;

/// De Boor's triangle on the span that begins at knots[s].
Homogeneous deBoor(const SplineDirection& direction, int s, const Jet& t, std::vector<Homogeneous> poles) {
  const auto& [degree, knots, period] = direction;
  for (int level = 1; level <= degree; ++level)
    for (int j = degree; j >= level; --j) {
      const int i = s - degree + j;
      const Jet a =
          (t - Jet(knots[i])) * Jet(1 / (static_cast<Real>(knots[i + degree - level + 1]) - knots[i]));
      for (int d = 0; d < 4; ++d) poles[j][d] = (Jet(1) - a) * poles[j - 1][d] + a * poles[j][d];
    }
  return poles[degree];
}

int spanOf(const SplineDirection& direction, double hint) {
  const auto& [degree, knots, period] = direction;
  int s = degree;
  const int last = static_cast<int>(knots.size()) - degree - 2;
  while (s < last && (knots[s + 1] <= hint || knots[s] == knots[s + 1])) ++s;
  while (knots[s] == knots[s + 1]) --s;
  return s;
}

Surface formulaOf(const SplineData& spline, double hint_u, double hint_v) {
  const int su = spanOf(spline.u, hint_u), sv = spanOf(spline.v, hint_v);
  const int count_v = static_cast<int>(spline.v.knots.size()) - spline.v.degree - 1;
  return [=](const Jet& u, const Jet& v) {
    std::vector<Homogeneous> rows;
    for (int i = 0; i <= spline.u.degree; ++i) {
      std::vector<Homogeneous> row;
      for (int j = 0; j <= spline.v.degree; ++j) {
        const int index = (su - spline.u.degree + i) * count_v + sv - spline.v.degree + j;
        const Jet weight(spline.weights.empty() ? 1 : spline.weights[index]);
        Homogeneous pole;
        for (int d = 0; d < 3; ++d) pole[d] = weight * Jet(spline.poles[index][d]);
        pole[3] = weight;
        row.push_back(pole);
      }
      rows.push_back(deBoor(spline.v, sv, v, row));
    }
    const Homogeneous h = deBoor(spline.u, su, u, rows);
    return Point{h[0] / h[3], h[1] / h[3], h[2] / h[3]};
  };
}

SplineDirection randomDirection(int degree, int inner, std::mt19937_64& random) {
  SplineDirection direction{degree, std::vector<double>(degree + 1, 0.0), 0};
  std::uniform_real_distribution<double> place(0.1, 0.9);
  std::vector<double> knots;
  for (int k = 0; k < inner; ++k) {
    knots.push_back(place(random));
    if (degree > 1 && random() % 4 == 0)
      knots.push_back(knots.back());
    else if (degree > 2 && random() % 4 == 0)
      knots.push_back(std::nextafter(knots.back(), 1.0));
  }
  std::ranges::sort(knots);
  direction.knots.insert(direction.knots.end(), knots.begin(), knots.end());
  direction.knots.insert(direction.knots.end(), degree + 1, 1.0);
  return direction;
}

SplineData randomSpline(int p, int q, bool rational, double far, std::mt19937_64& random) {
  SplineData spline{randomDirection(p, static_cast<int>(random() % 4), random),
                    randomDirection(q, static_cast<int>(random() % 4), random),
                    {},
                    {}};
  const int rows = static_cast<int>(spline.u.knots.size()) - p - 1;
  const int columns = static_cast<int>(spline.v.knots.size()) - q - 1;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      spline.poles.push_back(Vec(i, j, 0) + 0.3 * test::randomVector(random) + far * Vec(1, -1, 1));
      if (rational) spline.weights.push_back(std::uniform_real_distribution<double>(0.3, 3)(random));
    }
  return spline;
}

double placeIn(const SplineDirection& direction, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double t = unit(random);
  const int s = spanOf(direction, t);
  return 0.5 * (direction.knots[s] + direction.knots[s + 1]);
}

TEST(Evaluator, SplinesAreHeldWithinAndBeyondTheSpanMeant) {
  std::mt19937_64 random(33);
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
        *splineEvaluator(spline.evaluator()), [&](Real a, Real b) { return fieldsAt(formula, a, b); }, path,
        u, v, 1e-18L);
  }
  EXPECT_GT(known, 20000);
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
  std::mt19937_64 random(34);
  for (int i = 0; i < 3000; ++i) {
    SplineData spline{crowdedDirection(1 + i % 5, random), crowdedDirection(1 + i % 3, random), {}, {}};
    const std::size_t count =
        (spline.u.knots.size() - spline.u.degree - 1) * (spline.v.knots.size() - spline.v.degree - 1);
    for (std::size_t k = 0; k < count; ++k) spline.poles.push_back(test::randomVector(random));
    const double u = placeIn(spline.u, random), v = placeIn(spline.v, random);
    const JetModel jet = spline.evaluator()->jet(ChebyshevModel(u), ChebyshevModel(v), u, v, 2);
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
    }
  }
}

TEST(Evaluator, PeriodicSplinesRepeat) {
  std::mt19937_64 random(34);
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
          [&](Real a, Real b) { return fieldsAt(formula, a - turns, b); }, path, u + turns, v, 1e-18L);
      const std::vector<double> knots = spline.evaluator()->knotsInside(0, {turns - 1e-9, turns + 1e-9});
      ASSERT_EQ(knots.size(), 1u);
      EXPECT_EQ(knots[0], turns);
    }
  }
}

// --- swept, offset and placed surfaces ---------------------------------------------------------------------

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
  return {{"line", LineEvaluator{a, b}, [=](const Jet& t) { return constant(a) + t * constant(b); }},
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
  std::mt19937_64 random(35);
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
          [&](Real a, Real b) { return fieldsAt(extruded, a, b); }, randomPath(t, other, half, random), t,
          other, 1e-17L);
      const Surface turned = [&](const Jet& u, const Jet& v) {
        const Point local = transformed(frame.axes.transpose(), curve.formula(v),
                                        Vec(-frame.axes.transpose() * frame.origin));
        const Point rotated = {cosine(u) * local[0] - sine(u) * local[1],
                               sine(u) * local[0] + cosine(u) * local[1], local[2]};
        return transformed(frame.axes, rotated, frame.origin);
      };
      expectHeld(
          *revolutionEvaluator(frame, curve.evaluator),
          [&](Real a, Real b) { return fieldsAt(turned, a, b); }, randomPath(other, t, half, random), other,
          t, 1e-14L);
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
  EXPECT_TRUE(
      cone->fields(ChebyshevModel(0), ChebyshevModel(0.1), 0, 0.1, Detail::Curvature).normal[0].isKnown());
}

/// The offset's fields from those of the basis: the tensor W (I - d W)^-1, the normal turned where the area does.
Fields offsetAt(const Fields& basis, Real distance) {
  const Matrix3 stretch = Matrix3::Identity() - distance * basis.tensor;
  const Real side = stretch.determinant() < 0 ? -1 : 1;
  return {basis.point + distance * basis.normal, side * basis.normal,
          side * basis.tensor * stretch.inverse()};
}

TEST(Evaluator, OffsetsAreHeldOnBothSidesOfTheFocus) {
  std::mt19937_64 random(36);
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
        [&](Real a, Real b) { return offsetAt(fieldsAt(formula, a, b), distance); }, path, u, v, 1e-17L);
  }
  EXPECT_GT(known, 10000);
  // By the focal distance: a cylinder moved onto its axis.
  const auto axis = offsetEvaluator(cylinderEvaluator(Frame(), 2), -2);
  const SurfaceFields fields =
      axis->fields(ChebyshevModel::linear(0, 0.1, 0), ChebyshevModel(0), 0, 0, Detail::Curvature);
  EXPECT_FALSE(fields.normal[0].isKnown());
  EXPECT_FALSE(fields.tensor[0].isKnown());
}

TEST(Evaluator, PlacedSurfacesAreHeld) {
  std::mt19937_64 random(37);
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    Placement placement{(i % 3 == 0 ? -1 : 1) * logUniform(random, -3, 3), randomRotation(random),
                        100 * test::randomVector(random)};
    if (i % 2 == 0) placement.orthogonal.col(1) *= -1;  // a mirror
    for (Kind& kind : analyticKinds(random)) {
      const Surface formula = [&](const Jet& u, const Jet& v) {
        return transformed(placement.scale * placement.orthogonal, kind.formula(u, v), placement.translation);
      };
      const Path path = randomPath(0.4, 0.2, logUniform(random, -6, -0.5), random);
      expectHeld(
          *placedEvaluator(std::move(kind.evaluator), placement),
          [&](Real a, Real b) { return fieldsAt(formula, a, b); }, path, 0.4, 0.2, 2e-15L);
    }
  }
}

TEST(SplineEvaluator, RefusesWhatIsNoSpline) {
  const auto make = [](SplineDirection u, SplineDirection v, std::size_t poles, std::vector<double> weights) {
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

TEST(SurfaceEvaluator, BeyondItsPolesASphereIsSeenFromInside) {
  const auto sphere = sphereEvaluator({}, 3);
  for (const double v : {0.0, 1.5, 1.7, 3.0}) {
    const SurfaceFields fields =
        sphere->fields(ChebyshevModel(0.3), ChebyshevModel(v), 0.3, v, Detail::TangentPlane);
    double outward = 0;
    for (int i = 0; i < 3; ++i) outward += fields.point[i].coefficient(0) * fields.normal[i].coefficient(0);
    EXPECT_NEAR(outward, std::cos(v) < 0 ? -3 : 3, 1e-12) << v;
  }
}

}  // namespace
}  // namespace seamwright
