// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepLib.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <seamwright/core/linear/dense.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/fill/band_sections.hpp>
#include <seamwright/occ_adapter/fill/corner_ball.hpp>
#include <seamwright/occ_adapter/fill/corner_bands.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/fill/fill_names.hpp>
#include <seamwright/occ_adapter/fill/path_on_face.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using opencascade::handle;

/// Distances from both ends, along the tangents, to the points where the tangents are nearest to
/// each other.
std::array<double, 2> legsOf(const Vector3d& from, const Vector3d& leaving, const Vector3d& to,
                             const Vector3d& arriving) {
  Eigen::MatrixXd tangents(3, 2);
  tangents << leaving, arriving;
  const Eigen::Vector2d legs = linear::PivotedQr(tangents).solve(to - from);
  return {legs(0), legs(1)};
}

/// Cuts the bands back to their sections, and the faces between them along curves that continue the
/// contact lines.
class BandTrimmer {
 public:
  BandTrimmer(const Corner& corner, const std::vector<CornerStrip>& strips,
              const RoundedOutside& rounded, const BandSections& sections)
      : corner_(corner),
        strips_(strips),
        rounded_(rounded),
        sections_(sections),
        change_(new BRepTools_ReShape) {}

  /// The solid with a hole of 2 m sides.
  TopoDS_Shape run() {
    for (std::size_t i = 0; i < corner_.count(); ++i) {
      for (const std::size_t side : {0, 1}) trim(i, side);
      endBand(i);
      spring(i);
    }
    for (const TopoDS_Face& cap : rounded_.caps) change_->Remove(cap);
    return change_->Apply(rounded_.solid);
  }

  TopoDS_Shape imageOf(const TopoDS_Shape& face) const { return change_->Value(face); }

 private:
  void trim(std::size_t i, std::size_t side) {
    const Contact& contact = sections_.contact(i, side);
    const TopoDS_Edge& old = contact.edge();
    const TopoDS_Vertex& cut = sections_.section(i).vertices[side];
    const TopoDS_Vertex far =
        contact.nearFirst() ? TopExp::LastVertex(old) : TopExp::FirstVertex(old);
    TopoDS_Edge made = TopoDS::Edge(old.EmptyCopied());
    builder_.Add(made, (contact.nearFirst() ? cut : far).Oriented(TopAbs_FORWARD));
    builder_.Add(made, (contact.nearFirst() ? far : cut).Oriented(TopAbs_REVERSED));
    const double share = sections_.section(i).shares[side];
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
    const bool u = sections_.runsInU(i);
    std::array<gp_Pnt2d, 2> at;
    for (const std::size_t side : {0, 1})
      at[side] = sections_.contact(i, side).onBand(sections_.section(i).shares[side]);
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
    builder_.Add(made, sections_.section(i).vertices[first].Oriented(TopAbs_FORWARD));
    builder_.Add(made, sections_.section(i).vertices[1 - first].Oriented(TopAbs_REVERSED));
    builder_.Range(made, across[first], across[1 - first]);
    replace(rounded_.band_ends[i], sections_.nearVertex(i, false), made, first == 0);
  }

  void spring(std::size_t i) {
    const std::size_t next = corner_.after(i);
    const Contact &from = sections_.contact(i, 1), &to = sections_.contact(next, 0);
    const double leave = sections_.section(i).shares[1], arrive = sections_.section(next).shares[0];
    const Vector3d a = from.point(leave), b = to.point(arrive);
    const Vector3d leaving = from.inward(leave), arriving = -to.inward(arrive);
    const std::array<double, 2> legs = legsOf(a, leaving, b, arriving);
    if (!(legs[0] > 0 && legs[1] > 0))
      throw CornerRefused(
          corner_why::filletsCross({sections_.number(i), sections_.number(next)},
                                   {strips_[i].setback_mm, strips_[next].setback_mm}));
    const BezierCurve curve(springCurve(a, leaving, b, arriving, legs));
    TopoDS_Edge made;
    builder_.MakeEdge(made);
    builder_.UpdateEdge(made, pathOnFace(from.face(), curve, from.onFace(leave), to.onFace(arrive)),
                        from.face(), Precision::Confusion());
    builder_.Add(made, sections_.section(i).vertices[1].Oriented(TopAbs_FORWARD));
    builder_.Add(made, sections_.section(next).vertices[0].Oriented(TopAbs_REVERSED));
    builder_.Range(made, 0, 1);
    if (!BRepLib::BuildCurve3d(made, Precision::Confusion()))
      throw CornerRefused(corner_why::noSpringCurve(sections_.number(i)));
    replace(rounded_.arcs[i], sections_.nearVertex(i, true), made, true);
  }

