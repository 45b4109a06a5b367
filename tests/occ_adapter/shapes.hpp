// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_Surface.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt2d.hxx>
#include <gp_Trsf.hxx>
#include <random>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/analyze/analyze.hpp>

/// Shapes made for the tests, and short ways to ask for their seams.
namespace seamwright::test {

constexpr double degree = radians_per_degree;

/// In the order of TopExp::MapShapes, from 1.
TopTools_IndexedMapOfShape partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

/// 10 by 20 by 30 mm.
TopoDS_Shape box();

/// A face over a polygon of the parameter plane, corners counter-clockwise.
struct Polygon {
  opencascade::handle<Geom_Surface> surface;
  std::vector<gp_Pnt2d> corners;
};

/// The four corners of a rectangle, beginning with the side v = v0 (from u0 to u1).
std::vector<gp_Pnt2d> rectangle(double u0, double u1, double v0, double v1);
/// The same corners beginning with another of them, so that another side comes first.
std::vector<gp_Pnt2d> beginningWith(std::size_t corner, std::vector<gp_Pnt2d> corners);

/// Two faces that share an edge: the first side of both polygons. Both paths are linear in the
/// edge's parameter.
TopoDS_Shape joined(const Polygon& a, const Polygon& b);

/// A plane piece and a quarter of a cylinder of radius r that are tangent along a line of that
/// length.
TopoDS_Shape planeAndCylinder(double r, double length);
/// Two cylinders of radius r whose axes cross at 90 degrees, meeting along so short a piece of
/// their common ellipse about the point of contact that the angle stays below 0.05 degrees.
TopoDS_Shape crossedCylinders(double r);
/// A sphere of radius r and a torus of tube radius \p tube < r, tangent along a circle.
TopoDS_Shape sphereAndTorus(double r, double tube);
/// Two half planes on top of one another that share a line: a knife edge, tangent planes equal.
TopoDS_Shape foldedPlanes();

gp_Trsf randomMotion(std::mt19937& random);
/// The shape with its geometry moved.
TopoDS_Shape transformed(const TopoDS_Shape& shape, const gp_Trsf& by);
/// The shape with a location, geometry shared; scaling and mirroring locations are allowed here.
TopoDS_Shape located(const TopoDS_Shape& shape, const gp_Trsf& by);
/// The faces of the shape in opposite order, each with opposite orientation.
TopoDS_Shape facesSwappedAndReversed(const TopoDS_Shape& shape);

occ::Report analyzed(const TopoDS_Shape& shape, const occ::AnalyzeOptions& options = {});
std::string describe(const occ::SeamResult& seam);

/// The figure encloses the value to what is asked for: it has an upper bound, holds the value but
/// for \p noise, and reaches no further than max(1 % of it, a hundredth of the tolerance) below it
/// and above it.
void expectEncloses(const std::optional<Figure>& figure, double value, double tolerance,
                    double noise = 0);

/// Infinite where it has none.
double upper(const std::optional<Figure>& figure);

double angleDeg(const occ::SeamResult& seam);
double curvature(const occ::SeamResult& seam);
double relativeCurvature(const occ::SeamResult& seam);

TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& shapes);
/// Copies of the faces that share nothing.
std::vector<TopoDS_Shape> apart(const TopoDS_Shape& shape);

/// Of the plane at height z.
TopoDS_Shape plate(double x0, double x1, double y0, double y1, double z = 0);

}  // namespace seamwright::test
