// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

/// An open edge as it runs around a hole.
struct HoleEdge {
  int edge = 0;  ///< from 1, order of TopExp::MapShapes
  Coedge use;
  bool reversed = false;  ///< the hole's sense runs against the edge's curve
  double length_mm = 0;
};

/// A longest run of edges without a corner.
struct HoleSide {
  std::vector<HoleEdge> edges;  ///< one after the other in the sense of the hole
  double length_mm = 0;
};

/// A closed loop of open edges. Side k ends at corner k + 1, where side k + 1 begins.
struct Hole {
  int id = 0;                   ///< from 1, by the smallest number of an edge
  std::vector<HoleSide> sides;  ///< a loop without a corner, or with one, is one side
  bool has_corners = false;     ///< false: the loop is smooth
  double length_mm = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of mass of the loop as a wire, mm
  /// Of the loops that bound one connected set of faces the longest, by more than the gap: of an
  /// open shell that is mostly its rim and no hole. Where several are as long, none.
  bool longest = false;
};

struct HoleOptions {
  double corner_rad = 0.26;  ///< a corner is where the tangent turns by more than this
  double gap_mm =
      0.01;  ///< ends of edges nearer than this to one another, or by their tolerances, are one

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

struct Holes {
  std::vector<Hole> holes;
  std::vector<std::string>
      notes;  ///< open edges that are part of no closed loop, and edges that can't be evaluated
};

/// The closed loops of open edges of a shape, with the hole to the left of each as its faces are
/// turned (where they do not agree, as that of the smallest number). A rim of an open shell is a
/// loop as well; the user tells which is to be filled. Loops that touch in a vertex are told apart:
/// no loop passes a vertex twice.
/// \throws std::invalid_argument for bad options.
Holes findHoles(const TopoDS_Shape& shape, const HoleOptions& options = {});

}  // namespace seamwright::occ
