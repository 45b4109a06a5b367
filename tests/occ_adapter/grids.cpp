// SPDX-License-Identifier: LGPL-2.1-or-later
#include "grids.hpp"

#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <array>
#include <map>

#include "match_pairs.hpp"

namespace seamwright::test {

Patches cutUp(const Spline& whole, const std::vector<double>& at_u,
              const std::vector<double>& at_v) {
  Patches patches(at_u.size() - 1);
  for (std::size_t i = 0; i + 1 < at_u.size(); ++i)
    for (std::size_t j = 0; j + 1 < at_v.size(); ++j) {
      const Spline part = Spline::DownCast(whole->Copy());
      part->Segment(at_u[i], at_u[i + 1], at_v[j], at_v[j + 1]);
      patches[i].push_back(part);
    }
  return patches;
}

namespace {

class GridBuilder {
 public:
  explicit GridBuilder(const Patches& patches) : patches_(patches) {}

  TopoDS_Shape build(double tolerance_mm) {
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (std::size_t i = 0; i < patches_.size(); ++i)
      for (std::size_t j = 0; j < patches_[i].size(); ++j) builder_.Add(shell, face(i, j));
    return withTolerance(shell, tolerance_mm);
  }

 private:
  using Key = std::array<std::size_t, 3>;

  TopoDS_Face face(std::size_t i, std::size_t j) {
    const Spline& patch = patches_[i][j];
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    patch->Bounds(u0, u1, v0, v1);
    TopoDS_Face face;
    builder_.MakeFace(face, handle<Geom_Surface>(patch), 1e-7);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    const auto add = [&](const Key& key, bool along_u, double at, double first, double last,
                         const Key& from, const Key& to, TopAbs_Orientation sense) {
      const handle<Geom_Curve> curve = along_u ? patch->VIso(at) : patch->UIso(at);
      const TopoDS_Edge edge = edgeOf(key, curve, first, last, from, to);
      builder_.UpdateEdge(edge,
                          new Geom2d_Line(along_u ? gp_Pnt2d(0, at) : gp_Pnt2d(at, 0),
                                          along_u ? gp_Dir2d(1, 0) : gp_Dir2d(0, 1)),
                          face, 1e-7);
      builder_.Range(edge, face, first, last);
      builder_.Add(wire, edge.Oriented(sense));
    };
    const Key c00 = {i, j, 2}, c10 = {i + 1, j, 2}, c01 = {i, j + 1, 2}, c11 = {i + 1, j + 1, 2};
    add({i, j, 0}, true, v0, u0, u1, c00, c10, TopAbs_FORWARD);
    add({i + 1, j, 1}, false, u1, v0, v1, c10, c11, TopAbs_FORWARD);
    add({i, j + 1, 0}, true, v1, u0, u1, c01, c11, TopAbs_REVERSED);
    add({i, j, 1}, false, u0, v0, v1, c00, c01, TopAbs_REVERSED);
    wire.Closed(true);
    builder_.Add(face, wire);
    return face;
  }

  TopoDS_Edge edgeOf(const Key& key, const handle<Geom_Curve>& curve, double first, double last,
                     const Key& from, const Key& to) {
    if (edges_.count(key) == 0) {
      TopoDS_Edge edge;
      builder_.MakeEdge(edge, curve, 1e-7);
      builder_.Range(edge, first, last);
      builder_.Add(edge, vertexOf(from, curve->Value(first)).Oriented(TopAbs_FORWARD));
      builder_.Add(edge, vertexOf(to, curve->Value(last)).Oriented(TopAbs_REVERSED));
      edges_[key] = edge;
    }
    return edges_[key];
  }

  TopoDS_Vertex vertexOf(const Key& key, const gp_Pnt& point) {
    if (vertices_.count(key) == 0) builder_.MakeVertex(vertices_[key], point, 1e-7);
    return vertices_[key];
  }

  const Patches& patches_;
  BRep_Builder builder_;
  std::map<Key, TopoDS_Edge> edges_;
  std::map<Key, TopoDS_Vertex> vertices_;
};

}  // namespace

TopoDS_Shape gridOf(const Patches& patches, double tolerance_mm) {
  return GridBuilder(patches).build(tolerance_mm);
}

}  // namespace seamwright::test
