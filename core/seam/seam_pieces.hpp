// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/seam/piece.hpp>
#include <seamwright/core/seam/side_length.hpp>

/// The pieces of a seam with the bounds of each, and the figures of the seam that follow from them.
/// Not a public header.
namespace seamwright::enclosure {

/// Share of the seam, in parameter and in length. A shorter piece without known tangent plane is
/// left out.
constexpr double pole_piece = 0x1p-30;

enum Quantity { Gap, Angle, Curvature, RelativeCurvature, Change, RelativeChange, Quantities };

struct Piece {
  double from = 0;
  double to = 0;
  PieceFigures figures = {};
  bool left_out = false;            ///< only the gap counts
  bool curvature_left_out = false;  ///< only gap and angle count
  bool across_knots = false;        ///< on a side, several polynomials meet it
  bool bounds_curvature = false;    ///< the curvature of both sides is bounded
  /// How wide its bounds are, in units of the allowed width; 0 if they are narrow enough.
  double excess = infinite;
  int stalled = 0;  ///< number of cuts in a row that improved no part
  double width() const { return to - from; }
  /// The parameter of the seam at x in [-1, 1], as enclosures of a piece count: -1 is its begin, 0
  /// its middle, 1 its end.
  double at(double x) const { return 0.5 * ((1 - x) * from + (1 + x) * to); }
};

/// Whether the faces of a piece fold back on one another wherever its angle is that of a fold.
inline bool folds(const Piece& piece, bool faces_on_one_side) {
  return piece.figures.sense != 0 && faces_on_one_side == (piece.figures.sense > 0);
}

/// Whether that is not excluded.
inline bool mayFold(const Piece& piece, bool faces_on_one_side) {
  return piece.figures.sense == 0 || folds(piece, faces_on_one_side);
}

/// Whether a piece is too near a point without tangent plane or without curvature to be
/// distinguished from it.
bool isAtPole(const Piece& piece, std::span<const DegeneratePoint> poles, const SideLength& length);

/// The ends of the parts into which a piece is cut: two halves, but towards a pole at an end of the
/// seam parts that are each as long as their distance to it. Near a pole only such parts have
/// bounds. \param curvature_range the seam without the poles at its ends
std::vector<double> partsOf(const Piece& piece, const Interval& curvature_range);

struct SeamPieces {
  std::vector<Piece> pieces;               ///< they cover the seam, in any order
  std::array<double, Quantities> lower{};  ///< largest values found
  std::array<double, Quantities> at{};     ///< where they are
  std::vector<DegeneratePoint> degenerate;
  bool faces_on_one_side = false;  ///< both faces are left of the seam, or both right
  int looks = 0;                   ///< number of pieces measured
  bool exhausted = false;          ///< the work limit was reached
  /// Only the verdict is wanted, and it is below G2: pieces may lack the curvature.
  bool is_verdict_below_g2 = false;
  bool has_change = false;  ///< the change of curvature was asked for
};

struct FigureOptions {
  const ContinuityTolerance& tolerance;
  Interval range = {0, 1};  ///< the figures of angle and curvature count here
};

SeamFigures figuresOf(SeamPieces pieces, const SideLength& length_a, const SideLength& length_b,
                      const FigureOptions& options);

}  // namespace seamwright::enclosure