  const Corner& corner_;
  const std::vector<CornerStrip>& strips_;
  const RoundedOutside& rounded_;
  const BandSections& sections_;
  const handle<BRepTools_ReShape> change_;
  BRep_Builder builder_;
};

/// The radius of the ball beyond which fillets between planes do not obstruct each other.
double leastBall_mm(const Corner& corner, const std::vector<CornerStrip>& strips) {
  double ball_mm = 0;
  for (std::size_t i = 0; i < corner.count(); ++i)
    ball_mm = std::max(ball_mm, std::hypot(crossingIn(corner, strips, i)[0], strips[i].contact_mm));
  return ball_mm;
}

constexpr const char* band_name = "band ";  ///< and the number of the edge in the corner

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
  for (std::size_t i = 0; i < rounded.bands.size(); ++i)
    call(rounded.bands[i], band_name + std::to_string(i));
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
      throw CornerRefused(corner_why::holeSides(hole.sides.size(), 2 * edges));
    std::rotate(hole.sides.begin(), begin, hole.sides.end());
    return hole;
  }
  throw CornerRefused(corner_why::noHole());
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
  std::map<int, std::size_t> bands, beside;  // the edge or face of the corner, by the new face
  for (const ShapeAttribute& face : report.model.attributes) {
    if (face.kind != TopAbs_FACE) continue;
    if (face.name.starts_with(band_name)) {
      bands.emplace(face.index, std::stoul(face.name.substr(std::strlen(band_name))));
      continue;
    }
    const TopoDS_Shape& old = given(std::stoi(face.name));
    shell.became.Bind(old, faces(face.index));
    const auto of = std::ranges::find_if(
        corner.faces, [&old](const CornerFace& at) { return at.face.IsSame(old); });
    if (of != corner.faces.end())
      beside.emplace(face.index, static_cast<std::size_t>(of - corner.faces.begin()));
  }
  // The far end of a fillet may meet a face of the corner too, one that is not beside its edge.
  const auto isContact = [&](int band, int face) {
    const auto edge = bands.find(band);
    const auto side = beside.find(face);
    return edge != bands.end() && side != beside.end() &&
           (side->second == edge->second || side->second == corner.before(edge->second));
  };
  const std::set<int> patches(report.faces.begin(), report.faces.end());
  for (const Seam& seam : findSeams(report.model.shape).seams) {
    const auto count = [&seam](const auto& kind) {
      return kind.count(seam.sides[0].face) + kind.count(seam.sides[1].face);
    };
    const TopoDS_Edge edge = TopoDS::Edge(edges(seam.edges.front()));
    if (count(patches) == 2)
      shell.seams.emplace_back(edge, CornerSeamKind::Spoke);
    else if (count(patches) == 1)
      shell.seams.emplace_back(
          edge, count(bands) == 1 ? CornerSeamKind::Section : CornerSeamKind::Spring);
    else if (isContact(seam.sides[0].face, seam.sides[1].face) ||
             isContact(seam.sides[1].face, seam.sides[0].face))
      shell.seams.emplace_back(edge, CornerSeamKind::Contact);
  }
  return shell;
}

