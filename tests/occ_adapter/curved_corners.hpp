// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>

/// Solids with a corner between curved faces, and their fillets.
namespace seamwright::test {

/// Radii of the edges in their order about the vertex, counter-clockwise; begun again where there
/// are more edges.
occ::CornerFilletOptions withRadii(const occ::Model& model, int vertex,
                                   const std::vector<double>& radii_mm);

/// The solid with the corner at that point rounded.
occ::CornerFillet rounded(const TopoDS_Shape& shape, const Eigen::Vector3d& corner,
                          const std::vector<double>& radii_mm);

TopTools_IndexedMapOfShape parts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

/// OpenCASCADE's own fillets of the same edges.
TopoDS_Shape native(const TopoDS_Shape& shape, const std::vector<occ::CornerFilletEdge>& edges);

TopoDS_Shape box(double x, double y, double z);

/// About the origin; seam and poles outside of the first octant.
TopoDS_Shape ball(double radius);

/// An upright cylinder.
TopoDS_Shape upright(const gp_Pnt& foot, double radius, double height);

/// Its corner at (radius, 0, 0) has two planes at a right angle and the cylinder.
TopoDS_Shape wedge(double radius, double height);

/// Nearly a quarter of a disc of radius 20, 10 high. OpenCASCADE's extrusion has its cylinder on
/// left-handed axes.
TopoDS_Shape extrudedQuarterDisc();

/// A box of side 20 less a ball of radius 10 about a corner.
TopoDS_Shape boxLessBall();

/// A block that sticks out of an upright cylinder; its upper corner there has two concave edges and
/// a convex one.
TopoDS_Shape blockOnCylinder();

/// One upright edge rounded with 5 mm: the upper edges that it joins go on into one another
/// smoothly.
TopoDS_Shape boxWithRoundEdge();

/// A pointed dome of cylindrical gores of radius 40, whose axes are aside of the middle: the
/// steeper the further.
TopoDS_Shape vault(int gores, double aside_mm);
Eigen::Vector3d apex(double aside_mm);

}  // namespace seamwright::test
