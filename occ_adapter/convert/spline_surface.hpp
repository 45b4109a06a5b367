// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>

namespace seamwright::occ {

/// A copy of a B-spline or Bezier surface, over its range if it is trimmed, placed in space:
/// clamped and not periodic, with the same parameters. Points are the same except for the rounding
/// of the location and of inserted knots.
/// \returns null for a surface of another kind. \throws Standard_Failure.
opencascade::handle<Geom_BSplineSurface> clampedSpline(
    const opencascade::handle<Geom_Surface>& surface, const TopLoc_Location& location = {});

/// A surface of the form that clampedSpline() returns as a value of core.
/// \throws std::invalid_argument for a surface that is periodic or not clamped, or has a number
/// that is not finite.
BSplineSurface coreSurface(const Geom_BSplineSurface& surface);

/// \throws std::invalid_argument as requireValid(), for an inner knot with a multiplicity above the
/// degree, and for inner knots that are too near to each other for OpenCASCADE.
opencascade::handle<Geom_BSplineSurface> geomSurface(const BSplineSurface& surface);

/// The naturalFace() of geomSurface(). \throws std::invalid_argument as both.
TopoDS_Face faceOf(const BSplineSurface& surface, double tolerance_mm = Precision::Confusion());

/// The poles of a clamped spline surface as rows along one of its edges, counted from the edge, and
/// columns across it. Columns and the parameter t in [0, 1] run in the edge's own sense, or against
/// it if reversed.
///
/// Functions that raise degrees or insert knots modify the surface, not its shape; only setPole()
/// and setKnotsAlong() change the shape.
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
  /// Replaces the knots by these, of the same number. The shape changes by as much as the knots.
  void setKnotsAlong(const std::vector<double>& t);
  /// Inserts knots halfway across until there are that many rows.
  void refineAcross(int rows);

  /// The surface's parameters at t and at a share of its range across, 0 at the edge.
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
/// shapes stay. A knot of the second within 1e-9 of the range of a knot of the first becomes that
/// knot, which changes the second's shape by as much.
/// \param extra_multiplicity added to that of the inner knots.
void alignAlong(EdgeRows& first, EdgeRows& second, int extra_multiplicity = 0);

}  // namespace seamwright::occ
