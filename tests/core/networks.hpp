// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <seamwright/core/join/network/network.hpp>
#include <tuple>
#include <utility>
#include <vector>

#include "spline_surfaces.hpp"

/// Smooth networks of surfaces by closed constructions.
namespace seamwright::test {

struct Net {
  std::vector<NetworkSurface> surfaces;
  std::vector<NetworkSeam> seams;
};

inline NetworkResult joined(const Net& net, const NetworkOptions& options = {}) {
  return nearestNetwork(net.surfaces, net.seams, options);
}

/// The part of a surface between two knots of full multiplicity in each direction; first poles and
/// their number.
inline BSplineSurface part(const BSplineSurface& whole, std::array<double, 2> u,
                           std::array<double, 2> v) {
  const auto cut = [](const std::vector<double>& knots, int degree, std::array<double, 2> range,
                      int& first) {
    std::vector<double> result(1, range[0]);
    first = 0;
    for (std::size_t i = 0; i < knots.size(); ++i) {
      if (knots[i] < range[0]) ++first;
      if (knots[i] >= range[0] && knots[i] <= range[1]) result.push_back(knots[i]);
    }
    // The whole has its ends degree + 1 times, inner cuts degree times.
    if (std::count(result.begin(), result.end(), range[0]) > degree + 1)
      result.erase(result.begin());
    if (std::count(result.begin(), result.end(), range[1]) < degree + 1) result.push_back(range[1]);
    first = std::max(first - 1, 0);
    return result;
  };
  BSplineSurface result = whole;
  int first_u = 0, first_v = 0;
  result.knots_u = cut(whole.knots_u, whole.degree_u, u, first_u);
  result.knots_v = cut(whole.knots_v, whole.degree_v, v, first_v);
  result.poles.resize(static_cast<Eigen::Index>(result.countU()) * result.countV(), 4);
  for (int i = 0; i < result.countU(); ++i)
    for (int j = 0; j < result.countV(); ++j)
      result.poles.row(static_cast<Eigen::Index>(i) * result.countV() + j) =
          whole.poles.row(static_cast<Eigen::Index>(first_u + i) * whole.countV() + first_v + j);
  return result;
}

/// One bicubic surface of class C^2 of about 10 mm by 10 mm a face, cut into m x n faces of that
/// many spans a side and unequal width.
inline Net grid(int m, int n, int spans, std::mt19937_64& random, int order = 1) {
  std::uniform_real_distribution<double> width(0.7, 1.4), height(-2, 2);
  const auto cutsOf = [&](int count) {
    std::vector<double> cuts = {0};
    for (int i = 0; i < count; ++i) cuts.push_back(cuts.back() + width(random));
    return cuts;
  };
  const std::vector<double> cuts_u = cutsOf(m), cuts_v = cutsOf(n);
  const auto knotsOf = [&](const std::vector<double>& cuts) {
    std::vector<double> knots(4, cuts.front());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      for (int k = 1; k < spans; ++k)
        knots.push_back(std::lerp(cuts[i - 1], cuts[i], k / (1.0 * spans)));
      knots.push_back(cuts[i]);
    }
    knots.insert(knots.end(), 3, cuts.back());
    return knots;
  };
  BSplineSurface whole;
  whole.degree_u = whole.degree_v = 3;
  whole.knots_u = knotsOf(cuts_u);
  whole.knots_v = knotsOf(cuts_v);
  whole.poles.resize(static_cast<Eigen::Index>(whole.countU()) * whole.countV(), 4);
  const auto greville = [](const std::vector<double>& knots, int i) {
    return 10 * (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3;
  };
  for (int i = 0; i < whole.countU(); ++i)
    for (int j = 0; j < whole.countV(); ++j)
      whole.poles.row(static_cast<Eigen::Index>(i) * whole.countV() + j)
          << greville(whole.knots_u, i) + height(random) / 2,
          greville(whole.knots_v, j) + height(random) / 2, height(random), 1;
  for (int k = 1; k < m; ++k)
    for (int times = 0; times < 2; ++times) whole = withKnot(whole, SurfaceDirection::U, cuts_u[k]);
  for (int k = 1; k < n; ++k)
    for (int times = 0; times < 2; ++times) whole = withKnot(whole, SurfaceDirection::V, cuts_v[k]);
  Net net;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      net.surfaces.push_back({part(whole, {cuts_u[i], cuts_u[i + 1]}, {cuts_v[j], cuts_v[j + 1]})});
      const int own = i * n + j;
      if (i > 0)
        net.seams.push_back({{own - n, own}, {PatchEdge::U1, PatchEdge::U0}, false, order});
      if (j > 0)
        net.seams.push_back({{own - 1, own}, {PatchEdge::V1, PatchEdge::V0}, false, order});
    }
  return net;
}

