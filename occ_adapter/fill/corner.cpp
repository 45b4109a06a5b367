// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom_BSplineCurve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/corner.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

/// If the sine of an angle is below this, two planes count as tangent, or a corner of a face as
/// degenerate.
constexpr double flat_sine = 1e-6;
/// Between two edges there is no corner; fills of 2 m sides are defined for m up to 6.
constexpr int least_edges = 3, most_edges = 6;

/// The edges and faces around the vertices and edges of one shell.
class Surroundings {
 public:
  Surroundings(const TopoDS_Shape& shape, const TopoDS_Shell& shell) : shell_(shell) {
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapesAndUniqueAncestors(shell, TopAbs_VERTEX, TopAbs_EDGE, edges_at_);
    TopExp::MapShapesAndUniqueAncestors(shell, TopAbs_EDGE, TopAbs_FACE, faces_at_);
  }

  int number(const TopoDS_Edge& edge) const { return edges_.FindIndex(edge); }
  int number(const TopoDS_Face& face) const { return faces_.FindIndex(face); }

  std::vector<TopoDS_Edge> edgesAt(const TopoDS_Vertex& vertex) const {
    std::vector<TopoDS_Edge> edges;
    for (const TopoDS_Shape& edge : edges_at_.FindFromKey(vertex))
      edges.push_back(TopoDS::Edge(edge));
    return edges;
  }

  std::array<TopoDS_Face, 2> facesAt(const TopoDS_Edge& edge) const {
    const TopTools_ListOfShape& faces = faces_at_.FindFromKey(edge);
    if (faces.Extent() != 2)
      throw CornerRefused(corner_why::edgeFaces(number(edge), faces.Extent()));
    return {TopoDS::Face(faces.First()), TopoDS::Face(faces.Last())};
  }

  /// The normal out of the solid at a vertex of the face.
  Vector3d normalAt(const TopoDS_Face& face, const TopoDS_Vertex& vertex) const {
    const BRepAdaptor_Surface surface(face, false);
    const gp_Pnt2d at = BRep_Tool::Parameters(vertex, face);
    gp_Pnt point;
    gp_Vec u, v;
    surface.D1(at.X(), at.Y(), point, u, v);
    const Vector3d normal = vector(u).cross(vector(v));
    if (!(normal.norm() > flat_sine * u.Magnitude() * v.Magnitude()) || u.Magnitude() == 0 ||
        v.Magnitude() == 0)
      throw CornerRefused(corner_why::noNormal(number(face)));
    return (face.Orientation() == TopAbs_REVERSED ? -1 : 1) * normal.normalized();
  }

 private:
  const TopoDS_Shell& shell_;
  TopTools_IndexedMapOfShape edges_, faces_;
  TopTools_IndexedDataMapOfShapeListOfShape edges_at_, faces_at_;
};

TopoDS_Vertex vertexOf(const TopoDS_Shape& shape, int number) {
  const TopTools_IndexedMapOfShape vertices = partsOf(shape, TopAbs_VERTEX);
  requirePart("vertex", "vertices", number, vertices.Extent());
  return TopoDS::Vertex(vertices(number));
}

bool holds(const TopoDS_Shape& whole, const TopoDS_Shape& part) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(whole, part.ShapeType(), parts);
  return parts.Contains(part);
}

/// The only solid, and its shell, that contain the vertex.
std::pair<TopoDS_Solid, TopoDS_Shell> homeOf(const TopoDS_Shape& shape, const TopoDS_Vertex& vertex,
                                             int number) {
  std::vector<std::pair<TopoDS_Solid, TopoDS_Shell>> homes;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    for (TopExp_Explorer shell(solid.Current(), TopAbs_SHELL); shell.More(); shell.Next())
      if (holds(shell.Current(), vertex))
        homes.emplace_back(TopoDS::Solid(solid.Current()), TopoDS::Shell(shell.Current()));
  if (homes.size() != 1)
    throw CornerRefused(corner_why::notInOneShell(number, static_cast<int>(homes.size())));
  return homes.front();
}

/// The edges by which the boundary of a face arrives at the vertex and leaves it, with the face to
/// the left as seen from outside.
struct Turn {
  TopoDS_Edge arriving, leaving;
};

Turn turnAt(const Surroundings& around, const TopoDS_Face& face, const TopoDS_Vertex& vertex) {
  Turn turn;
  int visits = 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    if (TopExp::LastVertex(edge, true).IsSame(vertex)) {
      turn.arriving = edge;
      ++visits;
    }
    if (TopExp::FirstVertex(edge, true).IsSame(vertex)) turn.leaving = edge;
  }
  if (visits != 1 || turn.leaving.IsNull())
    throw CornerRefused(corner_why::faceTwice(around.number(face), visits));
  return turn;
}

