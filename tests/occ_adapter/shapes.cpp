// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <gp_Quaternion.hxx>
#include <limits>
#include <numbers>
#include <sstream>

namespace seamwright::test {

namespace {

/// Straight path from p to q for parameters 0..1.
opencascade::handle<Geom2d_BSplineCurve> straight(const gp_Pnt2d& p, const gp_Pnt2d& q) {
  NCollection_Array1<gp_Pnt2d> poles(1, 2);
  poles(1) = p;
  poles(2) = q;
  NCollection_Array1<double> knots(1, 2);
  knots(1) = 0;
  knots(2) = 1;
  NCollection_Array1<int> multiplicities(1, 2);
  multiplicities.Init(2);
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

gp_Pnt pointOf(const Polygon& polygon, std::size_t corner) {
  const gp_Pnt2d& uv = polygon.corners[corner % polygon.corners.size()];
  return polygon.surface->Value(uv.X(), uv.Y());
}

TopoDS_Vertex vertexAt(const gp_Pnt& point) {
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(vertex, point, 1e-6);
  return vertex;
}

TopoDS_Edge edgeOn(const TopoDS_Face& face, const gp_Pnt2d& p, const gp_Pnt2d& q,
                   const TopoDS_Vertex& first, const TopoDS_Vertex& last) {
  BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, straight(p, q), face, 1e-6);
  builder.Range(edge, 0, 1);
  builder.Add(edge, first.Oriented(TopAbs_FORWARD));
  builder.Add(edge, last.Oriented(TopAbs_REVERSED));
  BRepLib::BuildCurve3d(edge, 1e-7);
  return edge;
}

/// Adds a wire of the given first edge (as oriented) and new edges along the other sides.
void close(TopoDS_Face& face, const Polygon& polygon, const TopoDS_Edge& first_edge,
           TopoDS_Vertex from, const TopoDS_Vertex& to) {
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  builder.Add(wire, first_edge);
  const std::size_t n = polygon.corners.size();
  for (std::size_t k = 1; k < n; ++k) {
    const TopoDS_Vertex next = k + 1 == n ? to : vertexAt(pointOf(polygon, k + 1));
    builder.Add(wire, edgeOn(face, polygon.corners[k], polygon.corners[(k + 1) % n], from, next));
    from = next;
  }
  wire.Closed(true);
  builder.Add(face, wire);
}

}  // namespace

TopTools_IndexedMapOfShape partsOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, kind, parts);
  return parts;
}

TopoDS_Shape box() {
  return BRepPrimAPI_MakeBox(10, 20, 30).Shape();
}

std::vector<gp_Pnt2d> rectangle(double u0, double u1, double v0, double v1) {
  return {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
}

std::vector<gp_Pnt2d> beginningWith(std::size_t corner, std::vector<gp_Pnt2d> corners) {
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(corner),
              corners.end());
  return corners;
}

TopoDS_Shape joined(const Polygon& a, const Polygon& b) {
  BRep_Builder builder;
  TopoDS_Face face_a, face_b;
  builder.MakeFace(face_a, a.surface, 1e-7);
  builder.MakeFace(face_b, b.surface, 1e-7);
  const TopoDS_Vertex start = vertexAt(pointOf(a, 0)), end = vertexAt(pointOf(a, 1));
  const TopoDS_Edge edge = edgeOn(face_a, a.corners[0], a.corners[1], start, end);
  const bool same_way =
      pointOf(a, 0).Distance(pointOf(b, 0)) < pointOf(a, 0).Distance(pointOf(b, 1));
  builder.UpdateEdge(
      edge, same_way ? straight(b.corners[0], b.corners[1]) : straight(b.corners[1], b.corners[0]),
      face_b, BRep_Tool::Tolerance(edge));
  close(face_a, a, edge, end, start);
  if (same_way)
    close(face_b, b, edge, end, start);
  else
    close(face_b, b, TopoDS::Edge(edge.Reversed()), start, end);
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, face_a);
  builder.Add(shell, same_way ? face_b.Reversed() : TopoDS_Shape(face_b));
  return shell;
}

TopoDS_Shape planeAndCylinder(double r, double length) {
  // The plane z = 0 for x <= 0; the cylinder about the line x = 0, z = -r rolls away from it for x
  // >= 0.
  const opencascade::handle<Geom_Surface> plane = new Geom_Plane(gp::XOY());
  const gp_Ax3 axis(gp_Pnt(0, 0, -r), gp::DY(), gp::DZ());
  const opencascade::handle<Geom_Surface> cylinder = new Geom_CylindricalSurface(axis, r);
  const double quarter = std::numbers::pi / 2;
  return joined({plane, beginningWith(1, rectangle(-length, 0, 0, length))},
                {cylinder, beginningWith(3, rectangle(0, quarter, 0, length))});
}