/// Bicubic faces around a vertex, all on the graph z = f(x, y) of one cubic polynomial, over
/// quadrilaterals with corners 0, r(i), r(i) + r(i + 1) + w(i), r(i + 1), where r(i) is the end of
/// face i's edge v = 0 and r(i + 1) that of its edge u = 0.
inline Net fan(const std::vector<Eigen::Vector2d>& r, const std::vector<Eigen::Vector2d>& w,
               bool closed, std::mt19937_64& random) {
  std::uniform_real_distribution<double> height(-1, 1);
  std::map<std::pair<int, int>, double> f;
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j) f[{i, j}] = height(random) * std::pow(0.12, i + j - 1);
  const auto z = [&](const Eigen::Vector2d& p) {
    double sum = 0;
    for (const auto& [power, factor] : f)
      sum += factor * std::pow(p.x(), power.first) * std::pow(p.y(), power.second);
    return sum;
  };
  // The bicubic polynomial through its values at 4 x 4 places.
  Eigen::Matrix4d bernstein;
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 4; ++i)
      bernstein(k, i) = choose(3, i) * std::pow(k / 3.0, i) * std::pow(1 - k / 3.0, 3 - i);
  const Eigen::Matrix4d inverse = bernstein.inverse();
  Net net;
  const int count = static_cast<int>(w.size());
  for (int s = 0; s < count; ++s) {
    const Eigen::Vector2d& a = r[s];
    const Eigen::Vector2d& b = r[(s + 1) % r.size()];
    BSplineSurface face;
    face.degree_u = face.degree_v = 3;
    face.knots_u = face.knots_v = clampedKnots(3);
    face.poles.resize(16, 4);
    face.poles.col(3).setOnes();
    for (int d = 0; d < 3; ++d) {
      Eigen::Matrix4d values;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          const double u = i / 3.0, v = j / 3.0;
          const Eigen::Vector2d p = u * a + v * b + u * v * w[s];
          values(i, j) = d < 2 ? p(d) : z(p);
        }
      const Eigen::Matrix4d poles = inverse * values * inverse.transpose();
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) face.poles(4 * i + j, d) = poles(i, j);
    }
    net.surfaces.push_back({face});
    if (s + 1 < count || closed)
      net.seams.push_back({{s, (s + 1) % count}, {PatchEdge::U0, PatchEdge::V0}, false, 1});
  }
  return net;
}

/// A fan with the symmetry of a regular vertex polygon in its plan.
inline Net regularFan(int valence, std::mt19937_64& random) {
  std::vector<Eigen::Vector2d> r, w;
  for (int i = 0; i < valence; ++i) {
    const double angle = 2 * std::numbers::pi * i / valence;
    r.emplace_back(10 * std::cos(angle), 10 * std::sin(angle));
  }
  for (int i = 0; i < valence; ++i) w.push_back(0.1 * (r[i] + r[(i + 1) % valence]));
  return fan(r, w, true, random);
}

