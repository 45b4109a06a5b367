// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax3.hxx>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/corner_solid.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using opencascade::handle;
using std::numbers::pi;

constexpr int most_wave_degree = 16;

Vector3d placeOf(const TopoDS_Vertex& vertex) {
  return vector(BRep_Tool::Pnt(vertex));
}

handle<Geom2d_Curve> straight(const gp_Pnt2d& from, const gp_Pnt2d& to) {
  TColgp_Array1OfPnt2d poles(1, 2);
  poles(1) = from;
  poles(2) = to;
  return new Geom2d_BezierCurve(poles);
}

/// A cylinder of the corner. In its parameters the section is v = 0, with its middle at u = pi.
struct Tube {
  handle<Geom_CylindricalSurface> surface;
  TopoDS_Face face;
  std::array<double, 2> u{};  ///< u of both contact lines
};

/// The section of a cylinder by the plane at the far end: a circle or an ellipse, with the
/// parameter u - highest_u.
struct FarCut {
  gp_Ax2 axes;
  bool upright = true;
  double cosine = 1;     ///< cosine of the angle between the axis and the plane's normal
  double height = 0;     ///< v of the plane on the axis
  double swing = 0;      ///< the section has v = height + swing cos(u - highest_u)
  double highest_u = 0;  ///< in (-pi, pi]
};

/// New vertices and edges at one edge of the corner. Contact lines run away from the section.
/// Sections and far ends run from the face before the edge to the face after it.
struct TubeEdges {
  std::array<TopoDS_Vertex, 2> near, far;
  std::array<TopoDS_Edge, 2> contacts;
  TopoDS_Edge end;
};

class ShellBuilder {
 public:
  ShellBuilder(const Corner& corner, const CornerHole& hole, const NSidedFill& fill)
      : corner_(corner),
        hole_(hole),
        fill_(fill),
        tolerance_(std::max(Precision::Confusion(), 2 * hole.section_error_mm)),
        count_(corner.count()) {}

  CornerShell build() {
    for (std::size_t i = 0; i < count_; ++i) makeTube(i);
    for (std::size_t i = 0; i < count_; ++i) trimEnd(i);
    for (const BezierPatch& patch : fill_.patches) {
      patches_.emplace_back();
      builder_.MakeFace(patches_.back(), toBezierSurface(patch), tolerance_);
    }
    centre_ = vertex(fill_.patches.front().pole(0, 0));
    for (std::size_t side = 0; side < 2 * count_; ++side) makeSide(side);
    builder_.MakeShell(result_.shell);
    for (TopoDS_Iterator face(corner_.shell); face.More(); face.Next())
      builder_.Add(result_.shell, renewed(TopoDS::Face(face.Value())));
    for (std::size_t i = 0; i < count_; ++i) addTube(i);
    for (std::size_t k = 0; k < 2 * count_; ++k) addPatch(k);
    result_.shell.Closed(true);
    return std::move(result_);
  }

 private:
  TopoDS_Vertex vertex(const Vector3d& p) const {
    TopoDS_Vertex made;
    builder_.MakeVertex(made, pointOf(p), tolerance_);
    return made;
  }

  TopoDS_Edge edge(const handle<Geom_Curve>& curve, double first, double last,
                   const TopoDS_Vertex& from, const TopoDS_Vertex& to) const {
    TopoDS_Edge made;
    builder_.MakeEdge(made, curve, tolerance_);
    builder_.Add(made, from.Oriented(TopAbs_FORWARD));
    builder_.Add(made, to.Oriented(TopAbs_REVERSED));
    builder_.Range(made, first, last);
    return made;
  }

  TopoDS_Edge line(const TopoDS_Vertex& from, const TopoDS_Vertex& to) const {
    const Vector3d run = placeOf(to) - placeOf(from);
    return edge(new Geom_Line(pointOf(placeOf(from)), directionOf(run)), 0, run.norm(), from, to);
  }

  void lay(const TopoDS_Edge& edge, const handle<Geom2d_Curve>& path,
           const TopoDS_Face& face) const {
    builder_.UpdateEdge(edge, path, face, tolerance_);
  }

