// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include <seamwright/core/differential/jet.hpp>

/// Jets in closed form, written down by hand and not through the library.
namespace seamwright::test {

using Vec = Eigen::Vector3d;

/// Cylinder of radius r about z; normal X_u x X_v points outward.
inline SurfaceJet cylinder(double r, double u, double v) {
  const double c = std::cos(u), s = std::sin(u);
  SurfaceJet jet;
  jet.p = {r * c, r * s, v};
  jet.u = {-r * s, r * c, 0};
  jet.v = {0, 0, 1};
  jet.uu = {-r * c, -r * s, 0};
  jet.uuu = {r * s, -r * c, 0};
  return jet;
}

/// Sphere of radius r, u longitude, v latitude; normal outward.
inline SurfaceJet sphere(double r, double u, double v) {
  const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v);
  SurfaceJet jet;
  jet.p = r * Vec(cu * cv, su * cv, sv);
  jet.u = r * Vec(-su * cv, cu * cv, 0);
  jet.v = r * Vec(-cu * sv, -su * sv, cv);
  jet.uu = r * Vec(-cu * cv, -su * cv, 0);
  jet.uv = r * Vec(su * sv, -cu * sv, 0);
  jet.vv = r * Vec(-cu * cv, -su * cv, -sv);
  jet.uuu = r * Vec(su * cv, -cu * cv, 0);
  jet.uuv = r * Vec(cu * sv, su * sv, 0);
  jet.uvv = r * Vec(su * cv, -cu * cv, 0);
  jet.vvv = r * Vec(cu * sv, su * sv, -cv);
  return jet;
}

/// Torus, radii R of the ring and r of the tube; normal outward.
inline SurfaceJet torus(double R, double r, double u, double v) {
  const double cu = std::cos(u), su = std::sin(u), cv = std::cos(v), sv = std::sin(v),
               w = R + r * cv;
  SurfaceJet jet;
  jet.p = {w * cu, w * su, r * sv};
  jet.u = {-w * su, w * cu, 0};
  jet.v = {-r * sv * cu, -r * sv * su, r * cv};
  jet.uu = {-w * cu, -w * su, 0};
  jet.uv = {r * sv * su, -r * sv * cu, 0};
  jet.vv = {-r * cv * cu, -r * cv * su, -r * sv};
  jet.uuu = {w * su, -w * cu, 0};
  jet.uuv = {r * sv * cu, r * sv * su, 0};
  jet.uvv = {r * cv * su, -r * cv * cu, 0};
  jet.vvv = {r * sv * cu, r * sv * su, -r * cv};
  return jet;
}

/// Cone of half angle a, apex at the origin, v the distance along the ruling.
inline SurfaceJet cone(double a, double u, double v) {
  const double sa = std::sin(a), ca = std::cos(a), cu = std::cos(u), su = std::sin(u);
  SurfaceJet jet;
  jet.p = v * Vec(sa * cu, sa * su, ca);
  jet.u = v * Vec(-sa * su, sa * cu, 0);
  jet.v = {sa * cu, sa * su, ca};
  jet.uu = v * Vec(-sa * cu, -sa * su, 0);
  jet.uv = {-sa * su, sa * cu, 0};
  jet.uuu = v * Vec(sa * su, -sa * cu, 0);
  jet.uuv = {-sa * cu, -sa * su, 0};
  return jet;
}

/// The graph z = (a x^2 + 2 b x y + c y^2) / 2 at the origin: curvature tensor [[a, b], [b, c]] to
/// the normal +z.
inline SurfaceJet quadric(double a, double b, double c) {
  SurfaceJet jet;
  jet.u = {1, 0, 0};
  jet.v = {0, 1, 0};
  jet.uu = {0, 0, a};
  jet.uv = {0, 0, b};
  jet.vv = {0, 0, c};
  return jet;
}

