// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <TopoDS_Shape.hxx>
#include <vector>

/// Polyhedra with a corner to be rounded.
namespace seamwright::test {

/// A solid whose faces are these polygons of points, counter-clockwise seen from outside.
TopoDS_Shape polyhedron(const std::vector<Eigen::Vector3d>& points,
                        const std::vector<std::vector<int>>& faces);

/// A pyramid over a polygon of the plane z = 0, counter-clockwise, with this apex.
TopoDS_Shape pyramid(const std::vector<Eigen::Vector3d>& base, const Eigen::Vector3d& apex);
/// Over a regular polygon of radius 10 that lies in the plane z = 0.
TopoDS_Shape regularPyramid(int sides, double height);
/// A cube of side 10 with its corner of the first octant cut out to half the side: one vertex, (5,
/// 5, 5), has three concave edges, three others two convex ones and a concave one.
TopoDS_Shape notchedCube();

/// The same solid with splines in place of the lines of its edges, as some programs write them.
TopoDS_Shape linesAsSplines(const TopoDS_Shape& shape);

/// The number of the vertex at the point, from 1, order of TopExp::MapShapes; 0 if there is none.
int vertexAt(const TopoDS_Shape& shape, const Eigen::Vector3d& point);

double volume_mm3(const TopoDS_Shape& shape);

}  // namespace seamwright::test
