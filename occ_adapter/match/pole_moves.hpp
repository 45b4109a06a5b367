// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <optional>

#include <seamwright/occ_adapter/match/least_moves.hpp>
#include <seamwright/occ_adapter/match/side_piece.hpp>
#include <seamwright/occ_adapter/match/zone.hpp>
#include <seamwright/occ_adapter/repair/surface_basis.hpp>

/// Moves poles of a surface so that points of it meet targets. Not a public header.
namespace seamwright::occ {

/// A point of the surface and what it has to meet.
struct Station {
  Eigen::Vector2d uv;
  Eigen::Vector2d step;  ///< of the parameters, across the side into the face, about a row of poles
  MatchTarget target;
  int order = 1;
};

/// Two points of a surface that meets itself, or both sides of a knot line. They have to move
/// alike, with their derivatives up to the order, and those of the other one are \p ratio times as
/// long.
struct ClosingPoints {
  Eigen::Vector2d uv, other_uv;
  int direction = 0;  ///< across the line: 0: u
  double into = 1;    ///< the sense of the parameter across from the line at uv
  double ratio = 1;
  int order = 1;
};

/// Both sides of the knot lines at which a surface is less smooth than the order though its
/// derivatives are continuous there, and of the line along which it closes.
/// \param order 1 or 2
std::vector<ClosingPoints> closingPoints(const Geom_BSplineSurface& surface, int order);

/// A point that stays if this costs little bending.
struct KeptPoint {
  Eigen::Vector2d uv;
  double share = 0;                       ///< of the length of all kept edges
  std::optional<Eigen::Vector3d> normal;  ///< it may move across this: its edge slides
};

/// Points of edges that stay, softly: a move d of them counts as the bending energy weight times
/// (|d| / size)^2 in the mean over the points.
struct KeptEdges {
  std::vector<KeptPoint> points;
  double weight = 0, size_mm = 1;
};

struct PoleMoves {
  opencascade::handle<Geom_BSplineSurface> after;
  double largest_mm = 0;  ///< of a pole, so that no point moves further
};

/// The largest figure of the stations as a share of its tolerance, for jets of the surface there.
using WorstShare = std::function<double(const std::vector<SurfaceJet>& jets)>;

/// How near to its targets a surface has to come.
struct Nearness {
  double enough = 0.02;  ///< share of the tolerances; nearer is of no use
  double limit = 0.5;    ///< share of the tolerances; nearer is not worth more bending
  /// The weight of bending starts at 1 and falls to a tenth while solutions come nearer slowly and
  /// are beyond the limit. They may move so many times as far as with the weight 1: what moves
  /// farther makes waves, and needs more knots instead.
  double most_growth = 3;
};

/// Moves the poles of a zone with the least bending of the moves: the integral of |Hess d|^2 over
/// the face, in the metric of the surface. Conditions of a station: X = point, n . X_s = 0 for its
/// step s, n . X_ss = II(X_s, X_s). Each solution comes nearer to them and bends more; the nearest
/// one is taken. Poles of a side that is one point stay one point. Weights stay.
/// Source: docs/theory/surfaces.md S5.6.
class PoleSolver {
 public:
  /// Zone and stations must outlive it. \param kept its points; the weight is that of solved().
  PoleSolver(const Zone& zone, const std::vector<Station>& stations,
             const std::vector<ClosingPoints>& closing, const KeptEdges& kept);
  ~PoleSolver();

  /// Further calls are faster: the conditions are the same.
  PoleMoves solved(double kept_weight, const WorstShare& worst, const Nearness& nearness);
  /// At the stations, for these poles of the zone's surface.
  std::vector<SurfaceJet> jetsOf(const PointRows& poles) const;

 private:
  struct Condition;
  struct Closing;

  double meanRow_mm() const;
  double scaleOf(int order) const { return order < 2 ? 1 : curvature_scale_; }
  void addStation(int number);
  void addClosing(const ClosingPoints& points);
  void addCollapsed(const std::vector<int>& side);
  void addBending(double row_mm);
  void addKept(const KeptEdges& kept, double rows);
  void step(const std::vector<SurfaceJet>& jets, double softness, double kept_weight);
  double largestMissed_mm(const std::vector<SurfaceJet>& jets) const;

  const Zone& zone_;
  const std::vector<Station>& stations_;
  SurfaceBasis basis_;
  std::vector<int> numbers_;
  PointRows given_, poles_;
  std::vector<PoleShares> shares_;
  std::vector<std::vector<int>> collapsed_;
  std::vector<Condition> conditions_;
  std::vector<Closing> closing_;
  double curvature_scale_ = 1;  ///< of conditions on curvatures
  LeastMoves system_;
};

}  // namespace seamwright::occ
