// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <seamwright/core/enclosure/surface.hpp>

#include "surfaces.hpp"

/// Surfaces as formulas of third-order jets in long double, and their fields along paths.
namespace seamwright::test::formulas {

using Real = long double;
using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

/// Value and partial derivatives to third order of a function of (u, v).
struct Jet {
  Real f = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  Real uuu = 0, uuv = 0, uvv = 0, vvv = 0;
  Jet() = default;
  Jet(Real value) : f(value) {}  // NOLINT(google-explicit-constructor)
  Jet(Real value, Real du, Real dv) : f(value), u(du), v(dv) {}
};

inline Jet operator+(const Jet& a, const Jet& b) {
  Jet c(a.f + b.f, a.u + b.u, a.v + b.v);
  c.uu = a.uu + b.uu, c.uv = a.uv + b.uv, c.vv = a.vv + b.vv;
  c.uuu = a.uuu + b.uuu, c.uuv = a.uuv + b.uuv, c.uvv = a.uvv + b.uvv, c.vvv = a.vvv + b.vvv;
  return c;
}
inline Jet operator*(const Jet& a, const Jet& b) {
  Jet c(a.f * b.f, a.u * b.f + a.f * b.u, a.v * b.f + a.f * b.v);
  c.uu = a.uu * b.f + 2 * a.u * b.u + a.f * b.uu;
  c.uv = a.uv * b.f + a.u * b.v + a.v * b.u + a.f * b.uv;
  c.vv = a.vv * b.f + 2 * a.v * b.v + a.f * b.vv;
  c.uuu = a.uuu * b.f + 3 * (a.uu * b.u + a.u * b.uu) + a.f * b.uuu;
  c.uuv = a.uuv * b.f + a.uu * b.v + a.v * b.uu + 2 * (a.uv * b.u + a.u * b.uv) + a.f * b.uuv;
  c.uvv = a.uvv * b.f + a.vv * b.u + a.u * b.vv + 2 * (a.uv * b.v + a.v * b.uv) + a.f * b.uvv;
  c.vvv = a.vvv * b.f + 3 * (a.vv * b.v + a.v * b.vv) + a.f * b.vvv;
  return c;
}
inline Jet operator-(const Jet& a, const Jet& b) {
  return a + Jet(-1) * b;
}
/// g(a) from the derivatives of g.
inline Jet chain(const Jet& a, Real g, Real g1, Real g2, Real g3) {
  Jet c(g, g1 * a.u, g1 * a.v);
  c.uu = g1 * a.uu + g2 * a.u * a.u;
  c.uv = g1 * a.uv + g2 * a.u * a.v;
  c.vv = g1 * a.vv + g2 * a.v * a.v;
  c.uuu = g1 * a.uuu + 3 * g2 * a.u * a.uu + g3 * a.u * a.u * a.u;
  c.uuv = g1 * a.uuv + g2 * (a.uu * a.v + 2 * a.u * a.uv) + g3 * a.u * a.u * a.v;
  c.uvv = g1 * a.uvv + g2 * (a.vv * a.u + 2 * a.v * a.uv) + g3 * a.u * a.v * a.v;
  c.vvv = g1 * a.vvv + 3 * g2 * a.v * a.vv + g3 * a.v * a.v * a.v;
  return c;
}
inline Jet operator/(const Jet& a, const Jet& b) {
  return a *
         chain(b, 1 / b.f, -1 / (b.f * b.f), 2 / (b.f * b.f * b.f), -6 / (b.f * b.f * b.f * b.f));
}
inline Jet cosine(const Jet& a) {
  return chain(a, std::cos(a.f), -std::sin(a.f), -std::cos(a.f), std::sin(a.f));
}
inline Jet sine(const Jet& a) {
  return chain(a, std::sin(a.f), std::cos(a.f), -std::sin(a.f), -std::cos(a.f));
}

inline Jet hyperbolicCosine(const Jet& a) {
  return chain(a, std::cosh(a.f), std::sinh(a.f), std::cosh(a.f), std::sinh(a.f));
}
inline Jet hyperbolicSine(const Jet& a) {
  return chain(a, std::sinh(a.f), std::cosh(a.f), std::sinh(a.f), std::cosh(a.f));
}

using Point = std::array<Jet, 3>;
using Surface = std::function<Point(const Jet& u, const Jet& v)>;
using Curve = std::function<Point(const Jet& t)>;

inline Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator*(const Jet& a, const Point& b) {
  return {a * b[0], a * b[1], a * b[2]};
}
inline Point constant(const Vec& a) {
  return {Jet(a[0]), Jet(a[1]), Jet(a[2])};
}
inline Point transformed(const Eigen::Matrix3d& matrix, const Point& p, const Vec& translation) {
  Point q;
  for (int i = 0; i < 3; ++i)
    q[i] = Jet(matrix(i, 0)) * p[0] + Jet(matrix(i, 1)) * p[1] + Jet(matrix(i, 2)) * p[2] +
           Jet(translation[i]);
  return q;
}
inline Surface inFrame(const Frame& frame, const Surface& local) {
  return [=](const Jet& u, const Jet& v) {
    return transformed(frame.axes, local(u, v), frame.origin);
  };
}

struct Fields {
  Vec3 point, normal;
  Matrix3 tensor;
  Vec3 u, v;
  /// The third derivative of the height over the tangent plane in the direction of the tangential
  /// part of d, times the cube of its length.
  std::function<Real(const Vec3& d)> change;
};

/// X_u x X_v normalised and J I^-1 II I^-1 J^T.
inline Fields fieldsAt(const Surface& surface, Real u, Real v) {
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
  fields.u = part(&Jet::u), fields.v = part(&Jet::v);
  const Vec3 n = fields.normal, uu = part(&Jet::uu), uv = part(&Jet::uv), vv = part(&Jet::vv);
  const Vec3 uuu = part(&Jet::uuu), uuv = part(&Jet::uuv), uvv = part(&Jet::uvv),
             vvv = part(&Jet::vvv);
  const Eigen::Matrix<Real, 2, 3> parameters = inverse * jacobian.transpose();
  fields.change = [=](const Vec3& d) {
    const Eigen::Matrix<Real, 2, 1> a = parameters * d;
    const Vec3 along = a[0] * a[0] * uu + 2 * a[0] * a[1] * uv + a[1] * a[1] * vv;
    const Eigen::Matrix<Real, 2, 1> b = -parameters * along;
    const Vec3 third = a[0] * a[0] * a[0] * uuu + 3 * a[0] * a[0] * a[1] * uuv +
                       3 * a[0] * a[1] * a[1] * uvv + a[1] * a[1] * a[1] * vvv;
    const Vec3 mixed = a[0] * b[0] * uu + (a[0] * b[1] + a[1] * b[0]) * uv + a[1] * b[1] * vv;
    return n.dot(third + 3 * mixed);
  };
  return fields;
}

/// A path (u(x), v(x)) with x in [-1, 1], lines or parabolas, each off by a radius.
struct Path {
  ChebyshevModel u, v;
  static Real at(const ChebyshevModel& model, Real x, Real off) {
    Real sum = off * model.radius();
    for (int k = 0; k <= model.degree(); ++k)
      sum += model.coefficient(k) * std::cos(k * std::acos(x));
    return sum;
  }
};

inline Path randomPath(double u, double v, double half, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto coordinate = [&](double middle) {
    const std::array<double, 3> series = {middle, half * unit(random), 0.3 * half * unit(random)};
    return ChebyshevModel::series(series, random() % 2 == 0 ? 0 : half * 1e-6);
  };
  ChebyshevModel first = coordinate(u);
  return {first, coordinate(v)};
}

inline int known = 0;

inline void expectHeld(const ChebyshevModel& model, Real x, Real truth, Real noise,
                       const char* field) {
  if (!model.isKnown()) return;
  ++known;
  Real series = 0;
  for (int k = 0; k <= model.degree(); ++k)
    series += model.coefficient(k) * std::cos(k * std::acos(x));
  EXPECT_LE(std::abs(series - truth), model.radius() + noise)
      << field << " is " << static_cast<double>(truth) << " at " << static_cast<double>(x);
}

/// The partial derivatives, and the cubic form in directions that determine it.
inline void expectChangeHeld(const SurfaceFields& fields, const Fields& there, Real x, Real noise) {
  for (int d = 0; d < 3; ++d) {
    expectHeld(fields.u[d], x, there.u[d], 2 * noise * there.u.norm(), "X_u");
    expectHeld(fields.v[d], x, there.v[d], 2 * noise * there.v.norm(), "X_v");
  }
  const std::array<Vec, 7> directions = {Vec(1, 0, 0), Vec(0, 1, 0),  Vec(0, 0, 1), Vec(1, 1, 0),
                                         Vec(0, 1, 1), Vec(1, 0, -1), Vec(1, -2, 3)};
  Real largest = there.tensor.squaredNorm();
  for (const Vec& d : directions)
    largest = std::max(largest, std::abs(there.change(d.cast<Real>())));
  for (const Vec& d : directions)
    expectHeld(fields.change(constantModel(d)), x, there.change(d.cast<Real>()),
               64 * noise * largest, "change of curvature");
}

/// \param noise of the input, absolute for the normal, relative to the size of the others: frames
/// are orthonormal but for rounding.
inline void expectHeld(const SurfaceEvaluator& evaluator,
                       const std::function<Fields(Real, Real)>& truth, const Path& path,
                       double hint_u, double hint_v, Real noise = 1e-15L) {
  const SurfaceFields fields =
      evaluator.fields(path.u, path.v, hint_u, hint_v, Detail::CurvatureChange);
  const SurfaceFields plane =
      evaluator.fields(path.u, path.v, hint_u, hint_v, Detail::TangentPlane);
  const auto is_known = [](const ChebyshevModel& model) { return model.isKnown(); };
  if (plane.bounds_curvature && std::ranges::all_of(plane.normal, is_known)) {
    EXPECT_TRUE(std::ranges::all_of(fields.tensor, is_known));
  }
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
        expectHeld(fields.tensor[k], x, there.tensor(rows[k], columns[k]), 4 * noise * bent,
                   "tensor");
      expectChangeHeld(fields, there, x, noise);
    }
}

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
inline Homogeneous deBoor(const SplineDirection& direction, int s, const Jet& t,
                          std::vector<Homogeneous> poles) {
  const auto& [degree, knots, period] = direction;
  for (int level = 1; level <= degree; ++level)
    for (int j = degree; j >= level; --j) {
      const int i = s - degree + j;
      const Jet a = (t - Jet(knots[i])) *
                    Jet(1 / (static_cast<Real>(knots[i + degree - level + 1]) - knots[i]));
      for (int d = 0; d < 4; ++d) poles[j][d] = (Jet(1) - a) * poles[j - 1][d] + a * poles[j][d];
    }
  return poles[degree];
}

