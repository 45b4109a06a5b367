// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>

/// The geometry of a shape after a change of surfaces and pcurves. Not a public header.
namespace seamwright::occ {

/// The part without location and orientation, which all its instances share.
TopoDS_Shape bare(const TopoDS_Shape& shape);

/// The transformation from the frame of the shape to that of a part with this location.
gp_Trsf outOf(const TopLoc_Location& location);

/// The parts of one kind, numbered in the order of TopExp::MapShapes.
class NumberedParts {
 public:
  NumberedParts(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

  int count() const { return parts_.Extent(); }
  const TopoDS_Shape& operator()(int number) const { return parts_(number); }
  int number(const TopoDS_Shape& part) const { return parts_.FindIndex(part); }
  /// The numbers of these parts of another part.
  std::set<int> numbersIn(const TopoDS_Shape& part) const;
  /// \throws std::invalid_argument if the part occurs in the shape several times.
  void requireOnce(int number) const;

 private:
  TopAbs_ShapeEnum kind_;
  TopTools_IndexedMapOfShape parts_;
  std::map<const TopoDS_TShape*, int> instances_;
};

/// The faces, edges and vertices of a shape, and which of them are beside one another. Parts that
/// it returns are FORWARD.
class ConnectedParts {
 public:
  explicit ConnectedParts(const TopoDS_Shape& shape);

  const NumberedParts& faces() const { return faces_; }
  const NumberedParts& edges() const { return edges_; }
  const NumberedParts& vertices() const { return vertices_; }
  TopoDS_Face face(int number) const;
  TopoDS_Edge edge(int number) const;
  TopoDS_Vertex vertex(int number) const;
  std::vector<int> facesOfEdge(int edge) const;
  std::vector<int> edgesOfVertex(int vertex) const;

 private:
  NumberedParts faces_, edges_, vertices_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge_, edges_of_vertex_;
};

/// Surfaces and pcurves before and after a change.
class ChangedGeometry {
 public:
  /// \throws std::invalid_argument as withChanges().
  ChangedGeometry(const ConnectedParts& parts, const std::vector<FaceChange>& changes,
                  const std::vector<PathChange>& paths, double gap_mm);

  const ConnectedParts& parts() const { return parts_; }
  /// The faces that get another surface, and the edges that are beside one or get another pcurve.
  std::set<int> faces() const;
  std::set<int> edges() const;

  bool changes(int face) const { return changed_.count(face) > 0; }
  bool hasNewPath(int edge, int face) const { return new_paths_.count({edge, face}) > 0; }
  PlacedSurface surfaceBefore(int face) const { return surfaceOf(parts_.face(face)); }
  /// The surface in the frame of the shape.
  PlacedSurface surfaceAfter(int face) const;
  /// The same surface as the face stores it, with the location of its old surface.
  PlacedSurface storedAfter(int face) const;
  /// The pcurve of an edge on a face after the change; two if the face meets itself there.
  std::vector<PlanarPath> pathsAfter(int edge, int face) const;
  /// Both together, for all faces beside the edge.
  std::vector<EdgeSide> sidesAfter(int edge) const;

  /// What moves less counts as not moved.
  double near_mm() const { return gap_mm_ / 1000; }

 private:
  struct NewSurface {
    opencascade::handle<Geom_Surface> in_shape;
    PlacedSurface stored;
  };

  void add(const FaceChange& change);

  const ConnectedParts& parts_;
  double gap_mm_;
  std::map<int, NewSurface> changed_;  ///< by face
  std::map<std::pair<int, int>, opencascade::handle<Geom2d_Curve>>
      new_paths_;  ///< by edge and face
};

}  // namespace seamwright::occ