TopoDS_Shape crossedCylinders(double r) {
  // x^2 + (z + r)^2 = r^2 and y^2 + (z + r)^2 = r^2 touch in the origin and share the ellipse above
  // x = y: with x = y = r sin(phi) the path is (phi, r sin(phi)), here (phi, r phi) with an error
  // of r phi^3 / 6.
  const gp_Ax3 along_y(gp_Pnt(0, 0, -r), gp::DY(), gp::DZ());   // u runs towards +x
  const gp_Ax3 along_x(gp_Pnt(0, 0, -r), -gp::DX(), gp::DZ());  // u runs towards +y, v towards -x
  const opencascade::handle<Geom_Surface> a = new Geom_CylindricalSurface(along_y, r);
  const opencascade::handle<Geom_Surface> b = new Geom_CylindricalSurface(along_x, r);
  const double h = 6e-4;
  return joined({a, {{-h, -r * h}, {h, r * h}, {-h, r * h}}},
                {b, {{h, -r * h}, {-h, r * h}, {-h, -r * h}}});
}

TopoDS_Shape sphereAndTorus(double r, double tube) {
  const double latitude = 0.5;
  const opencascade::handle<Geom_Surface> sphere = new Geom_SphericalSurface(gp_Ax3(gp::XOY()), r);
  const double off = r - tube;  // centre of the tube circle, on the normal of the sphere
  const gp_Ax3 frame(gp_Pnt(0, 0, off * std::sin(latitude)), gp::DZ(), gp::DX());
  const opencascade::handle<Geom_Surface> torus =
      new Geom_ToroidalSurface(frame, off * std::cos(latitude), tube);
  return joined({sphere, beginningWith(2, rectangle(0.2, 1.7, 0.1, latitude))},
                {torus, rectangle(0.2, 1.7, latitude, 0.9)});
}

TopoDS_Shape foldedPlanes() {
  const opencascade::handle<Geom_Surface> below = new Geom_Plane(gp::XOY());
  const opencascade::handle<Geom_Surface> above =
      new Geom_Plane(gp_Ax3(gp::Origin(), -gp::DZ(), -gp::DX()));
  // Both lie over x <= 0 and share the line x = 0.
  return joined({below, beginningWith(1, rectangle(-5, 0, 0, 7))},
                {above, beginningWith(3, rectangle(0, 5, 0, 7))});
}

gp_Trsf randomMotion(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  gp_Quaternion turn(number(random), number(random), number(random), number(random));
  turn.Normalize();
  gp_Trsf rotation, shift;
  rotation.SetRotation(turn);
  shift.SetTranslation(gp_Vec(100 * number(random), 100 * number(random), 100 * number(random)));
  return shift * rotation;
}

TopoDS_Shape transformed(const TopoDS_Shape& shape, const gp_Trsf& by) {
  return BRepBuilderAPI_Transform(shape, by, true).Shape();
}

TopoDS_Shape located(const TopoDS_Shape& shape, const gp_Trsf& by) {
  TopoDS_Shape copy = shape;
  copy.Location(TopLoc_Location(by) * shape.Location(), false);
  return copy;
}

TopoDS_Shape facesSwappedAndReversed(const TopoDS_Shape& shape) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (int i = faces.Extent(); i >= 1; --i) builder.Add(compound, faces(i).Reversed());
  return compound;
}

occ::Report analyzed(const TopoDS_Shape& shape, const occ::AnalyzeOptions& options) {
  return occ::analyze(occ::modelFromShape(shape), options);
}

void expectEncloses(const std::optional<Figure>& figure, double value, double tolerance,
                    double noise) {
  ASSERT_TRUE(figure && figure->upper);
  EXPECT_LE(figure->lower, value + noise);
  EXPECT_GE(*figure->upper, value - noise);
  const double allowed = 1.001 * std::max(0.01 * value, 0.01 * tolerance);
  EXPECT_GE(figure->lower, value - allowed - noise);
  EXPECT_LE(*figure->upper, value + allowed + noise);
}

double upper(const std::optional<Figure>& figure) {
  return figure && figure->upper ? *figure->upper : std::numeric_limits<double>::infinity();
}

double angleDeg(const occ::SeamResult& seam) {
  return seam.figures.angle_rad ? seam.figures.angle_rad->lower / degree
                                : std::numeric_limits<double>::quiet_NaN();
}

double curvature(const occ::SeamResult& seam) {
  return seam.figures.curvature_per_mm ? seam.figures.curvature_per_mm->lower
                                       : std::numeric_limits<double>::quiet_NaN();
}

double relativeCurvature(const occ::SeamResult& seam) {
  return seam.figures.curvature_rel ? seam.figures.curvature_rel->lower
                                    : std::numeric_limits<double>::quiet_NaN();
}

std::string describe(const occ::SeamResult& seam) {
  std::ostringstream text;
  text << "seam " << seam.id << " edge " << seam.edges.at(0) << " faces " << seam.faces[0] << '-'
       << seam.faces[1] << " gap " << (seam.figures.gap_mm ? seam.figures.gap_mm->lower : -1)
       << " angle " << angleDeg(seam) << " deg curvature " << curvature(seam) << " rel "
       << relativeCurvature(seam) << ' ' << name(seam.verdict.level) << ' '
       << name(seam.verdict.seam_class) << " '" << seam.note << "'";
  return text.str();
}

TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

std::vector<TopoDS_Shape> apart(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    faces.push_back(BRepBuilderAPI_Copy(face.Current()).Shape());
  return faces;
}

TopoDS_Shape plate(double x0, double x1, double y0, double y1, double z) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, z), gp::DZ()), x0, x1, y0, y1).Shape();
}

}  // namespace seamwright::test
