// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <seamwright/core/bezier/curve.hpp>

#include "exact.hpp"

/// Curvature, torsion and change of curvature of rational Bézier curves without rounding but of the
/// result.
namespace seamwright::test {

using DyadicRow = std::array<Dyadic, 4>;
using DyadicSpace = std::array<Dyadic, 3>;

inline DyadicSpace cross(const DyadicRow& a, const DyadicRow& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class A, class B>
Dyadic dot(const A& a, const B& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// s a - r b
inline DyadicSpace combined(const Dyadic& s, const DyadicSpace& a, const Dyadic& r,
                            const DyadicSpace& b) {
  return {s * a[0] - r * b[0], s * a[1] - r * b[1], s * a[2] - r * b[2]};
}

inline DyadicSpace plus(const DyadicSpace& a, const DyadicSpace& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline DyadicSpace scaled(const Dyadic& s, const DyadicSpace& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

inline DyadicSpace spaceOf(const DyadicRow& row) {
  return {row[0], row[1], row[2]};
}

/// Derivative of that order of the homogeneous form.
inline DyadicRow exactDerivative(const HomogeneousPoles& poles, const Dyadic& t, int order) {
  DyadicRow result;
  for (int column = 0; column < 4; ++column) {
    DyadicVector c = exact(poles.col(column));
    Dyadic factor = 1;
    for (int k = 0; k < order; ++k) {
      factor = factor * Dyadic(static_cast<double>(c.size()) - 1);
      for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] = c[i + 1] - c[i];
      if (c.size() > 1) c.pop_back();
    }
    result[column] = factor * exactBernstein(c, t);
  }
  return result;
}

struct ExactFigures {
  long double speed, kappa, tau, kappa_s;
};

/// With H = (A, w) and c = w A' x A'' - w' A x A'' + w'' A x A', v = w A' - w' A: X' = v / w^2, X'
/// x X'' = c / w^3, det(X', X'', X''') = det(H, H', H'', H''') / w^4, so kappa = |c| w^3 / |v|^3.
inline ExactFigures exactFigures(const BezierCurve& curve, double t) {
  std::array<DyadicRow, 4> h;
  for (int k = 0; k < 4; ++k) h[k] = exactDerivative(curve.homogeneousPoles(), t, k);
  const Dyadic w = h[0][3], w1 = h[1][3], w2 = h[2][3], w3 = h[3][3];
  const DyadicSpace v = combined(w, spaceOf(h[1]), w1, spaceOf(h[0])),
                    v_t = combined(w, spaceOf(h[2]), w2, spaceOf(h[0]));
  const DyadicSpace c =
      plus(combined(w, cross(h[1], h[2]), w1, cross(h[0], h[2])), scaled(w2, cross(h[0], h[1])));
  const DyadicSpace c_t =
      plus(combined(w, cross(h[1], h[3]), w1, cross(h[0], h[3])), scaled(w3, cross(h[0], h[1])));
  const Dyadic determinant = w * dot(cross(h[1], h[2]), h[3]) - w1 * dot(cross(h[0], h[2]), h[3]) +
                             w2 * dot(cross(h[0], h[1]), h[3]) - w3 * dot(cross(h[0], h[1]), h[2]);
  const Dyadic cc = dot(c, c), vv = dot(v, v);
  const long double W = w.abs().approximate(), C = std::sqrt(cc.approximate()),
                    V = std::sqrt(vv.approximate());
  const long double kappa = C / V * W / V * W / V * W;
  const Dyadic change = dot(c, c_t) * w * vv + 3 * w1 * cc * vv - 3 * w * dot(v, v_t) * cc;
  return {V / W / W, kappa, determinant.approximate() / C * W / C * W,
          kappa * (change.approximate() / (cc * w * vv).approximate()) / V * W * W};
}

}  // namespace seamwright::test
