// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLib.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include <seamwright/core/linear/dense.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/fill/corner_ball.hpp>
#include <seamwright/occ_adapter/fill/corner_bands.hpp>
#include <seamwright/occ_adapter/fill/corner_contact.hpp>
#include <seamwright/occ_adapter/fill/fill_names.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using opencascade::handle;

/// The point in [0, 1] at which f, negative at first, becomes positive; nothing if it does not.
template <class Function>
std::optional<double> crossingOf(const Function& f) {
  // Steps of the search for a change of sign.
  constexpr int steps = 200;
  double low = 0;
  for (int k = 1; k <= steps; ++k) {
    double high = static_cast<double>(k) / steps;
    if (f(high) < 0) {
      low = high;
      continue;
    }
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (f(middle) < 0 ? low : high) = middle;
    }
    return (low + high) / 2;
  }
  return std::nullopt;
}

/// A point of the edge with the tangent there, pointing away from the corner.
struct EdgePlace {
  Vector3d point, tangent;
};

EdgePlace placeAt(const CornerEdge& edge, double setback_mm) {
  const BRepAdaptor_Curve curve(TopoDS::Edge(edge.edge.Oriented(TopAbs_FORWARD)));
  const bool leaves =
      TopExp::LastVertex(TopoDS::Edge(edge.edge.Oriented(TopAbs_FORWARD))).IsSame(edge.far);
  const double sense = leaves ? 1 : -1;
  const double from = leaves ? curve.FirstParameter() : curve.LastParameter();
  const GCPnts_AbscissaPoint place(curve, sense * setback_mm, from);
  gp_Pnt point;
  gp_Vec run;
  curve.D1(place.Parameter(), point, run);
  return {vector(point), sense * vector(run).normalized()};
}

/// Distances from both ends, along the tangents, to the points where the tangents are nearest to
/// each other.
std::array<double, 2> legsOf(const Vector3d& from, const Vector3d& leaving, const Vector3d& to,
                             const Vector3d& arriving) {
  Eigen::MatrixXd tangents(3, 2);
  tangents << leaving, arriving;
  const Eigen::Vector2d legs = linear::PivotedQr(tangents).solve(to - from);
  return {legs(0), legs(1)};
}

/// The new end of a band.
struct Section {
  std::array<double, 2> shares{};  ///< shares along the contact lines before and after the edge
  std::array<TopoDS_Vertex, 2> vertices;
};

class BandTrimmer {
 public:
  BandTrimmer(const Corner& corner, const std::vector<CornerStrip>& strips,
              const RoundedOutside& rounded)
      : corner_(corner), strips_(strips), rounded_(rounded), change_(new BRepTools_ReShape) {
    TopExp::MapShapesAndUniqueAncestors(rounded.solid, TopAbs_EDGE, TopAbs_FACE, around_);
    TopExp::MapShapesAndUniqueAncestors(rounded.solid, TopAbs_VERTEX, TopAbs_EDGE, edges_at_);
  }

  /// The solid with a hole of 2 m sides.
  TopoDS_Shape run() {
    for (std::size_t i = 0; i < corner_.count(); ++i) {
      for (const bool after : {false, true}) contacts_.push_back(contactOf(i, after));
      sections_.push_back(sectionOf(i));
    }
    for (std::size_t i = 0; i < corner_.count(); ++i) {
      for (const std::size_t side : {0, 1}) trim(i, side);
      endBand(i);
      spring(i);
    }
    for (const TopoDS_Face& cap : rounded_.caps) change_->Remove(cap);
    return change_->Apply(rounded_.solid);
  }

  TopoDS_Shape imageOf(const TopoDS_Shape& face) const { return change_->Value(face); }
  /// Straight length of the hole's shortest side.
  double shortestSide_mm() const {
    double shortest = HUGE_VAL;
    for (std::size_t i = 0; i < corner_.count(); ++i)
      shortest = std::min({shortest, (pointAt(i, 1) - pointAt(i, 0)).norm(),
                           (pointAt(corner_.after(i), 0) - pointAt(i, 1)).norm()});
    return shortest;
  }
  /// Distance of the section's ends from the edge, as the mean of both sides.
  double contact_mm(std::size_t i) const {
    const Vector3d foot = placeAt(corner_.edges[i], strips_[i].setback_mm).point;
    return ((pointAt(i, 0) - foot).norm() + (pointAt(i, 1) - foot).norm()) / 2;
  }