bool isPlane(const TopoDS_Face& face) {
  return BRepAdaptor_Surface(face, false).GetType() == GeomAbs_Plane;
}

/// A line, or a spline whose poles are on one within the tolerance of the edge, as some programs
/// write lines.
bool isStraight(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  if (curve.GetType() == GeomAbs_Line) return true;
  if (curve.GetType() != GeomAbs_BSplineCurve) return false;
  const opencascade::handle<Geom_BSplineCurve> spline = curve.BSpline();
  const Vector3d begin = vector(curve.Value(curve.FirstParameter()).XYZ()),
                 chord = vector(curve.Value(curve.LastParameter()).XYZ()) - begin;
  const double tolerance = BRep_Tool::Tolerance(edge);
  if (!(chord.norm() > tolerance)) return false;
  for (int k = 1; k <= spline->NbPoles(); ++k) {
    const Vector3d pole = vector(spline->Pole(k).XYZ()) - begin;
    if (pole.cross(chord).norm() > tolerance * chord.norm()) return false;
  }
  return true;
}

class CornerReader {
 public:
  CornerReader(const Surroundings& around, Corner& corner) : around_(around), corner_(corner) {}

  void read() {
    walk();
    for (std::size_t i = 0; i < corner_.count(); ++i) measureEdge(i);
    for (std::size_t i = 0; i < corner_.count(); ++i) measureFace(i);
    corner_.polyhedral =
        isOfPlanesAndLines() &&
        std::ranges::all_of(corner_.edges, [this](CornerEdge& edge) { return readEnd(edge); });
  }

 private:
  /// Walks from edge to edge around the vertex. A face lies to the left of the edge by which its
  /// boundary leaves the vertex.
  void walk() {
    const int expected = static_cast<int>(around_.edgesAt(corner_.vertex).size());
    if (expected < least_edges || expected > most_edges)
      throw CornerRefused(corner_why::edgeCount(expected, least_edges, most_edges));
    const TopoDS_Edge first = around_.edgesAt(corner_.vertex).front();
    TopoDS_Edge edge = first;
    do {
      const TopoDS_Face face = faceLeaving(edge);
      addEdge(edge);
      corner_.faces.push_back({face, around_.normalAt(face, corner_.vertex)});
      edge = turnAt(around_, face, corner_.vertex).arriving;
    } while (!edge.IsSame(first) && static_cast<int>(corner_.count()) <= expected);
    const int found = static_cast<int>(corner_.count());
    if (found != expected) throw CornerRefused(corner_why::notOneFan(found, expected));
  }

  TopoDS_Face faceLeaving(const TopoDS_Edge& edge) const {
    for (const TopoDS_Face& face : around_.facesAt(edge))
      if (turnAt(around_, face, corner_.vertex).leaving.IsSame(edge)) return face;
    throw CornerRefused(corner_why::facesTurned(around_.number(edge)));
  }

