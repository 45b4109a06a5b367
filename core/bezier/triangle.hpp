// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <utility>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>

namespace seamwright {

/// Barycentric coordinates (l0, l1, l2) with sum 1.
using Barycentric = Eigen::Vector3d;

/// A (rational) Bézier triangle of degree n over barycentric coordinates l0 + l1 + l2 = 1, stored
/// by its homogeneous poles: X = sum_{i+j+k=n} n!/(i! j! k!) l0^i l1^j l2^k w_ij P_ij / sum ...
/// w_ij.
///
/// The poles are rows in the order i = 0..n, j = 0..n-i (k = n-i-j). The corners P0, P1, P2 are (i,
/// j) = (n, 0), (0, n), (0, 0). As a parametrised surface the triangle has the parameters u = l0, v
/// = l1.
///
/// Identities (each has a test of its number; B is blossom(); equalities hold up to rounding,
/// except where they are bitwise):
///   (1) B(l, ..., l) is the homogeneous point at l; B(P0 i times, P1 j times, P2 k times) is
///       bitwise the pole (i, j).
///   (2) B is bitwise the same for any order of its arguments; it is affine in each argument.
///   (3) elevated(), subtriangle(), splitAt(), quartered() and permuted() give the same surface:
///       the point at l of the result is the point of this triangle at the combination l of the
///       corners.
///   (4) Triangles of one split have bitwise the same poles on their common edges.
/// Source: docs/theory/surfaces.md S4.1; [Farin1986]; [Ramshaw1989].
class BezierTriangle {
 public:
  /// Polynomial triangle. \param poles (n+1)(n+2)/2 by 3; their number gives the degree.
  /// \throws std::invalid_argument if no degree has that number of rows, or a pole is not finite
  /// (its row is named).
  explicit BezierTriangle(const Eigen::Ref<const Poles>& poles);
  /// Rational triangle. \param weights positive finite numbers in the order of the poles.
  BezierTriangle(const Eigen::Ref<const Poles>& poles,
                 const Eigen::Ref<const Eigen::VectorXd>& weights);
  /// The triangle with these homogeneous poles, copied bitwise. \throws as the constructors do.
  static BezierTriangle fromHomogeneous(HomogeneousPoles poles);

  int degree() const { return degree_; }
  /// The row of the pole (i, j) in a net of the given degree.
  static Eigen::Index row(int degree, int i, int j) {
    return i * (degree + 1) - i * (i - 1) / 2 + j;
  }
  bool isRational() const;
  Poles poles() const;
  Eigen::VectorXd weights() const { return homogeneous_.col(3); }
  const HomogeneousPoles& homogeneousPoles() const { return homogeneous_; }
  /// \pre i, j >= 0, i + j <= degree().
  Eigen::Vector3d pole(int i, int j) const;

  /// The point at (l0, l1). Outside the triangle the polynomial continues with less accuracy.
  Eigen::Vector3d point(double l0, double l1) const;
  /// Point and partials up to third order by u = l0, v = l1.
  SurfaceJet jet(double l0, double l1) const;
  /// Bound of the rounding in the first partials of jet() on the triangle: 8 (n + 4) eps n |P|_max
  /// w_max / w_min. It bounds the error of the evaluation only: the poles count as exact.
  JetNoise noise() const;

  /// The homogeneous value of the blossom (polar form). The blossom is the only function of n
  /// arguments that is affine in each argument, symmetric, and equal to the triangle on its
  /// diagonal.
  /// \throws std::invalid_argument unless the number of arguments is the degree and all are finite.
  Eigen::Vector4d blossom(std::span<const Barycentric> arguments) const;

  /// The boundary curve of that edge, in the direction of the edge.
  BezierCurve edgeCurve(TriangleEdge edge) const;
  /// The same triangle with one degree more.
  BezierTriangle elevated() const;
  /// The same triangle with its corners in another order: corner c of the result is corner
  /// corners[c] of this triangle. Even permutations keep the natural normal, odd ones reverse it.
  /// \throws std::invalid_argument unless \p corners holds 0, 1 and 2.
  BezierTriangle permuted(const std::array<int, 3>& corners) const;
  /// The part of the surface over the triangle with these three corners.
  /// \throws std::invalid_argument if a coordinate is not finite, or if a weight of the result is
  /// not positive, which may happen outside this triangle.
  BezierTriangle subtriangle(const std::array<Barycentric, 3>& corners) const;
  /// Three triangles around the point (l0, l1). In the k-th triangle the point replaces corner k,
  /// so it keeps edge k.
  std::array<BezierTriangle, 3> splitAt(double l0, double l1) const;
  /// Four triangles, cut at the midpoints of the edges. The k-th of the first three keeps corner k.
  /// The last is the middle one; its corner k is the midpoint of edge k.
  std::array<BezierTriangle, 4> quartered() const;

  bool operator==(const BezierTriangle& other) const { return homogeneous_ == other.homogeneous_; }

 private:
  struct Homogeneous {};
  BezierTriangle(Homogeneous, int degree, HomogeneousPoles poles)
      : homogeneous_(std::move(poles)), degree_(degree) {}

  HomogeneousPoles homogeneous_;
  int degree_;
};

}  // namespace seamwright