 private:
  Vector3d pointAt(std::size_t i, std::size_t side) const {
    return contacts_[2 * i + side].point(sections_[i].shares[side]);
  }

  std::string name(std::size_t i) const {
    return "edge " + std::to_string(corner_.edges[i].number);
  }

  /// The vertex on the ball shared by the band's end and the arc in the face before or after the
  /// edge.
  TopoDS_Vertex nearVertex(std::size_t i, bool after) const {
    TopoDS_Vertex vertex;
    for (const TopoDS_Edge& arc : rounded_.arcs[after ? i : corner_.before(i)])
      for (const TopoDS_Edge& end : rounded_.band_ends[i])
        if (TopExp::CommonVertex(end, arc, vertex)) return vertex;
    throw std::domain_error(name(i) + ": its fillet and the face beside it come to the ball apart");
  }

  Contact contactOf(std::size_t i, bool after) const {
    const TopoDS_Vertex near = nearVertex(i, after);
    for (const TopoDS_Shape& edge : edges_at_.FindFromKey(near)) {
      if (std::ranges::any_of(rounded_.band_ends[i],
                              [&edge](const TopoDS_Edge& end) { return end.IsSame(edge); }))
        continue;
      const TopTools_ListOfShape& faces = around_.FindFromKey(edge);
      if (faces.Extent() != 2) continue;
      const TopoDS_Face &a = TopoDS::Face(faces.First()), &b = TopoDS::Face(faces.Last());
      if (a.IsSame(rounded_.bands[i])) return {TopoDS::Edge(edge), a, b, near};
      if (b.IsSame(rounded_.bands[i])) return {TopoDS::Edge(edge), b, a, near};
    }
    throw std::domain_error(name(i) + ": its fillet has no edge that leaves the ball");
  }

  /// The section at the setback: the points of the contact lines beside it, and the iso-line of the
  /// band between them.
  Section sectionOf(std::size_t i) const {
    const EdgePlace place = placeAt(corner_.edges[i], strips_[i].setback_mm);
    Section section;
    double along = 0;
    for (const std::size_t side : {0, 1}) {
      const Contact& contact = contacts_[2 * i + side];
      const auto beyond = [&](double share) {
        return (contact.point(share) - place.point).dot(place.tangent);
      };
      const std::optional<double> share = beyond(0) < 0 ? crossingOf(beyond) : std::nullopt;
      if (!share)
        throw std::domain_error(name(i) + ": a setback of " + lengthText(strips_[i].setback_mm) +
                                " is not within its fillet, from " +
                                lengthText(strips_[i].setback_mm + beyond(0)) + " to " +
                                lengthText(strips_[i].setback_mm + beyond(1)));
      along += coordinate(contact.onBand(*share), runsInU(i)) / 2;
    }
    for (const std::size_t side : {0, 1}) {
      const Contact& contact = contacts_[2 * i + side];
      const double begin = coordinate(contact.onBand(0), runsInU(i)),
                   end = coordinate(contact.onBand(1), runsInU(i));
      const double sense = end > begin ? 1 : -1;
      const std::optional<double> share = crossingOf(
          [&](double at) { return sense * (coordinate(contact.onBand(at), runsInU(i)) - along); });
      if (!share)
        throw std::domain_error(name(i) + ": no section of its fillet runs from face to face");
      section.shares[side] = *share;
      section.vertices[side] = vertexOn(contact, i, *share);
    }
    return section;
  }

  static double coordinate(const gp_Pnt2d& at, bool u) { return u ? at.X() : at.Y(); }

