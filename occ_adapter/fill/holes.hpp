// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

/// A free edge in the direction in which it runs around a hole.
struct HoleEdge {
  int edge = 0;  ///< from 1, in the order of TopExp::MapShapes
  Coedge use;
  bool reversed = false;  ///< the hole runs against the edge's curve
  double length_mm = 0;
};

/// A longest run of edges without a corner.
struct HoleSide {
  std::vector<HoleEdge> edges;  ///< in the direction of the hole
  double length_mm = 0;
};

/// A closed loop of free edges. Side k ends at corner k + 1, where side k + 1 begins.
struct Hole {
  int id = 0;                   ///< from 1, in the order of the smallest edge numbers
  std::vector<HoleSide> sides;  ///< a loop without a corner, or with one, is one side
  bool has_corners = false;     ///< false: the loop is smooth
  double length_mm = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of mass of the loop as a wire, mm
  /// Whether this is the longest loop, by more than the gap, of those that bound one connected set
  /// of faces. In an open shell it is mostly the outer boundary and not a hole. False for all if
  /// several are as long, or if the longest runs along inner boundaries of its faces only.
  bool longest = false;
};

struct HoleOptions {
  double corner_rad = 0.26;  ///< a corner is where the tangent turns by more than this
  /// Ends of edges nearer than this, or within their tolerances of each other, count as one
  /// point.
  double gap_mm = 0.01;

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

struct Holes {
  std::vector<Hole> holes;
  /// On free edges outside of closed loops, and on edges that can't be evaluated.
  std::vector<std::string> notes;
};

/// Finds the closed loops of free edges of a shape. The hole lies to the left of each loop for the
/// orientation of its faces (where these disagree, for that of the face of the smallest edge
/// number). The outer boundary of an open shell is also a loop; the user chooses the loops to fill.
/// Loops that touch at a vertex are separated: no loop passes a vertex twice.
/// \throws std::invalid_argument for invalid options.
Holes findHoles(const TopoDS_Shape& shape, const HoleOptions& options = {});

}  // namespace seamwright::occ
