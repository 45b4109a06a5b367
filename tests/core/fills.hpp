// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/core/seam/patch_side.hpp>
#include <vector>

#include "joins.hpp"

/// Holes: random ones, and holes in surfaces that are known.
namespace seamwright::test {

/// A function of (x, y) with its first and second derivatives.
struct Height {
  double value = 0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  Eigen::Matrix2d bend = Eigen::Matrix2d::Zero();
};

inline Height operator*(const Height& f, const Height& g) {
  return {f.value * g.value, f.value * g.slope + g.value * f.slope,
          f.value * g.bend + g.value * f.bend + f.slope * g.slope.transpose() +
              g.slope * f.slope.transpose()};
}
inline Height operator+(const Height& f, const Height& g) {
  return {f.value + g.value, f.slope + g.slope, f.bend + g.bend};
}
inline Height operator*(double s, const Height& f) {
  return {s * f.value, s * f.slope, s * f.bend};
}
inline Height constant(double value) {
  return {value};
}
inline Height root(const Height& f) {
  const double r = std::sqrt(f.value);
  return {r, f.slope / (2 * r), f.bend / (2 * r) - f.slope * f.slope.transpose() / (4 * r * r * r)};
}

/// A surface z = f(x, y).
using Graph = std::function<Height(const Height& x, const Height& y)>;

inline Height at(const Graph& graph, const Eigen::Vector2d& place) {
  return graph({place.x(), {1, 0}}, {place.y(), {0, 1}});
}

inline Graph plane() {
  return [](const Height& x, const Height& y) { return 0.3 * x + -0.2 * y + constant(1); };
}
inline Graph paraboloid(double k1, double k2) {
  return [=](const Height& x, const Height& y) { return k1 / 2 * (x * x) + k2 / 2 * (y * y); };
}
inline Graph sphere(double radius) {
  return [=](const Height& x, const Height& y) {
    return root(constant(radius * radius) + -1.0 * (x * x) + -1.0 * (y * y));
  };
}
/// The outside of a torus about the y axis, above the origin: curvatures 1 / tube and 1 / (ring +
/// tube) there.
inline Graph torus(double ring, double tube) {
  return [=](const Height& x, const Height& y) {
    const Height distance = constant(ring) + root(constant(tube * tube) + -1.0 * (y * y));
    return root(distance * distance + -1.0 * (x * x));
  };
}

/// The side of a hole over the line from a to b, of degree 5, with a cross-boundary derivative of
/// degree 3: derivatives at the ends are those of the graph, of second order along the edge, of
/// first order across.
inline FillSide graphSide(const Graph& graph, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a,
                        out = Eigen::Vector2d(along.y(), -along.x()).normalized() * 3;
  Poles edge(6, 3), cross(4, 3);
  for (const bool end : {false, true}) {
    const Eigen::Vector2d place = end ? b : a;
    const Height f = at(graph, place);
    const auto lift = [&](const Eigen::Vector2d& d) {
      return Eigen::RowVector3d(d.x(), d.y(), f.slope.dot(d));
    };
    const Eigen::RowVector3d point(place.x(), place.y(), f.value), edge1 = lift(along),
                                                                   cross0 = lift(out);
    const Eigen::RowVector3d edge2(0, 0, along.dot(f.bend * along)),
        cross1(0, 0, along.dot(f.bend * out));
    const int e = end ? 5 : 0, c = end ? 3 : 0, step = end ? -1 : 1;
    edge.row(e) = point;
    edge.row(e + step) = point + step * edge1 / 5;
    edge.row(e + 2 * step) = point + 2 * step * edge1 / 5 + edge2 / 20;
    cross.row(c) = cross0;
    cross.row(c + step) = cross0 + step * cross1 / 3;
  }
  return {BezierCurve(edge), cross};
}

/// Counter-clockwise, seen from above.
inline std::vector<FillSide> graphHole(const Graph& graph,
                                       const std::vector<Eigen::Vector2d>& corners) {
  std::vector<FillSide> sides;
  for (std::size_t k = 0; k < corners.size(); ++k)
    sides.push_back(graphSide(graph, corners[k], corners[(k + 1) % corners.size()]));
  return sides;
}

inline std::vector<Eigen::Vector2d> polygon(int n, double radius) {
  std::vector<Eigen::Vector2d> corners;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / n;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

inline Eigen::Vector3d normalNear(const Eigen::Vector3d& up, double tilt, std::mt19937_64& random) {
  return (up + Eigen::Vector3d(uniform(-tilt, tilt, random), uniform(-tilt, tilt, random), 0))
      .normalized();
}

/// Takes from the cross-boundary derivatives of both sides what keeps their mixed derivatives from
/// agreeing at the corner between them, along the corner's normal: p and q by Cramer's rule in its
/// plane.
inline void makeCompatible(FillSide& before, FillSide& after, const Eigen::Vector3d& normal) {
  const Poles b = before.edge.poles(), a = after.edge.poles();
  const auto det = [&](const Eigen::RowVector3d& x, const Eigen::RowVector3d& y) {
    return normal.dot(x.cross(y));
  };
  const Eigen::RowVector3d in = 3 * (b.row(3) - b.row(2)), out = 3 * (a.row(1) - a.row(0));
  const Eigen::RowVector3d t_b = before.cross->row(3), t_a = after.cross->row(0);
  const double p_a = det(in, out) / (2 * det(t_a, out)), q_a = det(t_a, in) / (2 * det(t_a, out));
  const double p_b = -det(out, in) / (2 * det(t_b, in)), q_b = -det(t_b, out) / (2 * det(t_b, in));
  const Eigen::RowVector3d mixed =
      p_a * 3 * (after.cross->row(1) - t_a) + q_a * 6 * (a.row(2) - 2 * a.row(1) + a.row(0)) +
      p_b * 3 * (t_b - before.cross->row(2)) + q_b * 6 * (b.row(3) - 2 * b.row(2) + b.row(1));
  const double half = mixed.dot(normal.transpose()) / 2;
  after.cross->row(1) -= half / (3 * p_a) * normal.transpose();
  before.cross->row(2) += half / (3 * p_b) * normal.transpose();
}

/// A hole of cubic edges with cubic cross-boundary derivatives about 10 mm wide, the last side
/// shorter by that ratio. Corners are compatible.
inline std::vector<FillSide> randomHole(int n, double ratio, std::mt19937_64& random) {
  std::vector<Eigen::Vector3d> corners, normals;
  const double step = 2 * std::numbers::pi / (n - 1 + 1 / ratio);
  for (int k = 0; k < n; ++k) {
    const double wobble = ratio > 1 ? 0 : 0.15,
                 angle = step * (k + uniform(-wobble, wobble, random));
    const double radius = 10 * (1 + uniform(-wobble, wobble, random) / 2);
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                         uniform(-1, 1, random));
    normals.push_back(normalNear(Eigen::Vector3d::UnitZ(), 0.15, random));
  }
  if (ratio > 1) corners.back().z() = corners.front().z(), normals.back() = normals.front();
  std::vector<FillSide> sides;
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    const Eigen::Vector3d chord = corners[next] - corners[k];
    const auto flat = [&](const Eigen::Vector3d& v, int corner) {
      return (v - normals[corner] * normals[corner].dot(v)).eval();
    };
    Poles edge(4, 3), cross(4, 3);
    edge.row(0) = corners[k];
    edge.row(1) = corners[k] + flat(chord, k) / 3;
    edge.row(2) = corners[next] - flat(chord, next) / 3;
    edge.row(3) = corners[next];
    cross.row(0) = flat(chord, k).normalized().cross(normals[k]) * uniform(2, 4, random);
    cross.row(3) = flat(chord, next).normalized().cross(normals[next]) * uniform(2, 4, random);
    for (int i : {1, 2}) {
      cross.row(i) = (cross.row(0) * (3 - i) + cross.row(3) * i) / 3;
      for (int c = 0; c < 3; ++c) cross(i, c) += uniform(-0.2, 0.2, random);
    }
    sides.push_back({BezierCurve(edge), cross});
  }
  for (int k = 0; k < n; ++k) makeCompatible(sides[(k + n - 1) % n], sides[k], normals[k]);
  return sides;
}

