// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <GeomAdaptor_Curve.hxx>
#include <vector>

#include <seamwright/core/differential/jet.hpp>
#include <seamwright/occ_adapter/curves/edge_chain.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

/// A chain of edges by its arc length. Not a public header.
namespace seamwright::occ {

/// A place where derivatives of a chain of edges may jump.
struct CurveBreak {
  double share = 0;    ///< of the length
  int smoothness = 0;  ///< the derivatives by arc length up to that order don't
};

/// The curves of edges, one after the other.
class LateralCurve {
 public:
  /// \param backwards against the direction of the chain
  /// \throws GeometryError for a chain without length; std::invalid_argument where it has a corner.
  LateralCurve(const EdgeChain& chain, bool backwards);

  double length_mm() const { return length_mm_; }
  /// The point at a share of the length.
  Eigen::Vector3d at(double share) const;
  /// Derivatives 0 to 3 by arc length at the begin (0) or the end (1), 4 by 3.
  /// \throws GeometryError where the curve stands still.
  CurveDerivatives atEnd(int end) const;
  /// Inside of the chain, in the order of shares.
  const std::vector<CurveBreak>& breaks() const { return breaks_; }

 private:
  struct Piece {
    int number = 0;
    GeomAdaptor_Curve curve;
    double first = 0, last = 0;  ///< parameters in the direction of the chain
    PathLength length;

    double parameterAt(double share_of_range) const {
      return first + share_of_range * (last - first);
    }
  };

  void addPiece(const ChainedEdge& edge, bool backwards);
  void addBreaks(const Piece& piece, double begin_mm);
  void judgeKinks();

  std::vector<Piece> pieces_;
  std::vector<double> begins_mm_;
  std::vector<CurveBreak> breaks_;
  double length_mm_ = 0;
};

}  // namespace seamwright::occ
