// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <BRepTopAdaptor_FClass2d.hxx>
#include <Eigen/Core>
#include <Geom2d_Curve.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <vector>

/// The cells of a grid in the parameter plane that a face covers. Not a public header.
namespace seamwright::occ {

/// One direction of a grid.
struct GridLines {
  std::vector<double> at;  ///< increasing
  bool periodic = false;   ///< the last line is the first one again
};

/// Tells which points of cells lie in a face. Points are classified one by one only in cells that
/// the boundary crosses, and beside them; of what lies between, once for all cells that touch.
class FaceCells {
 public:
  /// \param grid has a cell at least. \throws Standard_Failure.
  FaceCells(const TopoDS_Face& face, const std::array<GridLines, 2>& grid);

  /// Of a square array of points in a cell, those that lie in the face.
  std::vector<Eigen::Vector2d> inside(int i, int j);

 private:
  enum class State { Unknown, In, Out, Crossed };

  int cells(int direction) const { return static_cast<int>(grid_[direction].at.size()) - 1; }
  State& state(int i, int j) { return states_[static_cast<std::size_t>(i) * cells(1) + j]; }
  int cellAt(int direction, double value) const;
  void markAround(const std::array<int, 2>& cell);
  void follow(const Geom2d_Curve& curve, double first, double last, int halvings);
  void spread(int i, int j, State found);
  bool isInside(const Eigen::Vector2d& uv);
  Eigen::Vector2d pointOf(int i, int j, double share_u, double share_v) const;

  TopoDS_Face face_;
  BRepTopAdaptor_FClass2d classifier_;
  std::array<GridLines, 2> grid_;
  std::vector<State> states_;
};

}  // namespace seamwright::occ
