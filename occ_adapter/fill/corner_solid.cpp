// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/fill/corner_solid.hpp>
#include <seamwright/occ_adapter/fill/corner_tubes.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using opencascade::handle;
using std::numbers::pi;

handle<Geom2d_Curve> straight(const gp_Pnt2d& from, const gp_Pnt2d& to) {
  TColgp_Array1OfPnt2d poles(1, 2);
  poles(1) = from;
  poles(2) = to;
  return new Geom2d_BezierCurve(poles);
}

/// The patches of a corner, with wires that are still to be added.
struct CornerPatches {
  std::vector<TopoDS_Face> faces;
  /// Halves of the sides, in the direction of the sides.
  std::vector<std::array<TopoDS_Edge, 2>> halves;
  std::vector<TopoDS_Edge> spokes;  ///< from the centre to the middles of the sides
};

/// Side 2 i is the section of edge i, side 2 i + 1 the curve in the face after the edge.
bool isSection(std::size_t side) {
  return side % 2 == 0;
}

/// The two halves of a side, with pcurves on both patches and, for a section, on its cylinder.
std::array<TopoDS_Edge, 2> halvesOf(std::size_t side, const Corner& corner, const CornerHole& hole,
                                    const std::vector<CornerTube>& tubes,
                                    const std::vector<TopoDS_Face>& patches,
                                    const EdgeMaker& maker) {
  const CornerTube& tube = tubes[side / 2];
  const bool section = isSection(side);
  const TopoDS_Vertex& from = section ? tube.near[0] : tube.near[1];
  const TopoDS_Vertex& to = section ? tube.near[1] : tubes[corner.after(side / 2)].near[0];
  const auto curves = hole.sides[side].edge.split(0.5);
  const TopoDS_Vertex middle = maker.vertex(curves.first.point(1));
  std::array<TopoDS_Edge, 2> parts = {maker.edge(toBezierCurve(curves.first), 0, 1, from, middle),
                                      maker.edge(toBezierCurve(curves.second), 0, 1, middle, to)};
  const std::size_t next = (side + 1) % patches.size();
  maker.lay(parts[0], new Geom2d_Line(gp_Pnt2d(1, 1), -gp::DX2d()), patches[side]);
  maker.lay(parts[1], new Geom2d_Line(gp_Pnt2d(1, 0), gp::DY2d()), patches[next]);
  if (section) {
    maker.lay(parts[0], straight({tube.u[0], 0}, {pi, 0}), tube.face);
    maker.lay(parts[1], straight({pi, 0}, {tube.u[1], 0}), tube.face);
  }
  for (const TopoDS_Edge& part : parts) BRep_Builder().Range(part, 0, 1);
  return parts;
}

CornerPatches cornerPatches(const Corner& corner, const CornerHole& hole, const NSidedFill& fill,
                            const std::vector<CornerTube>& tubes, const EdgeMaker& maker) {
  const BRep_Builder builder;
  CornerPatches made;
  for (const BezierPatch& patch : fill.patches) {
    made.faces.emplace_back();
    builder.MakeFace(made.faces.back(), toBezierSurface(patch), maker.tolerance_mm());
  }
  const TopoDS_Vertex centre = maker.vertex(fill.patches.front().pole(0, 0));
  for (std::size_t side = 0; side < made.faces.size(); ++side) {
    made.halves.push_back(halvesOf(side, corner, hole, tubes, made.faces, maker));
    const TopoDS_Vertex middle = TopExp::LastVertex(made.halves.back()[0]);
    const TopoDS_Edge spoke =
        maker.edge(toBezierCurve(fill.patches[side].isoCurveU(0)), 0, 1, centre, middle);
    maker.lay(spoke, new Geom2d_Line(gp::Origin2d(), gp::DY2d()), made.faces[side]);
    maker.lay(spoke, new Geom2d_Line(gp::Origin2d(), gp::DX2d()),
              made.faces[(side + 1) % made.faces.size()]);
    builder.Range(spoke, 0, 1);
    made.spokes.push_back(spoke);
  }
  return made;
}

/// A new end of an edge, where the fillet of an edge of the corner ends; null where the end stays.
struct FarTrim {
  TopoDS_Vertex end;
  std::size_t fillet = 0;
};

/// Gives the faces of the shell their new edges. The parts are kept by reference.
class FaceRenewal {
 public:
  FaceRenewal(const Corner& corner, const std::vector<CornerTube>& tubes,
              const CornerPatches& patches, const EdgeMaker& maker)
      : corner_(corner), tubes_(tubes), patches_(patches), maker_(maker) {
    for (std::size_t i = 0; i < corner.count(); ++i) trimEnd(i);
  }