  /// Whether the band's parameter u runs along the edge.
  bool runsInU(std::size_t i) const {
    const Contact& contact = contacts_[2 * i];
    const gp_Pnt2d begin = contact.onBand(0), end = contact.onBand(1);
    gp_Pnt point;
    gp_Vec u, v;
    BRepAdaptor_Surface(rounded_.bands[i], false).D1(begin.X(), begin.Y(), point, u, v);
    return std::abs(end.X() - begin.X()) * u.Magnitude() >
           std::abs(end.Y() - begin.Y()) * v.Magnitude();
  }

  TopoDS_Vertex vertexOn(const Contact& contact, std::size_t i, double share) const {
    const gp_Pnt2d at = contact.onBand(share), beside = contact.onFace(share);
    const gp_Pnt on_band = BRepAdaptor_Surface(rounded_.bands[i], false).Value(at.X(), at.Y());
    const gp_Pnt on_face = BRepAdaptor_Surface(contact.face(), false).Value(beside.X(), beside.Y());
    const Vector3d point = contact.point(share);
    const gp_Pnt p(point.x(), point.y(), point.z());
    TopoDS_Vertex vertex;
    builder_.MakeVertex(
        vertex, p,
        std::max({Precision::Confusion(), 2 * p.Distance(on_band), 2 * p.Distance(on_face)}));
    return vertex;
  }

  void trim(std::size_t i, std::size_t side) {
    const Contact& contact = contacts_[2 * i + side];
    const TopoDS_Edge& old = contact.edge();
    const TopoDS_Vertex& cut = sections_[i].vertices[side];
    const TopoDS_Vertex far =
        contact.nearFirst() ? TopExp::LastVertex(old) : TopExp::FirstVertex(old);
    TopoDS_Edge made = TopoDS::Edge(old.EmptyCopied());
    builder_.Add(made, (contact.nearFirst() ? cut : far).Oriented(TopAbs_FORWARD));
    builder_.Add(made, (contact.nearFirst() ? far : cut).Oriented(TopAbs_REVERSED));
    const double share = sections_[i].shares[side];
    builder_.Range(made, contact.nearFirst() ? contact.at(share) : contact.at(1),
                   contact.nearFirst() ? contact.at(1) : contact.at(share));
    change_->Replace(old, made);
  }

  /// Replaces a chain of edges on the ball by one edge. \param forward the new edge begins at the
  /// begin of the chain.
  void replace(const std::vector<TopoDS_Edge>& old, const TopoDS_Vertex& begin,
               const TopoDS_Edge& made, bool forward) {
    for (const TopoDS_Edge& edge : old) {
      const bool leaves = TopExp::FirstVertex(edge).IsSame(begin),
                 arrives = TopExp::LastVertex(edge).IsSame(begin);
      if (leaves || arrives)
        change_->Replace(edge, leaves == forward ? made : TopoDS::Edge(made.Reversed()));
      else
        change_->Remove(edge);
    }
  }

  void endBand(std::size_t i) {
    const TopoDS_Face& band = rounded_.bands[i];
    const bool u = runsInU(i);
    std::array<gp_Pnt2d, 2> at;
    for (const std::size_t side : {0, 1})
      at[side] = contacts_[2 * i + side].onBand(sections_[i].shares[side]);
    const double along = (coordinate(at[0], u) + coordinate(at[1], u)) / 2;
    const std::array<double, 2> across = {coordinate(at[0], !u), coordinate(at[1], !u)};
    const std::size_t first = across[0] < across[1] ? 0 : 1;
    const handle<Geom_Surface> surface = BRep_Tool::Surface(band);
    TopoDS_Edge made;
    builder_.MakeEdge(made, u ? surface->UIso(along) : surface->VIso(along),
                      Precision::Confusion());
    builder_.UpdateEdge(made,
                        u ? new Geom2d_Line(gp_Pnt2d(along, 0), gp::DY2d())
                          : new Geom2d_Line(gp_Pnt2d(0, along), gp::DX2d()),
                        band, Precision::Confusion());
    builder_.Add(made, sections_[i].vertices[first].Oriented(TopAbs_FORWARD));
    builder_.Add(made, sections_[i].vertices[1 - first].Oriented(TopAbs_REVERSED));
    builder_.Range(made, across[first], across[1 - first]);
    replace(rounded_.band_ends[i], nearVertex(i, false), made, first == 0);
  }