  void makeTube(std::size_t i) {
    const CornerStrip& strip = hole_.strips[i];
    const CornerEdge& corner_edge = corner_.edges[i];
    Tube tube;
    const gp_Ax3 axes(pointOf(strip.centre), directionOf(corner_edge.axis),
                      directionOf(-strip.to_edge));
    tube.surface = new Geom_CylindricalSurface(axes, strip.radius_mm);
    const bool rising =
        corner_edge.axis.cross(strip.to_edge).dot(strip.contacts[1] - strip.contacts[0]) > 0;
    const double half = (rising ? 0.5 : -0.5) * strip.sweep_rad;
    tube.u = {pi - half, pi + half};
    builder_.MakeFace(tube.face, tube.surface, tolerance_);

    TubeEdges edges;
    for (std::size_t side = 0; side < 2; ++side) {
      edges.near[side] = vertex(strip.contacts[side]);
      edges.far[side] = vertex(strip.far_contacts[side]);
      edges.contacts[side] = line(edges.near[side], edges.far[side]);
      lay(edges.contacts[side], new Geom2d_Line(gp_Pnt2d(tube.u[side], 0), gp::DY2d()), tube.face);
      result_.seams.emplace_back(edges.contacts[side], CornerSeamKind::Contact);
    }
    edges.end = endOf(i, tube, edges);
    tubes_.push_back(tube);
    edges_.push_back(edges);
  }

  FarCut farCut(std::size_t i) const {
    const CornerEdge& corner_edge = corner_.edges[i];
    const CornerStrip& strip = hole_.strips[i];
    const Vector3d& axis = corner_edge.axis;
    const bool along = corner_edge.end_normal.dot(axis) > 0;
    const Vector3d normal = along ? corner_edge.end_normal : Vector3d(-corner_edge.end_normal);
    FarCut cut;
    cut.cosine = normal.dot(axis);
    cut.height = normal.dot(strip.far_contacts[0] - strip.centre) / cut.cosine;
    const Vector3d lean = normal - cut.cosine * axis;
    const Vector3d x = -strip.to_edge, y = axis.cross(x);
    cut.upright = lean.norm() < 1e-12;
    if (!cut.upright) cut.highest_u = std::atan2(-lean.dot(y), -lean.dot(x));
    cut.swing = strip.radius_mm * lean.norm() / cut.cosine;
    const Vector3d across = std::cos(cut.highest_u) * x + std::sin(cut.highest_u) * y;
    const Vector3d major = across - normal.dot(across) / cut.cosine * axis;
    cut.axes =
        gp_Ax2(pointOf(strip.centre + cut.height * axis), directionOf(normal), directionOf(major));
    return cut;
  }

  /// Requires that the far cut is beyond the section. Its ends are, as ends of the contact lines,
  /// so only its lowest point needs a test.
  void requireBeyondSection(std::size_t i, const FarCut& cut, double first, double last) const {
    const double lowest_u = cut.highest_u + pi;  // in [0, 2 pi], like the arc
    const double lowest = cut.height - cut.swing;
    if (lowest_u > first && lowest_u < last && !(lowest > 0))
      throw std::domain_error("edge " + std::to_string(corner_.edges[i].number) +
                              ": the plane at its far end cuts the cylinder of radius " +
                              lengthText(hole_.strips[i].radius_mm) + " from " +
                              lengthText(lowest) + " beyond the section on: more than 0 is needed");
  }

  /// The polynomial pcurve of v = height + swing cos(t) over u = t + highest_u, with an error of at
  /// most half the tolerance.
  handle<Geom2d_Curve> waveOf(const FarCut& cut, double sweep_rad, double first,
                              double last) const {
    int degree = 4;
    UnitArc arc = unitArc(sweep_rad, degree);
    while (arc.error * cut.swing > tolerance_ / 2 && degree < most_wave_degree)
      arc = unitArc(sweep_rad, ++degree);
    const double middle = (first + last) / 2;
    const int count = static_cast<int>(arc.poles.rows());
    TColgp_Array1OfPnt2d poles(1, count);
    for (int k = 0; k < count; ++k) {
      const double t = first + (last - first) * k / (count - 1);
      const double cosine = std::cos(middle) * arc.poles(k, 0) - std::sin(middle) * arc.poles(k, 1);
      poles(k + 1) = gp_Pnt2d(t + cut.highest_u, cut.height + cut.swing * cosine);
    }
    TColStd_Array1OfReal knots(1, 2);
    knots(1) = first;
    knots(2) = last;
    TColStd_Array1OfInteger multiplicities(1, 2);
    multiplicities.Init(count);
    return new Geom2d_BSplineCurve(poles, knots, multiplicities, count - 1);
  }