  /// A face of the shell with its new edges; the face itself if they are the same.
  TopoDS_Face renewed(const TopoDS_Face& old) {
    const TopoDS_Face forward = TopoDS::Face(old.Oriented(TopAbs_FORWARD));
    TopoDS_Face face = TopoDS::Face(forward.EmptyCopied());
    bool changed = false;
    for (TopoDS_Iterator part(forward); part.More(); part.Next()) {
      if (part.Value().ShapeType() == TopAbs_WIRE) {
        const std::optional<TopoDS_Wire> wire = renewedWire(TopoDS::Wire(part.Value()), forward);
        changed = changed || wire;
        builder_.Add(face, wire ? *wire : TopoDS::Wire(part.Value()));
      } else {
        builder_.Add(face, part.Value());
      }
    }
    if (!changed) return old;
    became_.Bind(old, face.Oriented(old.Orientation()));
    return TopoDS::Face(face.Oriented(old.Orientation()));
  }

  /// The new faces by the faces that they replace.
  const TopTools_DataMapOfShapeShape& became() const { return became_; }

 private:
  /// Trims the edges of the far face at the contact lines.
  void trimEnd(std::size_t i) {
    const CornerEdge& corner_edge = corner_.edges[i];
    for (std::size_t side = 0; side < 2; ++side) {
      const TopoDS_Edge& old = corner_edge.end_edges[side];
      auto& ends = trims_[old_.Add(old.Oriented(TopAbs_FORWARD))];
      const bool at_first =
          TopExp::FirstVertex(TopoDS::Edge(old.Oriented(TopAbs_FORWARD))).IsSame(corner_edge.far);
      ends[at_first ? 0 : 1] = {tubes_[i].far[side], i};
    }
  }

  /// The given edge, trimmed if necessary, with its own orientation.
  TopoDS_Edge trimmed(const TopoDS_Edge& old) {
    const int number = old_.FindIndex(old);
    if (number == 0) return old;
    auto made = trimmed_.find(number);
    if (made == trimmed_.end()) {
      const TopoDS_Edge whole = TopoDS::Edge(old_(number));
      const auto& cut = trims_[number];
      requireRest(whole, cut, corner_.given_edges.FindIndex(old));
      const TopoDS_Vertex from = cut[0].end.IsNull() ? TopExp::FirstVertex(whole) : cut[0].end,
                          to = cut[1].end.IsNull() ? TopExp::LastVertex(whole) : cut[1].end;
      made = trimmed_.emplace(number, maker_.line(from, to)).first;
    }
    return TopoDS::Edge(made->second.Oriented(old.Orientation()));
  }

  /// Requires that the fillets leave a part of an edge at their far ends.
  void requireRest(const TopoDS_Edge& whole, const std::array<FarTrim, 2>& trims,
                   int number) const {
    const std::array<Vector3d, 2> ends = {pointAt(TopExp::FirstVertex(whole)),
                                          pointAt(TopExp::LastVertex(whole))};
    const Vector3d run = ends[1] - ends[0];
    std::vector<corner_why::FarCutter> cutters;
    double left_mm = run.norm(), least_mm = 0;
    for (const std::size_t end : {0, 1}) {
      if (trims[end].end.IsNull()) continue;
      const double cut_mm =
          (end == 0 ? 1 : -1) * run.normalized().dot(pointAt(trims[end].end) - ends[end]);
      const CornerEdge& edge = corner_.edges[trims[end].fillet];
      cutters.push_back({edge.number, tubes_[trims[end].fillet].surface->Radius(), cut_mm});
      left_mm -= cut_mm;
      least_mm = std::min(least_mm, cut_mm);
    }
    // A choice: a shorter rest of the edge would be a sliver.
    if (!(left_mm > 1e-3 * run.norm()) || least_mm < -maker_.tolerance_mm())
      throw CornerRefused(corner_why::farEdgeCut(number, run.norm(), cutters));
  }

  std::optional<TopoDS_Wire> renewedWire(const TopoDS_Wire& old, const TopoDS_Face& face) {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    bool changed = false;
    for (BRepTools_WireExplorer walk(old, face); walk.More(); walk.Next()) {
      const std::vector<TopoDS_Edge> parts = replacements(walk.Current(), face);
      changed = changed || parts.size() != 1 || !parts.front().IsSame(walk.Current());
      for (const TopoDS_Edge& part : parts) builder_.Add(wire, part);
    }
    if (!changed) return std::nullopt;
    wire.Closed(true);
    return wire;
  }

  /// The edges that replace an oriented edge of the face. If it ended at the removed vertex, the
  /// edges that follow there are included.
  std::vector<TopoDS_Edge> replacements(const TopoDS_Edge& old, const TopoDS_Face& face) {
    const TopoDS_Vertex last = TopExp::LastVertex(old, true);
    for (std::size_t i = 0; i < corner_.count(); ++i) {
      if (!old.IsSame(corner_.edges[i].edge)) continue;
      const bool after = face.IsSame(corner_.faces[i].face);
      const TopoDS_Edge& contact = tubes_[i].contacts[after ? 1 : 0];
      if (!last.IsSame(corner_.vertex)) return {contact};
      const TopoDS_Edge arriving = TopoDS::Edge(contact.Reversed());
      const auto& spring = patches_.halves[2 * (after ? i : corner_.before(i)) + 1];
      if (after) return {arriving, spring[0], spring[1]};
      return {arriving, TopoDS::Edge(spring[1].Reversed()), TopoDS::Edge(spring[0].Reversed())};
    }
    std::vector<TopoDS_Edge> parts = {trimmed(old)};
    for (std::size_t i = 0; i < corner_.count(); ++i)
      if (last.IsSame(corner_.edges[i].far) && face.IsSame(corner_.edges[i].end)) {
        const bool before = old.IsSame(corner_.edges[i].end_edges[0]);
        parts.push_back(before ? tubes_[i].end : TopoDS::Edge(tubes_[i].end.Reversed()));
      }
    return parts;
  }