  void spring(std::size_t i) {
    const std::size_t next = corner_.after(i);
    const Contact &from = contacts_[2 * i + 1], &to = contacts_[2 * next];
    const double leave = sections_[i].shares[1], arrive = sections_[next].shares[0];
    const Vector3d a = from.point(leave), b = to.point(arrive);
    const Vector3d leaving = from.inward(leave), arriving = -to.inward(arrive);
    const std::array<double, 2> legs = legsOf(a, leaving, b, arriving);
    if (!(legs[0] > 0 && legs[1] > 0))
      throw std::domain_error(name(i) + " and " + name(next) +
                              ": their fillets cross before their sections, set back by " +
                              lengthText(strips_[i].setback_mm) + " and " +
                              lengthText(strips_[next].setback_mm));
    const BezierCurve curve(springCurve(a, leaving, b, arriving, legs));
    TopoDS_Edge made;
    builder_.MakeEdge(made);
    builder_.UpdateEdge(made, laidOn(from.face(), curve, from.onFace(leave), to.onFace(arrive)),
                        from.face(), Precision::Confusion());
    builder_.Add(made, sections_[i].vertices[1].Oriented(TopAbs_FORWARD));
    builder_.Add(made, sections_[next].vertices[0].Oriented(TopAbs_REVERSED));
    builder_.Range(made, 0, 1);
    if (!BRepLib::BuildCurve3d(made, Precision::Confusion()))
      throw std::domain_error(name(i) + ": OpenCASCADE makes no curve on the face after it");
    replace(rounded_.arcs[i], nearVertex(i, true), made, true);
  }

  /// The pcurve of the curve projected onto the face.
  static handle<Geom2d_Curve> laidOn(const TopoDS_Face& face, const BezierCurve& curve,
                                     const gp_Pnt2d& from, const gp_Pnt2d& to) {
    constexpr int count = 33;
    const BRepAdaptor_Surface surface(face, false);
    ShapeAnalysis_Surface nearest(BRep_Tool::Surface(face));
    const handle<TColgp_HArray1OfPnt2d> path = new TColgp_HArray1OfPnt2d(1, count);
    const handle<TColStd_HArray1OfReal> places = new TColStd_HArray1OfReal(1, count);
    path->SetValue(1, from);
    for (int k = 0; k < count; ++k) places->SetValue(k + 1, static_cast<double>(k) / (count - 1));
    for (int k = 1; k + 1 < count; ++k) {
      const Vector3d p = curve.point(places->Value(k + 1));
      const gp_Pnt2d before = path->Value(k);
      const gp_Pnt2d at = nearest.NextValueOfUV(before, gp_Pnt(p.x(), p.y(), p.z()), 1e-9);
      path->SetValue(k + 1,
                     {beside(at.X(), before.X(), surface.IsUPeriodic() ? surface.UPeriod() : 0),
                      beside(at.Y(), before.Y(), surface.IsVPeriodic() ? surface.VPeriod() : 0)});
    }
    path->SetValue(count, to);
    Geom2dAPI_Interpolate fit(path, places, false, Precision::PConfusion());
    fit.Load(tangentIn(surface, from, curve.jet(0).d1), tangentIn(surface, to, curve.jet(1).d1),
             false);
    fit.Perform();
    if (!fit.IsDone())
      throw std::domain_error("OpenCASCADE finds no path on a face between two fillets");
    return handle<Geom2d_Curve>(fit.Curve());
  }

  /// The parameter, moved by whole periods to be nearest to another. \param period 0: not periodic.
  static double beside(double parameter, double other, double period) {
    return period > 0 ? parameter + period * std::round((other - parameter) / period) : parameter;
  }