/// A linear map and a shift of points; a rigid motion and a scale where random.
struct Move {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  Poles points(const Poles& poles) const {
    return (poles * linear.transpose()).rowwise() + shift.transpose();
  }
  FillSide operator()(const FillSide& side) const {
    FillSide moved{BezierCurve(points(side.edge.poles()))};
    if (side.cross) moved.cross = *side.cross * linear.transpose();
    return moved;
  }
};

inline Move randomMove(double scale, std::mt19937_64& random) {
  const Eigen::Matrix3d any = Eigen::Matrix3d::NullaryExpr([&] { return uniform(-1, 1, random); });
  Eigen::Matrix3d turn = any.householderQr().householderQ();
  if (turn.determinant() < 0) turn = -turn;
  return {scale * turn,
          30 * scale * Eigen::Vector3d::NullaryExpr([&] { return uniform(-1, 1, random); })};
}

inline FillSide reversed(const FillSide& side) {
  FillSide back{side.edge.reversed()};
  if (side.cross) back.cross = side.cross->colwise().reverse();
  return back;
}

/// The patch E + s T beyond a side; edge U0 is the side.
inline BezierPatch neighbour(const FillSide& side) {
  const Poles edge = side.edge.poles();
  const auto raised = [](const Poles& poles, int degree) {
    BezierCurve curve(poles);
    while (curve.degree() < degree) curve = curve.elevated();
    return curve.poles();
  };
  const int degree = static_cast<int>(std::max(edge.rows(), side.cross->rows())) - 1;
  Poles net(2 * (degree + 1), 3);
  net << raised(edge, degree), raised(edge, degree) + raised(*side.cross, degree);
  return {1, degree, net};
}

/// Half of that patch: 0 with the beginning of the side, 1 with its end.
inline BezierPatch neighbourHalf(const FillSide& side, int half) {
  const auto [first, second] = neighbour(side).transposed().splitU(0.5);
  return (half == 0 ? first : second).transposed();
}

inline ContinuityTolerance fine() {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = tolerance.angle_rad = 1e-10;
  tolerance.curvature_rel = 1;
  return tolerance;
}

inline SeamFigures spokeFigures(const NSidedFill& fill, int k) {
  const int n = static_cast<int>(fill.patches.size());
  return encloseSeam(seamSide(fill.patches[k], PatchEdge::U0),
                     seamSide(fill.patches[(k + 1) % n], PatchEdge::V0), fine());
}

/// Of half a side against its neighbour.
inline SeamFigures sideFigures(const NSidedFill& fill, const std::vector<FillSide>& sides, int k,
                               int half) {
  const int n = static_cast<int>(fill.patches.size());
  const SeamSide ours = half == 0 ? seamSide(fill.patches[k], PatchEdge::V1, true)
                                  : seamSide(fill.patches[(k + 1) % n], PatchEdge::U1);
  return encloseSeam(ours, seamSide(neighbourHalf(sides[k], half), PatchEdge::U0), fine());
}

}  // namespace seamwright::test