/// Requires that each setback is less than the length of its edge. The refusal is about the edge
/// that asks for the smallest radii.
void requireRoom(const Corner& corner, const std::vector<CornerStrip>& strips,
                 const CornerFilletOptions& options) {
  std::vector<double> lengths_mm, shares;
  for (std::size_t i = 0; i < corner.count(); ++i) {
    lengths_mm.push_back(GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(corner.edges[i].edge)));
    shares.push_back(strips[i].setback_mm / lengths_mm.back());
  }
  const auto worst = static_cast<std::size_t>(std::ranges::max_element(shares) - shares.begin());
  if (!(shares[worst] < 1))
    throw CornerRefused(corner_why::setBackBeyondEnd(
        setBackFillet(corner, strips, options, worst, lengths_mm[worst])));
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

/// Parameters of an attempt.
struct Attempt {
  double margin = 1;    ///< radius of the ball over that needed for planes
  int most_degree = 9;  ///< largest degree of the polynomials fitted to the sides of the hole
};

/// A finished corner, and whether it reaches the target.
struct Made {
  RoundedCorner corner;
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
  const BandSections sections(corner, strips, rounded);
  BandTrimmer trimmer(corner, strips, rounded, sections);
  const Model holed = holedModel(rounded, trimmer, trimmer.run());

  FillHoleOptions how;
  how.tolerance = options.tolerance;
  // A choice: far below the shortest side, so that its ends stay apart.
  how.tolerance.gap_mm = std::min(how.tolerance.gap_mm, sections.shortestSide_mm() / 10);
  how.keep_anyway = true;
  how.graph = false;
  how.most_degree = attempt.most_degree;
  how.jobs = options.jobs;
  const TopoDS_Face first_band = TopoDS::Face(trimmer.imageOf(rounded.bands.front()));
  const FillHoleReport report =
      fillHole(holed, holeBesideBands(holed, corner.count(), first_band, how), how,
               namesOf(corner, rounded, trimmer, holed), progress);
  if (!report.filled) throw CornerRefused(corner_why::notFilled(textOf(report.reason)));

  Made made;
  made.corner.shell = shellOf(report, corner);
  made.corner.fill = fillOf(report);
  made.reached = report.reached;
  for (const FilledSide& side : report.sides)
    made.corner.section_error_mm = std::max(made.corner.section_error_mm, side.gap_mm);
  for (std::size_t i = 0; i < corner.count(); ++i)
    made.corner.edges.push_back({corner.edges[i].number, corner.edges[i].convex,
                                 corner.edges[i].opening_rad, strips[i].radius_mm,
                                 sections.contact_mm(i), strips[i].setback_mm, true});
  return made;
}

}  // namespace

RoundedCorner bandedCorner(const Corner& given, const CornerFilletOptions& options,
                           const Progress& progress) {
  const std::pair<Corner, bool> alone = ofShellAlone(given);
  const Corner& corner = alone.first;
  const std::vector<CornerStrip> strips = cornerStrips(corner, options);
  // Attempts in their order, as margin and degree. Lower degrees fit the sides less closely and
  // make fairer patches. Between curved faces, fillets may need a larger ball before they do not
  // obstruct each other.
  constexpr std::array<Attempt, 5> attempts = {{{1.1, 9}, {1.1, 5}, {1.3, 9}, {1.3, 5}, {1.6, 5}}};
  std::optional<Made> best;
  CornerReason first_reason;
  for (std::size_t k = 0; k < attempts.size(); ++k) {
    const double share = 1.0 / static_cast<double>(attempts.size());
    const Progress part =
        partOf(progress, static_cast<double>(k) * share, static_cast<double>(k + 1) * share);
    try {
      Made made = tried(corner, strips, options, attempts[k], part);
      if (!best || made.rank() > best->rank()) best = std::move(made);
      if (best->corner.fill.regular && best->reached) break;
    } catch (const CornerRefused& refused) {
      if (first_reason.empty()) first_reason = refused.reason();
    }
  }
  if (!best) throw CornerRefused(first_reason);
  return alone.second ? turnedBack(std::move(best->corner)) : std::move(best->corner);
}

}  // namespace seamwright::occ