  /// The direction in the parameter plane that belongs to a tangent vector.
  static gp_Vec2d tangentIn(const BRepAdaptor_Surface& surface, const gp_Pnt2d& at,
                            const Vector3d& run) {
    gp_Pnt point;
    gp_Vec u, v;
    surface.D1(at.X(), at.Y(), point, u, v);
    Eigen::MatrixXd partials(3, 2);
    partials << vector(u), vector(v);
    const Eigen::Vector2d direction = linear::PivotedQr(partials).solve(run);
    return {direction(0), direction(1)};
  }

  const Corner& corner_;
  const std::vector<CornerStrip>& strips_;
  const RoundedOutside& rounded_;
  const handle<BRepTools_ReShape> change_;
  BRep_Builder builder_;
  TopTools_IndexedDataMapOfShapeListOfShape around_, edges_at_;
  std::vector<Contact> contacts_;  ///< 2 i: before edge i, 2 i + 1: after it
  std::vector<Section> sections_;
};

/// The radius of the ball beyond which fillets between planes do not obstruct each other.
double leastBall_mm(const Corner& corner, const std::vector<CornerStrip>& strips) {
  double ball_mm = 0;
  for (std::size_t i = 0; i < corner.count(); ++i)
    ball_mm = std::max(ball_mm, std::hypot(crossingIn(corner, strips, i)[0], strips[i].contact_mm));
  return ball_mm;
}

constexpr const char* band_name = "band";

/// The holed solid as a model; names of its faces are their numbers in the given solid.
Model holedModel(const RoundedOutside& rounded, const BandTrimmer& trimmer,
                 const TopoDS_Shape& holed) {
  Model model = modelFromShape(holed);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(holed, TopAbs_FACE, faces);
  const auto call = [&](const TopoDS_Face& face, const std::string& name) {
    if (const int index = faces.FindIndex(trimmer.imageOf(face)); index > 0)
      model.attributes.push_back({TopAbs_FACE, index, name, {}, {}});
  };
  for (const auto& [number, face] : rounded.became) call(face, std::to_string(number));
  for (const TopoDS_Face& band : rounded.bands) call(band, band_name);
  return model;
}

/// The hole that adjoins all bands, with the section of the first band as its first side.
Hole holeBesideBands(const Model& holed, std::size_t edges, const TopoDS_Face& first_band,
                     const FillHoleOptions& options) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(holed.shape, TopAbs_FACE, faces);
  const int first = faces.FindIndex(first_band);
  for (Hole hole : findHoles(holed.shape, {options.corner_rad, options.tolerance.gap_mm}).holes) {
    const auto begin = std::ranges::find_if(
        hole.sides, [first](const HoleSide& side) { return side.edges.front().use.face == first; });
    if (begin == hole.sides.end()) continue;
    if (hole.sides.size() != 2 * edges)
      throw std::domain_error("the hole between the fillets has " +
                              std::to_string(hole.sides.size()) +
                              " sides: " + std::to_string(2 * edges) + " are needed");
    std::rotate(hole.sides.begin(), begin, hole.sides.end());
    return hole;
  }
  throw std::domain_error("no hole is left between the fillets");
}

/// The fill, with patches if no spline was needed.
NSidedFill fillOf(const FillHoleReport& report) {
  NSidedFill fill;
  fill.regular = report.regular;
  fill.corners = report.corners;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(report.model.shape, TopAbs_FACE, faces);
  for (const int face : report.faces) {
    const handle<Geom_Surface> surface = BRep_Tool::Surface(TopoDS::Face(faces(face)));
    if (!surface->IsKind(STANDARD_TYPE(Geom_BezierSurface))) continue;
    fill.patches.push_back(bezierPatch(*surface));
  }
  if (fill.patches.size() != report.faces.size()) fill.patches.clear();
  return fill;
}