/// The graph z = (c_30 x^3 + 3 c_21 x^2 y + 3 c_12 x y^2 + c_03 y^3) / 6 added to a graph at the
/// origin.
inline SurfaceJet withCubic(SurfaceJet graph, const Eigen::Vector4d& c) {
  graph.uuu.z() += c(0);
  graph.uuv.z() += c(1);
  graph.uvv.z() += c(2);
  graph.vvv.z() += c(3);
  return graph;
}

/// The jet of X(u(a, b), v(a, b)) with random u, v of Jacobian J at the point, by the chain rule.
inline SurfaceJet reparametrised(const SurfaceJet& x, const Eigen::Matrix2d& J,
                                 std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const auto pair = [&] {
    const double first = normal(random);
    return Eigen::Vector2d(first, normal(random));
  };
  const Eigen::Vector2d aa = pair(), ab = pair(), bb = pair();
  const Eigen::Vector2d aaa = pair(), aab = pair(), abb = pair(), bbb = pair();
  const Eigen::Vector2d a = J.col(0), b = J.col(1);
  using Direction = Eigen::Vector2d;
  const auto D1 = [&](const Direction& i) -> Vec { return i(0) * x.u + i(1) * x.v; };
  const auto D2 = [&](const Direction& i, const Direction& j) -> Vec {
    return i(0) * j(0) * x.uu + (i(0) * j(1) + i(1) * j(0)) * x.uv + i(1) * j(1) * x.vv;
  };
  const auto D3 = [&](const Direction& i, const Direction& j, const Direction& k) -> Vec {
    return i(0) * j(0) * k(0) * x.uuu +
           (i(0) * j(0) * k(1) + i(0) * j(1) * k(0) + i(1) * j(0) * k(0)) * x.uuv +
           (i(0) * j(1) * k(1) + i(1) * j(0) * k(1) + i(1) * j(1) * k(0)) * x.uvv +
           i(1) * j(1) * k(1) * x.vvv;
  };
  SurfaceJet y;
  y.p = x.p;
  y.u = D1(a);
  y.v = D1(b);
  y.uu = D2(a, a) + D1(aa);
  y.uv = D2(a, b) + D1(ab);
  y.vv = D2(b, b) + D1(bb);
  y.uuu = D3(a, a, a) + 3 * D2(a, aa) + D1(aaa);
  y.uuv = D3(a, a, b) + 2 * D2(a, ab) + D2(b, aa) + D1(aab);
  y.uvv = D3(a, b, b) + 2 * D2(b, ab) + D2(a, bb) + D1(abb);
  y.vvv = D3(b, b, b) + 3 * D2(b, bb) + D1(bbb);
  return y;
}

/// Every vector of the jet through a linear map, the point also through the translation.
inline SurfaceJet mapped(const SurfaceJet& x, const Eigen::Matrix3d& A,
                         const Vec& translation = Vec::Zero()) {
  SurfaceJet y;
  y.p = A * x.p + translation;
  y.u = A * x.u;
  y.v = A * x.v;
  y.uu = A * x.uu;
  y.uv = A * x.uv;
  y.vv = A * x.vv;
  y.uuu = A * x.uuu;
  y.uuv = A * x.uuv;
  y.uvv = A * x.uvv;
  y.vvv = A * x.vvv;
  return y;
}

/// The same point with u and v exchanged: the normal turns over.
inline SurfaceJet flipped(const SurfaceJet& x) {
  return {x.p, x.v, x.u, x.vv, x.uv, x.uu, x.vvv, x.uvv, x.uuv, x.uuu};
}

inline Eigen::Matrix3d randomRotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

inline Vec randomVector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

/// 10^x with x uniform: sizes from microns to kilometres occur equally often.
inline double logUniform(std::mt19937_64& random, double exponent_low, double exponent_high) {
  return std::pow(10.0,
                  std::uniform_real_distribution<double>(exponent_low, exponent_high)(random));
}

/// A random matrix of determinant > 0, condition below about 100.
inline Eigen::Matrix2d randomJacobian(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  while (true) {
    Eigen::Matrix2d J;
    J << normal(random), normal(random), normal(random), normal(random);
    if (J.determinant() > 0.05) return J;
  }
}

}  // namespace seamwright::test