  TopoDS_Edge endOf(std::size_t i, const Tube& tube, const TubeEdges& edges) const {
    const FarCut cut = farCut(i);
    const double radius = hole_.strips[i].radius_mm;
    const std::size_t from = tube.u[1] > tube.u[0] ? 0 : 1;
    const double first = tube.u[from] - cut.highest_u, last = tube.u[1 - from] - cut.highest_u;
    requireBeyondSection(i, cut, tube.u[from], tube.u[1 - from]);
    handle<Geom_Curve> curve;
    handle<Geom2d_Curve> path;
    if (cut.upright) {
      curve = new Geom_Circle(cut.axes, radius);
      path = new Geom2d_Line(gp_Pnt2d(0, cut.height), gp::DX2d());
    } else {
      curve = new Geom_Ellipse(cut.axes, radius / cut.cosine, radius);
      path = waveOf(cut, hole_.strips[i].sweep_rad, first, last);
    }
    const TopoDS_Edge made = edge(curve, first, last, edges.far[from], edges.far[1 - from]);
    lay(made, path, tube.face);
    builder_.Range(made, first, last);
    return from == 0 ? made : TopoDS::Edge(made.Reversed());
  }

  /// Trims the edges of the far face at the contact lines.
  void trimEnd(std::size_t i) {
    const CornerEdge& corner_edge = corner_.edges[i];
    for (std::size_t side = 0; side < 2; ++side) {
      const TopoDS_Edge& old = corner_edge.end_edges[side];
      auto& ends = trims_[old_.Add(old.Oriented(TopAbs_FORWARD))];
      const bool at_first =
          TopExp::FirstVertex(TopoDS::Edge(old.Oriented(TopAbs_FORWARD))).IsSame(corner_edge.far);
      ends[at_first ? 0 : 1] = edges_[i].far[side];
    }
  }

  /// The given edge, trimmed if necessary, with its own orientation.
  TopoDS_Edge trimmed(const TopoDS_Edge& old) {
    const int number = old_.FindIndex(old);
    if (number == 0) return old;
    auto made = trimmed_.find(number);
    if (made == trimmed_.end()) {
      const TopoDS_Edge whole = TopoDS::Edge(old_(number));
      const std::array<TopoDS_Vertex, 2> ends = {TopExp::FirstVertex(whole),
                                                 TopExp::LastVertex(whole)};
      const auto& cut = trims_[number];
      const TopoDS_Vertex from = cut[0].IsNull() ? ends[0] : cut[0],
                          to = cut[1].IsNull() ? ends[1] : cut[1];
      const Vector3d run = placeOf(ends[1]) - placeOf(ends[0]);
      const double left = run.normalized().dot(placeOf(to) - placeOf(from));
      const double spare = run.normalized().dot(placeOf(from) - placeOf(ends[0]));
      if (!(left > 1e-3 * run.norm()) || spare < -tolerance_ ||
          spare + left > run.norm() + tolerance_)
        throw std::domain_error(
            "edge " + std::to_string(corner_.given_edges.FindIndex(old)) + ", " +
            lengthText(run.norm()) + " long, at a far end would be cut from " + lengthText(spare) +
            " to " + lengthText(spare + left) + " by the fillets: smaller radii may help");
      made = trimmed_.emplace(number, line(from, to)).first;
    }
    return TopoDS::Edge(made->second.Oriented(old.Orientation()));
  }

  /// Makes the two halves of a side and the spoke to its middle.
  void makeSide(std::size_t side) {
    const std::size_t i = side / 2;
    const bool section = side % 2 == 0;
    const TopoDS_Vertex from = section ? edges_[i].near[0] : edges_[i].near[1];
    const TopoDS_Vertex to = section ? edges_[i].near[1] : edges_[corner_.after(i)].near[0];
    const auto halves = hole_.sides[side].edge.split(0.5);
    const TopoDS_Vertex middle = vertex(halves.first.point(1));
    const std::size_t next = (side + 1) % (2 * count_);
    std::array<TopoDS_Edge, 2> parts = {edge(toBezierCurve(halves.first), 0, 1, from, middle),
                                        edge(toBezierCurve(halves.second), 0, 1, middle, to)};
    lay(parts[0], new Geom2d_Line(gp_Pnt2d(1, 1), -gp::DX2d()), patches_[side]);
    lay(parts[1], new Geom2d_Line(gp_Pnt2d(1, 0), gp::DY2d()), patches_[next]);
    if (section) {
      const Tube& tube = tubes_[i];
      lay(parts[0], straight({tube.u[0], 0}, {pi, 0}), tube.face);
      lay(parts[1], straight({pi, 0}, {tube.u[1], 0}), tube.face);
    }
    const TopoDS_Edge spoke =
        edge(toBezierCurve(fill_.patches[side].isoCurveU(0)), 0, 1, centre_, middle);
    lay(spoke, new Geom2d_Line(gp::Origin2d(), gp::DY2d()), patches_[side]);
    lay(spoke, new Geom2d_Line(gp::Origin2d(), gp::DX2d()), patches_[next]);
    for (const TopoDS_Edge& part : parts) {
      builder_.Range(part, 0, 1);
      result_.seams.emplace_back(part, section ? CornerSeamKind::Section : CornerSeamKind::Spring);
    }
    builder_.Range(spoke, 0, 1);
    result_.seams.emplace_back(spoke, CornerSeamKind::Spoke);
    halves_.push_back(parts);
    spokes_.push_back(spoke);
  }