/// The shell of the filled solid, with its new seams and the new faces by the given ones.
CornerShell shellOf(const FillHoleReport& report, const Corner& corner) {
  CornerShell shell;
  shell.shell = TopoDS::Shell(TopExp_Explorer(report.model.shape, TopAbs_SHELL).Current());
  TopTools_IndexedMapOfShape given, faces, edges;
  TopExp::MapShapes(corner.solid, TopAbs_FACE, given);
  TopExp::MapShapes(report.model.shape, TopAbs_FACE, faces);
  TopExp::MapShapes(report.model.shape, TopAbs_EDGE, edges);
  std::set<int> bands, beside;
  for (const ShapeAttribute& face : report.model.attributes) {
    if (face.kind != TopAbs_FACE) continue;
    if (face.name == band_name) {
      bands.insert(face.index);
      continue;
    }
    const TopoDS_Shape& old = given(std::stoi(face.name));
    shell.became.Bind(old, faces(face.index));
    if (std::ranges::any_of(corner.faces,
                            [&old](const CornerFace& of) { return of.face.IsSame(old); }))
      beside.insert(face.index);
  }
  const std::set<int> patches(report.faces.begin(), report.faces.end());
  for (const Seam& seam : findSeams(report.model.shape).seams) {
    const auto count = [&seam](const std::set<int>& kind) {
      return kind.count(seam.sides[0].face) + kind.count(seam.sides[1].face);
    };
    const TopoDS_Edge edge = TopoDS::Edge(edges(seam.edges.front()));
    if (count(patches) == 2)
      shell.seams.emplace_back(edge, CornerSeamKind::Spoke);
    else if (count(patches) == 1)
      shell.seams.emplace_back(
          edge, count(bands) == 1 ? CornerSeamKind::Section : CornerSeamKind::Spring);
    else if (count(bands) == 1 && count(beside) == 1)
      shell.seams.emplace_back(edge, CornerSeamKind::Contact);
  }
  return shell;
}

/// Requires that each setback is less than the length of its edge.
void requireRoom(const Corner& corner, const std::vector<CornerStrip>& strips,
                 const CornerFilletOptions& options) {
  for (std::size_t i = 0; i < corner.count(); ++i)
    if (const double length_mm =
            GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(corner.edges[i].edge));
        !(strips[i].setback_mm < length_mm))
      throw std::domain_error(setBackText(corner, strips, options, i, length_mm) +
                              " would begin beyond its end");
}

/// Names of the faces of the holed model in reasons.
FaceNames namesOf(const Corner& corner, const RoundedOutside& rounded, const BandTrimmer& trimmer,
                  const Model& holed) {
  const TopTools_IndexedMapOfShape faces = partsOf(holed.shape, TopAbs_FACE),
                                   given = partsOf(corner.solid, TopAbs_FACE);
  std::vector<std::string> names(static_cast<std::size_t>(faces.Extent()) + 1, "a fillet");
  const auto call = [&](const TopoDS_Face& face, const std::string& name) {
    names[static_cast<std::size_t>(faces.FindIndex(trimmer.imageOf(face)))] = name;
  };
  for (const auto& [number, face] : rounded.became)
    call(face, numberedFace(corner.given_faces.FindIndex(given(number))));
  for (std::size_t i = 0; i < corner.count(); ++i)
    call(rounded.bands[i], "the fillet of edge " + std::to_string(corner.edges[i].number));
  return [names](int face) { return names[static_cast<std::size_t>(face)]; };
}

/// Returns a corner that was made with inside and outside exchanged to the order and orientation of
/// its solid.
BandedCorner turnedBack(BandedCorner made) {
  made.shell.shell.Reverse();
  std::ranges::reverse(made.edges);
  for (CornerFilletEdge& edge : made.edges) edge.convex = !edge.convex;
  std::ranges::reverse(made.fill.patches);
  for (BezierPatch& patch : made.fill.patches) patch = patch.transposed();
  std::ranges::reverse(made.fill.corners);
  return made;
}

/// Parameters of an attempt.
struct Attempt {
  double margin = 1;    ///< radius of the ball over that needed for planes
  int most_degree = 9;  ///< largest degree of the polynomials fitted to the sides of the hole
};

/// A finished corner, and whether it reaches the target.
struct Made {
  BandedCorner corner;
  bool reached = false;

