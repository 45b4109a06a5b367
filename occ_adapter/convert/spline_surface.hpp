// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <TopLoc_Location.hxx>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>

namespace seamwright::occ {

/// A copy of a B-spline or Bezier surface, or of a trimmed one of these over its trimmed range,
/// placed in space: clamped and not periodic, with the same parameters. The points are the same but
/// for the rounding of the placement and of inserted knots.
/// \returns null for a surface of another kind. \throws Standard_Failure.
opencascade::handle<Geom_BSplineSurface> clampedSpline(
    const opencascade::handle<Geom_Surface>& surface, const TopLoc_Location& location = {});

/// The numbers of a surface as clampedSpline() makes them.
/// \throws std::invalid_argument for a surface that is periodic or not clamped, or has a number
/// that is not finite.
BSplineSurface coreSurface(const Geom_BSplineSurface& surface);

/// \throws std::invalid_argument as requireValid(); for a knot in the interior that is repeated
/// more often than the degree, or nearer to the next one than OpenCASCADE tells knots apart.
opencascade::handle<Geom_BSplineSurface> geomSurface(const BSplineSurface& surface);

/// The poles of a clamped spline surface as rows that run along one of its edges, counted from the
/// edge, and columns that run across it; columns and the parameter t in [0, 1] in the edge's own
/// sense (or against it, if reversed).
///
/// Changes the surface it is made of, whose shape only setPole() changes.
class EdgeRows {
 public:
  EdgeRows(opencascade::handle<Geom_BSplineSurface> surface, PatchEdge edge, bool reversed = false);

  const opencascade::handle<Geom_BSplineSurface>& surface() const { return surface_; }
  PatchEdge edge() const { return edge_; }
  bool reversed() const { return reversed_; }

  int rows() const;
  int columns() const;
  Eigen::Vector3d pole(int row, int column) const;
  double weight(int row, int column) const;
  void setPole(int row, int column, const Eigen::Vector3d& pole);
  /// Number of the pole in BSplineSurface, for the same surface.
  std::size_t number(int row, int column) const;

  int degreeAlong() const { return alongV() ? surface_->VDegree() : surface_->UDegree(); }
  int degreeAcross() const { return alongV() ? surface_->UDegree() : surface_->VDegree(); }
  /// Flat, scaled to [0, 1], in the sense of t.
  std::vector<double> knotsAlong() const;
  /// Flat, of the surface itself.
  std::vector<double> knotsAcross() const;

  void raiseDegreeAlong(int degree);
  void raiseDegreeAcross(int degree);
  /// Knots are inserted until each t in ]0, 1[ has that multiplicity, at most the degree; nothing
  /// is removed.
  void insertAlong(double t, int multiplicity);
  /// Moves the knots to these places, as many as there are; a change of the parameter that changes
  /// the shape by as much.
  void setKnotsAlong(const std::vector<double>& t);
  /// Knots half-way across until there are as many rows.
  void refineAcross(int rows);

  /// Parameters of the surface at t, and a share of its range across, 0 at the edge.
  Eigen::Vector2d parameters(double t, double across = 0) const;
  /// The edge as a curve over [first, last] that runs with t.
  opencascade::handle<Geom_Curve> boundary(double first, double last) const;

 private:
  bool alongV() const { return edge_ == PatchEdge::U0 || edge_ == PatchEdge::U1; }
  bool atEnd() const { return edge_ == PatchEdge::U1 || edge_ == PatchEdge::V1; }
  std::pair<int, int> index(int row, int column) const;
  Eigen::Vector2d rangeAlong() const;

  opencascade::handle<Geom_BSplineSurface> surface_;
  PatchEdge edge_;
  bool reversed_;
};

/// Gives both edges the same degree and knots along t, by raising degrees and inserting knots;
/// shapes stay. Knots of the second that are within 1e-9 of the range from one of the first become
/// that one, which changes the second's shape by as much.
/// \param extra_multiplicity added to that of the inner knots.
void alignAlong(EdgeRows& first, EdgeRows& second, int extra_multiplicity = 0);

}  // namespace seamwright::occ
