// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <seamwright/core/bezier/patch.hpp>

#include "exact_frenet.hpp"

/// Curvatures of rational patches without rounding but of the result.
namespace seamwright::test {

/// Partial of the homogeneous form.
inline DyadicRow exactPartial(const BezierPatch& patch, const Dyadic& u, const Dyadic& v, int k,
                              int l) {
  const auto differences = [](DyadicVector& c, int order) {
    Dyadic factor = 1;
    for (int i = 0; i < order; ++i) {
      factor = factor * Dyadic(static_cast<double>(c.size()) - 1);
      for (std::size_t j = 0; j + 1 < c.size(); ++j) c[j] = c[j + 1] - c[j];
      if (c.size() > 1) c.pop_back();
    }
    return factor;
  };
  DyadicRow result;
  for (int column = 0; column < 4; ++column) {
    DyadicVector along_u;
    for (int i = 0; i <= patch.degreeU(); ++i) {
      DyadicVector row;
      for (int j = 0; j <= patch.degreeV(); ++j)
        row.emplace_back(patch.homogeneousPoles()(i * (patch.degreeV() + 1) + j, column));
      const Dyadic factor = differences(row, l);
      along_u.push_back(factor * exactBernstein(row, v));
    }
    const Dyadic factor = differences(along_u, k);
    result[column] = factor * exactBernstein(along_u, u);
  }
  return result;
}

struct ExactShape {
  Eigen::Vector3d normal, along_u;
  long double twice_mean, gauss, change_along_u;
};

/// About the point, w A_kl - w_kl A = w^2 X_kl + (...): with X_uu, X_uv, X_vv up to tangents and
/// third partials that fit them, by parameters in which the weight has no first derivative. All but
/// roots and quotients is exact.
inline ExactShape exactShape(const BezierPatch& patch, double u, double v) {
  const Dyadic one = 1;
  const auto h = [&](int k, int l) { return exactPartial(patch, u, v, k, l); };
  const DyadicRow point = h(0, 0);
  const Dyadic w = point[3];
  const auto about = [&](const DyadicRow& row) {
    return combined(w, spaceOf(row), row[3], spaceOf(point));
  };
  const auto row = [](const DyadicSpace& a) { return DyadicRow{a[0], a[1], a[2], Dyadic(0)}; };
  const DyadicRow hu = h(1, 0);
  const DyadicSpace xu = about(hu), xv = about(h(0, 1)), xuu = about(h(2, 0)), xuv = about(h(1, 1)),
                    xvv = about(h(0, 2));
  const DyadicSpace xuuu = plus(scaled(w, about(h(3, 0))), scaled(3 * hu[3], xuu));  // times w
  const DyadicSpace c = cross(row(xu), row(xv));
  const Dyadic E = dot(xu, xu), F = dot(xu, xv), G = dot(xv, xv), D = dot(c, c);
  const Dyadic L = dot(c, xuu), M = dot(c, xuv), N = dot(c, xvv);
  const long double W = w.abs().approximate(), C = std::sqrt(D.approximate()),
                    U = std::sqrt(E.approximate());
  const Dyadic alpha = G * dot(xuu, xu) - F * dot(xuu, xv),
               beta = E * dot(xuu, xv) - F * dot(xuu, xu);
  const Dyadic change = dot(c, xuuu) * D - 3 * w * (alpha * L + beta * M);
  const auto unit = [](const DyadicSpace& a, long double size) {
    return Eigen::Vector3d(static_cast<double>(a[0].approximate() / size),
                           static_cast<double>(a[1].approximate() / size),
                           static_cast<double>(a[2].approximate() / size));
  };
  const long double sign = w.sign();
  return {unit(c, C), unit(xu, U), (E * N - 2 * F * M + G * L).approximate() / C / C / C * W * W,
          (L * N - M * M).approximate() / C / C / C / C * W * W * W * W,
          sign * change.approximate() / C / C / C / U / U / U * W * W * W};
}

struct ExactPartials {
  Eigen::Vector3d u, uu, uv;
};

/// With B_kl = w A_kl - w_kl A: w^2 X_u = B_u, w^3 X_uu = w B_uu - 2 w_u B_u, w^3 X_uv = w B_uv -
/// w_u B_v - w_v B_u.
inline ExactPartials exactPartials(const BezierPatch& patch, double u, double v) {
  const auto h = [&](int k, int l) { return exactPartial(patch, u, v, k, l); };
  const DyadicRow point = h(0, 0), hu = h(1, 0), hv = h(0, 1);
  const Dyadic w = point[3];
  const auto about = [&](const DyadicRow& row) {
    return combined(w, spaceOf(row), row[3], spaceOf(point));
  };
  const DyadicSpace xu = about(hu), xv = about(hv);
  const DyadicSpace xuu = combined(w, about(h(2, 0)), 2 * hu[3], xu),
                    xuv = combined(1, combined(w, about(h(1, 1)), hu[3], xv), hv[3], xu);
  const auto divided = [&](const DyadicSpace& a, int power) {
    const long double W = std::pow(w.approximate(), static_cast<long double>(power));
    return Eigen::Vector3d(static_cast<double>(a[0].approximate() / W),
                           static_cast<double>(a[1].approximate() / W),
                           static_cast<double>(a[2].approximate() / W));
  };
  return {divided(xu, 2), divided(xuu, 3), divided(xuv, 3)};
}

}  // namespace seamwright::test