inline int spanOf(const SplineDirection& direction, double hint) {
  const auto& [degree, knots, period] = direction;
  int s = degree;
  const int last = static_cast<int>(knots.size()) - degree - 2;
  while (s < last && (knots[s + 1] <= hint || knots[s] == knots[s + 1])) ++s;
  while (knots[s] == knots[s + 1]) --s;
  return s;
}

inline Surface formulaOf(const SplineData& spline, double hint_u, double hint_v) {
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

inline SplineDirection randomDirection(int degree, int inner, std::mt19937_64& random) {
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

inline SplineData randomSpline(int p, int q, bool rational, double far, std::mt19937_64& random) {
  SplineData spline{randomDirection(p, static_cast<int>(random() % 4), random),
                    randomDirection(q, static_cast<int>(random() % 4), random),
                    {},
                    {}};
  const int rows = static_cast<int>(spline.u.knots.size()) - p - 1;
  const int columns = static_cast<int>(spline.v.knots.size()) - q - 1;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      spline.poles.push_back(Vec(i, j, 0) + 0.3 * test::randomVector(random) + far * Vec(1, -1, 1));
      if (rational)
        spline.weights.push_back(std::uniform_real_distribution<double>(0.3, 3)(random));
    }
  return spline;
}

inline double placeIn(const SplineDirection& direction, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double t = unit(random);
  const int s = spanOf(direction, t);
  return 0.5 * (direction.knots[s] + direction.knots[s + 1]);
}

}  // namespace seamwright::test::formulas