  /// Rank of the corner: the better of two has the larger rank.
  int rank() const { return (corner.fill.regular ? 2 : 0) + (reached ? 1 : 0); }
};

/// Moves sections without a given setback well outside the ball.
void setBackFromBall(const Corner& corner, const CornerFilletOptions& options, double least_mm,
                     std::vector<CornerStrip>& strips) {
  for (std::size_t i = 0; i < corner.count(); ++i) {
    if (options.setback_mm(corner.edges[i].number)) continue;
    const double contact_mm = strips[i].contact_mm;
    const double along_mm = std::sqrt(std::max(0.0, least_mm * least_mm - contact_mm * contact_mm));
    strips[i].setback_mm = std::max(strips[i].setback_mm, along_mm);
  }
}

Made tried(const Corner& corner, std::vector<CornerStrip> strips,
           const CornerFilletOptions& options, const Attempt& attempt, const Progress& progress) {
  const double ball_mm = attempt.margin * leastBall_mm(corner, strips);
  setBackFromBall(corner, options, attempt.margin * ball_mm, strips);
  requireRoom(corner, strips, options);
  const RoundedOutside rounded = roundedOutside(corner, strips, ball_mm);
  BandTrimmer trimmer(corner, strips, rounded);
  const Model holed = holedModel(rounded, trimmer, trimmer.run());

  FillHoleOptions how;
  how.tolerance = options.tolerance;
  how.tolerance.gap_mm = std::min(how.tolerance.gap_mm, trimmer.shortestSide_mm() / 10);
  how.keep_anyway = true;
  how.most_degree = attempt.most_degree;
  how.jobs = options.jobs;
  const TopoDS_Face first_band = TopoDS::Face(trimmer.imageOf(rounded.bands.front()));
  const FillHoleReport report =
      fillHole(holed, holeBesideBands(holed, corner.count(), first_band, how), how,
               namesOf(corner, rounded, trimmer, holed), progress);
  if (!report.filled) throw std::domain_error("the corner between the fillets: " + report.reason);

  Made made{{shellOf(report, corner), {}, fillOf(report), 0}, report.reached};
  for (const FilledSide& side : report.sides)
    made.corner.section_error_mm = std::max(made.corner.section_error_mm, side.gap_mm);
  for (std::size_t i = 0; i < corner.count(); ++i)
    made.corner.edges.push_back({corner.edges[i].number, corner.edges[i].convex,
                                 corner.edges[i].opening_rad, strips[i].radius_mm,
                                 trimmer.contact_mm(i), strips[i].setback_mm});
  return made;
}

}  // namespace

BandedCorner bandedCorner(const Corner& given, const CornerFilletOptions& options,
                          const Progress& progress) {
  const std::pair<Corner, bool> alone = ofShellAlone(given);
  const Corner& corner = alone.first;
  const std::vector<CornerStrip> strips = cornerStrips(corner, options);
  // Attempts in their order, as margin and degree. Lower degrees fit the sides less closely and
  // make fairer patches. Between curved faces, fillets may need a larger ball before they do not
  // obstruct each other.
  constexpr std::array<Attempt, 5> attempts = {{{1.1, 9}, {1.1, 5}, {1.3, 9}, {1.3, 5}, {1.6, 5}}};
  std::optional<Made> best;
  std::string reason;
  for (std::size_t k = 0; k < attempts.size(); ++k) {
    const double share = 1.0 / static_cast<double>(attempts.size());
    const Progress part =
        partOf(progress, static_cast<double>(k) * share, static_cast<double>(k + 1) * share);
    try {
      Made made = tried(corner, strips, options, attempts[k], part);
      if (!best || made.rank() > best->rank()) best = std::move(made);
      if (best->corner.fill.regular && best->reached) break;
    } catch (const std::domain_error& error) {
      if (reason.empty()) reason = error.what();
    }
  }
  if (!best) throw std::domain_error(reason);
  return alone.second ? turnedBack(std::move(best->corner)) : std::move(best->corner);
}

}  // namespace seamwright::occ
