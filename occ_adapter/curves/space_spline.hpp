// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <vector>

#include <seamwright/core/spline/bezier_spline.hpp>
#include <seamwright/occ_adapter/curves/edge_chain.hpp>

/// Edges of a model as splines in space, and back.
namespace seamwright::occ {

/// Edges end to end as one spline.
struct SpaceSpline {
  std::vector<int> edges;  ///< numbers from 1, along the chain
  BezierSpline spline;     ///< its knots are the lengths of the control polygons of its segments
  double gap_mm = 0;       ///< the largest distance between the end of an edge and the next start
};

/// The chains of edgeChains() as splines, without a fit: lines have degree 1, circles and conics
/// become rational curves, splines keep their poles. All segments are raised to the highest of
/// their degrees. A gap between two edges is closed: the later edge's end is the common pole.
/// Identities (each has a test of its number):
///   (1) Points of the spline are points of the edges, compared with OpenCASCADE's evaluation.
///   (2) The splines of a wire that wireOf() made are the spline it was made of, up to reversal,
///       the first segment of a closed one, knots and rounding.
/// \throws GeometryError as edgeChains(), and for a curve of another kind (an offset curve), or of
/// a degree above 25, with the edge; std::invalid_argument for a number without an edge.
std::vector<SpaceSpline> spaceSplines(const TopoDS_Shape& shape,
                                      const EdgeChainOptions& options = {});

/// The spline as a wire. Segments that agree with their neighbours in derivatives by the parameter,
/// at least the first ones, are one edge; so each other joint is a vertex.
/// \throws std::invalid_argument as requireValid(), and for a degree above 25.
TopoDS_Wire wireOf(const BezierSpline& spline);
/// A wire for each spline, in one compound.
TopoDS_Shape wiresOf(const std::vector<BezierSpline>& splines);

}  // namespace seamwright::occ
