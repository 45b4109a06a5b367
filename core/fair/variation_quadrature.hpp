// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>

/// The variation of the curvature of Bézier segments by Gauss' quadrature on pieces that are halved
/// until it is accurate; not a public header. Source: docs/theory/planar.md P13.4, P13.6.
namespace seamwright {

/// Up to which two rules of different order agree on a piece, as a share of its variation.
constexpr double variation_accuracy = 1e-6;

/// One of the 2^halvings equal pieces of [0, 1].
struct DyadicPiece {
  double start = 0;
  int halvings = 0;
};

struct SegmentVariation {
  /// Infinite if the segment may stop, see P13.6.
  double energy_per_mm3 = 0;
  /// On which Gauss' quadrature was accurate; the whole segment if it may stop.
  std::vector<DyadicPiece> pieces;
};

/// Of polynomial segments of a degree.
class VariationQuadrature {
 public:
  /// \param degree of the segments, at least 0.
  explicit VariationQuadrature(int degree);

  /// \param hodograph the poles of the derivative by the parameter 0..1, 3 by degree. A factor that
  /// all of them have divides the variation by its cube.
  SegmentVariation operator()(const Eigen::Matrix3Xd& hodograph) const;

  static constexpr int coarse_nodes = 6, fine_nodes = 9;
  static constexpr int nodes = coarse_nodes + fine_nodes;
  /// An even number, which fills the registers of processors: the last node is repeated with the
  /// weight 0.
  static constexpr int rows = nodes + nodes % 2;

  /// A number for each node, those of the coarse rule first.
  using AtNodes = Eigen::Array<double, rows, 1>;
  using ValuesAtNodes = Eigen::Matrix<double, rows, Eigen::Dynamic>;

 private:
  friend class PolynomialPiece;

  /// Values of the Bernstein polynomials of the derivatives of the orders 1 to 3, one column for
  /// each polynomial.
  ValuesAtNodes first_, second_, third_;
  AtNodes weights_;
};

/// Polynomial or rational.
SegmentVariation variationOf(const BezierCurve& segment);

}  // namespace seamwright
