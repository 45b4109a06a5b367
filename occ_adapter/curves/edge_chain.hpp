// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Geom_Curve.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <string>
#include <vector>

/// Edges of a model joined end to end.
namespace seamwright::occ {

/// An edge in the direction of its curve.
struct SpaceEdge {
  int number = 0;  ///< from 1 in the order of TopExp::MapShapes
  opencascade::handle<Geom_Curve> curve;
  double first = 0, last = 0;
  std::array<Eigen::Vector3d, 2> ends;
  double tolerance_mm = 0;  ///< the largest of its vertices, at least 1e-6
};

/// An edge as a chain runs through it.
struct ChainedEdge {
  SpaceEdge edge;
  bool forward = true;  ///< in the direction of its curve
};

/// Edges end to end. The end of a closed chain is its beginning.
struct EdgeChain {
  std::vector<ChainedEdge> edges;
  bool closed = false;
};

struct EdgeChainOptions {
  /// Numbers of edges; empty: the free ones. Edges of no face and of one face are free, so the
  /// outline and the holes of a face are, and the edges of a wire; a seam edge of a closed face is
  /// not.
  std::vector<int> edges = {};
  bool each_alone = false;  ///< every edge is a chain of its own
};

/// Edges joined to chains where their ends meet within the tolerances of their vertices, or 1e-6
/// mm. A chain ends where one, or more than two, ends meet. Chains are in the order of their
/// smallest number.
/// 	hrows GeometryError for an edge without a curve, with infinite range or with numbers that
/// are not finite; std::invalid_argument for a number without an edge.
std::vector<EdgeChain> edgeChains(const TopoDS_Shape& shape, const EdgeChainOptions& options = {});

/// "Edge1, Edge2 and 7 more": the first five numbers.
std::string namesOf(const EdgeChain& chain);

}  // namespace seamwright::occ
