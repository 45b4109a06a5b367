// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <utility>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>

namespace seamwright {

/// Barycentric coordinates (l0, l1, l2), of sum 1.
using Barycentric = Eigen::Vector3d;

/// A (rational) Bézier triangle of degree n over barycentric coordinates l0 + l1 + l2 = 1, stored
/// by its homogeneous poles: X = sum_{i+j+k=n} n!/(i! j! k!) l0^i l1^j l2^k w_ij P_ij / sum ...
/// w_ij.
///
/// Poles are rows in the order i = 0..n, j = 0..n-i (k = n-i-j); the corners P0, P1, P2 are (i, j)
/// = (n, 0), (0, n), (0, 0). As a parametrised surface its parameters are u = l0, v = l1.
///
/// Identities (each has a test of its number; B is blossom(), equality up to rounding where not
/// said otherwise):
///   (1) B(l, ..., l) is the homogeneous point at l; B(P0 i times, P1 j times, P2 k times) is the
///       pole (i, j), bit by bit.
///   (2) B does not change, bit by bit, when its arguments change places; it is affine in each of
///       them.
///   (3) elevated(), subtriangle(), splitAt(), quartered() and permuted() are the same surface: the
///       point at l of the result is that of this triangle at the combination l of the corners.
///   (4) Triangles out of one split share the poles of their common edges bit by bit.
/// Source: docs/theory/surfaces.md S4.1; [Farin1986]; [Ramshaw1989].
class BezierTriangle {
 public:
  /// Polynomial triangle. \param poles (n+1)(n+2)/2 by 3; their number gives the degree.
  /// \throws std::invalid_argument if the number of rows is no such number, or a pole is not finite
  /// (its row is named).
  explicit BezierTriangle(const Eigen::Ref<const Poles>& poles);
  /// Rational triangle. \param weights positive finite numbers in the order of the poles.
  BezierTriangle(const Eigen::Ref<const Poles>& poles,
                 const Eigen::Ref<const Eigen::VectorXd>& weights);

  int degree() const { return degree_; }
  /// Row of the pole (i, j) of a net of that degree.
  static Eigen::Index row(int degree, int i, int j) {
    return i * (degree + 1) - i * (i - 1) / 2 + j;
  }
  bool isRational() const;
  Poles poles() const;
  Eigen::VectorXd weights() const { return homogeneous_.col(3); }
  const HomogeneousPoles& homogeneousPoles() const { return homogeneous_; }
  /// \pre i, j >= 0, i + j <= degree().
  Eigen::Vector3d pole(int i, int j) const;

  /// Outside the triangle the polynomial goes on; accuracy falls there.
  Eigen::Vector3d point(double l0, double l1) const;
  /// Point and partials to third order by u = l0, v = l1.
  SurfaceJet jet(double l0, double l1) const;
  /// Bound of the rounding in the first partials of jet() on the triangle: 8 (n + 4) eps n |P|_max
  /// w_max / w_min. A bound of the evaluation, not of the poles, which count as exact.
  JetNoise noise() const;

  /// The homogeneous value of the blossom (polar form), the one function that is affine in each of
  /// n arguments, symmetric, and has the triangle as its diagonal.
  /// \throws std::invalid_argument unless there are as many arguments as the degree, all finite.
  Eigen::Vector4d blossom(std::span<const Barycentric> arguments) const;

  /// The boundary along that edge, in the edge's own sense.
  BezierCurve edgeCurve(TriangleEdge edge) const;
  /// The same triangle with one degree more.
  BezierTriangle elevated() const;
  /// The same triangle with its corners in another order: corner c of the result is corner
  /// corners[c] of this one. Even permutations keep the natural normal, odd ones turn it over.
  /// \throws std::invalid_argument unless 0, 1 and 2 occur.
  BezierTriangle permuted(const std::array<int, 3>& corners) const;
  /// The part over the triangle of these three corners.
  /// \throws std::invalid_argument if a coordinate is not finite, or outside the triangle a weight
  /// of the result is not positive.
  BezierTriangle subtriangle(const std::array<Barycentric, 3>& corners) const;
  /// Three triangles around the point (l0, l1); the k-th has the point in place of corner k, so it
  /// keeps edge k.
  std::array<BezierTriangle, 3> splitAt(double l0, double l1) const;
  /// Four triangles between the middles of the edges: the k-th of three keeps corner k, the last is
  /// the middle one, whose corner k is the middle of edge k.
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