  const Corner& corner_;
  const std::vector<CornerTube>& tubes_;
  const CornerPatches& patches_;
  const EdgeMaker& maker_;
  BRep_Builder builder_;
  TopTools_DataMapOfShapeShape became_;
  TopTools_IndexedMapOfShape old_;  ///< edges at far ends
  /// New ends of these edges.
  std::map<int, std::array<FarTrim, 2>> trims_;
  std::map<int, TopoDS_Edge> trimmed_;
};

TopoDS_Wire wireOf(std::initializer_list<TopoDS_Shape> edges) {
  const BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Shape& edge : edges) builder.Add(wire, edge);
  wire.Closed(true);
  return wire;
}

/// The cylinder with its wire and orientation.
TopoDS_Face finished(const CornerTube& tube, const std::array<TopoDS_Edge, 2>& section,
                     bool convex) {
  const TopAbs_Orientation sense = convex ? TopAbs_FORWARD : TopAbs_REVERSED;
  const TopoDS_Wire wire = wireOf({section[1].Reversed(), section[0].Reversed(), tube.contacts[0],
                                   tube.end, tube.contacts[1].Reversed()});
  TopoDS_Face face = tube.face;
  BRep_Builder().Add(face, wire.Oriented(sense));
  return TopoDS::Face(face.Oriented(sense));
}

TopoDS_Face finished(const CornerPatches& patches, std::size_t k) {
  const std::size_t count = patches.faces.size(), previous = (k + count - 1) % count;
  TopoDS_Face face = patches.faces[k];
  BRep_Builder().Add(face, wireOf({patches.spokes[previous], patches.halves[previous][1],
                                   patches.halves[k][0], patches.spokes[k].Reversed()}));
  return face;
}

std::vector<std::pair<TopoDS_Edge, CornerSeamKind>> seamsOf(const std::vector<CornerTube>& tubes,
                                                            const CornerPatches& patches) {
  std::vector<std::pair<TopoDS_Edge, CornerSeamKind>> seams;
  for (const CornerTube& tube : tubes)
    for (const TopoDS_Edge& contact : tube.contacts)
      seams.emplace_back(contact, CornerSeamKind::Contact);
  for (std::size_t side = 0; side < patches.halves.size(); ++side) {
    for (const TopoDS_Edge& half : patches.halves[side])
      seams.emplace_back(half, isSection(side) ? CornerSeamKind::Section : CornerSeamKind::Spring);
    seams.emplace_back(patches.spokes[side], CornerSeamKind::Spoke);
  }
  return seams;
}

}  // namespace

CornerShell cornerShell(const Corner& corner, const CornerHole& hole, const NSidedFill& fill) {
  const EdgeMaker maker(std::max(Precision::Confusion(), 2 * hole.section_error_mm));
  std::vector<CornerTube> tubes;
  for (std::size_t i = 0; i < corner.count(); ++i)
    tubes.push_back(cornerTube(corner.edges[i], hole.strips[i], maker));
  const CornerPatches patches = cornerPatches(corner, hole, fill, tubes, maker);
  FaceRenewal renewal(corner, tubes, patches, maker);
  const BRep_Builder builder;
  CornerShell result;
  builder.MakeShell(result.shell);
  for (TopoDS_Iterator face(corner.shell); face.More(); face.Next())
    builder.Add(result.shell, renewal.renewed(TopoDS::Face(face.Value())));
  for (std::size_t i = 0; i < corner.count(); ++i)
    builder.Add(result.shell, finished(tubes[i], patches.halves[2 * i], corner.edges[i].convex));
  for (std::size_t k = 0; k < patches.faces.size(); ++k)
    builder.Add(result.shell, finished(patches, k));
  result.shell.Closed(true);
  result.became = renewal.became();
  result.seams = seamsOf(tubes, patches);
  return result;
}

TopoDS_Shape withShell(const TopoDS_Shape& shape, const TopoDS_Shell& shell,
                       const TopoDS_Shell& other) {
  if (shape.IsSame(shell)) return other;
  if (shape.ShapeType() >= TopAbs_SHELL) return shape;
  const BRep_Builder builder;
  TopoDS_Shape result = shape.EmptyCopied();
  result.Location({});
  result.Orientation(TopAbs_FORWARD);
  bool changed = false;
  for (TopoDS_Iterator part(shape); part.More(); part.Next()) {
    const TopoDS_Shape now = withShell(part.Value(), shell, other);
    changed = changed || !now.IsSame(part.Value());
    builder.Add(result, now);
  }
  return changed ? result : shape;
}

}  // namespace seamwright::occ
