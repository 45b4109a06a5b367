// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <string>
#include <vector>

#include <seamwright/core/planar/planar_chain.hpp>
#include <seamwright/core/planar/plane_frame.hpp>
#include <seamwright/occ_adapter/curves/edge_chain.hpp>

/// Planar edges of a model as chains of planar curves, and back.
namespace seamwright::occ {

/// Edges end to end in a plane.
struct PlanarWire {
  std::vector<int> edges;  ///< numbers from 1 in the order of TopExp::MapShapes, along the chain
  PlaneFrame frame;
  PlanarChain chain;     ///< in the coordinates of the frame; several curves for a conic edge
  double height_mm = 0;  ///< upper bound of the distance of the edges from the plane
  double gap_mm = 0;     ///< the largest distance between the end of a curve and the next start
};

struct PlanarWireOptions {
  double flatness_mm = 1e-3;  ///< largest distance of an edge from the plane of its chain
  EdgeChainOptions chains = {};
};

/// The chains of edgeChains(), each in its plane: fitPlane() of the poles of its curves, or the
/// plane of an earlier chain if it lies in that up to rounding. Coordinates are exact as those of
/// planarCurves(); heights above the plane are dropped. Identities (each has a test of its number):
///   (1) A planar face with holes gives one closed chain for its outline and each hole.
///   (2) The chain of a wire that wireOf() made is the chain it was made of, up to reversal, the
///       first curve and rounding.
/// \throws GeometryError for an edge without a curve, and for a chain that is further from its
/// plane than the flatness, with the distance and the edges; std::invalid_argument for a number
/// without an edge.
std::vector<PlanarWire> planarWires(const TopoDS_Shape& shape,
                                    const PlanarWireOptions& options = {});

/// A chain that planarWires() refuses.
struct RefusedChain {
  std::vector<int> edges;  ///< as of PlanarWire
  std::string reason;
};

/// The chains that are in a plane, and those that are not.
struct PlanarWireSearch {
  std::vector<PlanarWire> wires;
  std::vector<RefusedChain> refused;
};

/// As planarWires(), but a chain that is refused does not stop the others.
/// \throws std::invalid_argument for a number without an edge, GeometryError for an edge without a
/// curve.
PlanarWireSearch findPlanarWires(const TopoDS_Shape& shape, const PlanarWireOptions& options = {});

/// The chain as a wire in its plane, an edge for each curve; neighbours share a vertex, and so do
/// the ends of a closed chain. The tolerance of a vertex covers the gap of its curves.
/// \throws std::invalid_argument for an empty chain, and as toGeom().
TopoDS_Wire wireOf(const PlanarChain& chain, const PlaneFrame& frame);

/// The wires in one compound.
TopoDS_Shape wiresOf(const std::vector<PlanarWire>& wires);

}  // namespace seamwright::occ