/// A smooth closed surface of six bicubic faces, like a ball of that radius: the symmetry of the
/// cube, and c = d = 1, e from -1 to 1 along each seam, leave two numbers free, of which one is the
/// size and the other makes it round.
inline Net ball(double radius) {
  const double a = radius / std::sqrt(3.0), d = 1.3 * a, b = 3 * a - 2 * d, f = (11 * b - a) / 6,
               g = (7 * d - a) / 3 - f;
  // Of the face z > 0; rows by x, columns by y.
  const auto pole = [&](int i, int j) -> Vec {
    const auto isEnd = [](int k) { return k == 0 || k == 3; };
    const double x = i < 2 ? -1 : 1, y = j < 2 ? -1 : 1;
    if (isEnd(i) && isEnd(j)) return {x * a, y * a, a};
    if (isEnd(i)) return {x * d, y * b, d};
    if (isEnd(j)) return {x * b, y * d, d};
    return {x * f, y * f, g};
  };
  Net net;
  // Turned about axes; proper rotations, so that all normals point outwards alike.
  std::vector<Eigen::Matrix3d> turns(6);
  turns[0] << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  turns[1] << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  turns[2] << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  turns[3] << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  turns[4] << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  turns[5] << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  for (const Eigen::Matrix3d& turn : turns) {
    BSplineSurface face;
    face.degree_u = face.degree_v = 3;
    face.knots_u = face.knots_v = clampedKnots(3);
    face.poles.resize(16, 4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) face.poles.row(4 * i + j) << (turn * pole(i, j)).transpose(), 1;
    net.surfaces.push_back({face});
  }
  // Edges that share their ends.
  const std::array edges = {PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1};
  const auto end = [&](int s, PatchEdge edge, int k) -> Vec {
    const int i = edge == PatchEdge::U0 ? 0 : edge == PatchEdge::U1 ? 3 : 3 * k;
    const int j = edge == PatchEdge::V0 ? 0 : edge == PatchEdge::V1 ? 3 : 3 * k;
    return net.surfaces[s].surface.poles.row(4 * i + j).head<3>();
  };
  for (int s = 0; s < 6; ++s)
    for (int t = s + 1; t < 6; ++t)
      for (const PatchEdge one : edges)
        for (const PatchEdge other : edges)
          for (const bool reversed : {false, true})
            if ((end(s, one, 0) - end(t, other, reversed ? 1 : 0)).norm() < 1e-9 &&
                (end(s, one, 1) - end(t, other, reversed ? 0 : 1)).norm() < 1e-9)
              net.seams.push_back({{s, t}, {one, other}, reversed, 1});
  return net;
}

/// Each coordinate of the poles of that many rows along each seam is moved by up to that noise.
inline void disturb(Net& net, double noise, int rows, std::mt19937_64& random) {
  std::uniform_real_distribution<double> offset(-noise, noise);
  std::vector<std::vector<bool>> near;
  for (const NetworkSurface& surface : net.surfaces)
    near.emplace_back(surface.surface.poles.rows(), false);
  for (const NetworkSeam& seam : net.seams)
    for (int side = 0; side < 2; ++side) {
      const BSplineSurface& s = net.surfaces[seam.surfaces[side]].surface;
      const int nu = s.countU(), nv = s.countV();
      for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) {
          const std::array<int, 4> distance = {i, nu - 1 - i, j, nv - 1 - j};
          if (distance[static_cast<std::size_t>(seam.edges[side])] < rows)
            near[seam.surfaces[side]][static_cast<std::size_t>(i) * nv + j] = true;
        }
    }
  for (std::size_t s = 0; s < net.surfaces.size(); ++s)
    for (std::size_t k = 0; k < near[s].size(); ++k)
      if (near[s][k])
        for (int d = 0; d < 3; ++d)
          net.surfaces[s].surface.poles(static_cast<Eigen::Index>(k), d) += offset(random);
}

}  // namespace seamwright::test