  void addEdge(const TopoDS_Edge& edge) {
    CornerEdge added;
    added.number = around_.number(edge);
    added.edge = edge;
    added.far = otherEnd(edge, corner_.vertex);
    if (added.far.IsSame(corner_.vertex)) throw CornerRefused(corner_why::edgeIsLoop(added.number));
    const BRepAdaptor_Curve curve(edge);
    gp_Pnt point;
    gp_Vec run;
    curve.D1(BRep_Tool::Parameter(corner_.vertex, edge), point, run);
    if (!(run.Magnitude() > 0)) throw CornerRefused(corner_why::noTangent(added.number));
    const bool leaves =
        TopExp::FirstVertex(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD))).IsSame(corner_.vertex);
    added.axis = (leaves ? 1 : -1) * vector(run).normalized();
    added.length_mm = (vector(BRep_Tool::Pnt(added.far).XYZ()) - corner_.point).norm();
    corner_.edges.push_back(added);
  }

  void measureEdge(std::size_t i) {
    CornerEdge& edge = corner_.edges[i];
    const Vector3d &before = corner_.faces[corner_.before(i)].normal,
                   &after = corner_.faces[i].normal;
    if (before.cross(after).norm() < flat_sine)
      throw CornerRefused(corner_why::smoothEdge(edge.number));
    edge.into = {Vector3d(edge.axis.cross(before).normalized()),
                 Vector3d(after.cross(edge.axis).normalized())};
    edge.convex = edge.into[1].dot(before) < 0;
    edge.opening_rad =
        std::atan2(edge.into[0].cross(edge.into[1]).norm(), edge.into[0].dot(edge.into[1]));
  }

  void measureFace(std::size_t i) {
    const Vector3d &from = corner_.edges[i].axis, &to = corner_.edges[corner_.after(i)].axis;
    CornerFace& face = corner_.faces[i];
    const double sine = face.normal.dot(from.cross(to));
    face.angle_rad = std::atan2(sine, from.dot(to));
    if (face.angle_rad < 0) face.angle_rad += 2 * std::numbers::pi;
    if (std::abs(sine) < flat_sine)
      throw CornerRefused(
          corner_why::flatAngle(around_.number(face.face), face.angle_rad * degrees_per_radian));
  }

  bool isOfPlanesAndLines() const {
    return std::ranges::all_of(corner_.faces,
                               [](const CornerFace& face) { return isPlane(face.face); }) &&
           std::ranges::all_of(corner_.edges,
                               [](const CornerEdge& edge) { return isStraight(edge.edge); });
  }

  /// Whether the far vertex has exactly one more face, a plane that meets both faces beside the
  /// edge in lines.
  bool readEnd(CornerEdge& edge) {
    const std::vector<TopoDS_Edge> edges = around_.edgesAt(edge.far);
    if (edges.size() != 3) return false;
    const auto i = static_cast<std::size_t>(&edge - corner_.edges.data());
    const std::array<TopoDS_Face, 2> beside = {corner_.faces[corner_.before(i)].face,
                                               corner_.faces[i].face};
    for (const TopoDS_Edge& other : edges) {
      if (other.IsSame(edge.edge)) continue;
      for (const TopoDS_Face& face : around_.facesAt(other))
        for (std::size_t side = 0; side < 2; ++side)
          if (face.IsSame(beside[side]))
            edge.end_edges[side] = other;
          else if (!face.IsSame(beside[1 - side]))
            edge.end = face;
    }
    return !edge.end.IsNull() && !edge.end_edges[0].IsNull() && !edge.end_edges[1].IsNull() &&
           isCutOff(edge, beside);
  }

  /// Whether the face at the far end is a plane across the edge that does not pass through the
  /// corner.
  bool isCutOff(CornerEdge& edge, const std::array<TopoDS_Face, 2>& beside) {
    if (!isPlane(edge.end) || std::ranges::any_of(corner_.faces, [&edge](const CornerFace& face) {
          return face.face.IsSame(edge.end);
        }))
      return false;
    edge.end_normal = around_.normalAt(edge.end, edge.far);
    return std::ranges::none_of(beside, [&](const TopoDS_Face& face) {
      return edge.end_normal.cross(around_.normalAt(face, edge.far)).norm() < flat_sine;
    });
  }

  const Surroundings& around_;
  Corner& corner_;
};

TopoDS_Solid solidOf(const TopoDS_Shape& shell) {
  const BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

bool isUnbounded(const TopoDS_Solid& solid) {
  BRepClass3d_SolidClassifier classifier(solid);
  classifier.PerformInfinitePoint(Precision::Confusion());
  return classifier.State() == TopAbs_IN;
}

/// The same corner with inside and outside exchanged.
Corner turnedInsideOut(Corner corner) {
  corner.shell = TopoDS::Shell(corner.shell.Reversed());
  std::ranges::reverse(corner.edges);
  std::ranges::reverse(corner.faces);
  std::rotate(corner.faces.begin(), corner.faces.begin() + 1, corner.faces.end());
  for (CornerEdge& edge : corner.edges) {
    std::swap(edge.into[0], edge.into[1]);
    edge.convex = !edge.convex;
  }
  for (CornerFace& face : corner.faces) {
    face.face = TopoDS::Face(face.face.Reversed());
    face.normal = -face.normal;
  }
  return corner;
}

}  // namespace

TopoDS_Vertex otherEnd(const TopoDS_Edge& edge, const TopoDS_Vertex& vertex) {
  const TopoDS_Vertex first = TopExp::FirstVertex(edge);
  return first.IsSame(vertex) ? TopExp::LastVertex(edge) : first;
}

std::pair<Corner, bool> ofShellAlone(const Corner& corner) {
  TopExp_Explorer shells(corner.solid, TopAbs_SHELL);
  shells.Next();
  if (!shells.More()) return {corner, false};
  Corner alone = corner;
  alone.solid = solidOf(corner.shell);
  const bool in_void = isUnbounded(alone.solid);
  if (in_void) {
    alone = turnedInsideOut(std::move(alone));
    alone.solid = solidOf(alone.shell);
  }
  return {std::move(alone), in_void};
}

Corner cornerOf(const TopoDS_Shape& shape, int vertex) {
  Corner corner;
  corner.vertex = vertexOf(shape, vertex);
  corner.point = vector(BRep_Tool::Pnt(corner.vertex).XYZ());
  std::tie(corner.solid, corner.shell) = homeOf(shape, corner.vertex, vertex);
  const Surroundings around(shape, corner.shell);
  CornerReader(around, corner).read();
  TopExp::MapShapes(shape, TopAbs_FACE, corner.given_faces);
  TopExp::MapShapes(shape, TopAbs_EDGE, corner.given_edges);
  return corner;
}

}  // namespace seamwright::occ