  void addTube(std::size_t i) {
    const TubeEdges& edges = edges_[i];
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    builder_.Add(wire, halves_[2 * i][1].Reversed());
    builder_.Add(wire, halves_[2 * i][0].Reversed());
    builder_.Add(wire, edges.contacts[0]);
    builder_.Add(wire, edges.end);
    builder_.Add(wire, edges.contacts[1].Reversed());
    wire.Closed(true);
    const TopAbs_Orientation sense = corner_.edges[i].convex ? TopAbs_FORWARD : TopAbs_REVERSED;
    builder_.Add(tubes_[i].face, wire.Oriented(sense));
    builder_.Add(result_.shell, tubes_[i].face.Oriented(sense));
  }

  void addPatch(std::size_t k) {
    const std::size_t previous = (k + 2 * count_ - 1) % (2 * count_);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    builder_.Add(wire, spokes_[previous]);
    builder_.Add(wire, halves_[previous][1]);
    builder_.Add(wire, halves_[k][0]);
    builder_.Add(wire, spokes_[k].Reversed());
    wire.Closed(true);
    builder_.Add(patches_[k], wire);
    builder_.Add(result_.shell, patches_[k]);
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
    result_.became.Bind(old, face.Oriented(old.Orientation()));
    return TopoDS::Face(face.Oriented(old.Orientation()));
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
    for (std::size_t i = 0; i < count_; ++i) {
      if (!old.IsSame(corner_.edges[i].edge)) continue;
      const bool after = face.IsSame(corner_.faces[i].face);
      const TopoDS_Edge& contact = edges_[i].contacts[after ? 1 : 0];
      if (!last.IsSame(corner_.vertex)) return {contact};
      const TopoDS_Edge arriving = TopoDS::Edge(contact.Reversed());
      const auto& spring = halves_[2 * (after ? i : corner_.before(i)) + 1];
      if (after) return {arriving, spring[0], spring[1]};
      return {arriving, TopoDS::Edge(spring[1].Reversed()), TopoDS::Edge(spring[0].Reversed())};
    }
    std::vector<TopoDS_Edge> parts = {trimmed(old)};
    for (std::size_t i = 0; i < count_; ++i)
      if (last.IsSame(corner_.edges[i].far) && face.IsSame(corner_.edges[i].end)) {
        const bool before = old.IsSame(corner_.edges[i].end_edges[0]);
        parts.push_back(before ? edges_[i].end : TopoDS::Edge(edges_[i].end.Reversed()));
      }
    return parts;
  }

  const Corner& corner_;
  const CornerHole& hole_;
  const NSidedFill& fill_;
  const double tolerance_;
  const std::size_t count_;
  BRep_Builder builder_;
  CornerShell result_;
  std::vector<Tube> tubes_;
  std::vector<TubeEdges> edges_;
  std::vector<TopoDS_Face> patches_;
  /// Halves of the sides, in the direction of the sides.
  std::vector<std::array<TopoDS_Edge, 2>> halves_;
  std::vector<TopoDS_Edge> spokes_;  ///< from the centre
  TopoDS_Vertex centre_;
  TopTools_IndexedMapOfShape old_;  ///< edges at far ends
  /// New ends of these edges; null where an end stays.
  std::map<int, std::array<TopoDS_Vertex, 2>> trims_;
  std::map<int, TopoDS_Edge> trimmed_;
};

}  // namespace

CornerShell cornerShell(const Corner& corner, const CornerHole& hole, const NSidedFill& fill) {
  return ShellBuilder(corner, hole, fill).build();
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
