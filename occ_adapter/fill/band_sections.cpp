// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Builder.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include <seamwright/occ_adapter/fill/band_sections.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>

namespace seamwright::occ {

using Eigen::Vector3d;

namespace {

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
    // More halvings than a double has digits.
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (f(middle) < 0 ? low : high) = middle;
    }
    return (low + high) / 2;
  }
  return std::nullopt;
}

/// A point of the edge with the tangent there, pointing away from the corner.
struct EdgePoint {
  Vector3d point, tangent;
};

EdgePoint edgePointAt(const CornerEdge& edge, double setback_mm) {
  const BRepAdaptor_Curve curve(TopoDS::Edge(edge.edge.Oriented(TopAbs_FORWARD)));
  const bool leaves =
      TopExp::LastVertex(TopoDS::Edge(edge.edge.Oriented(TopAbs_FORWARD))).IsSame(edge.far);
  const double sense = leaves ? 1 : -1;
  const double from = leaves ? curve.FirstParameter() : curve.LastParameter();
  const GCPnts_AbscissaPoint foot(curve, sense * setback_mm, from);
  gp_Pnt point;
  gp_Vec run;
  curve.D1(foot.Parameter(), point, run);
  return {vector(point), sense * vector(run).normalized()};
}

}  // namespace

BandSections::BandSections(const Corner& corner, const std::vector<CornerStrip>& strips,
                           const RoundedOutside& rounded)
    : corner_(corner), strips_(strips), rounded_(rounded) {
  TopExp::MapShapesAndUniqueAncestors(rounded.solid, TopAbs_EDGE, TopAbs_FACE, around_);
  TopExp::MapShapesAndUniqueAncestors(rounded.solid, TopAbs_VERTEX, TopAbs_EDGE, edges_at_);
  for (std::size_t i = 0; i < corner.count(); ++i) {
    for (const bool after : {false, true}) contacts_.push_back(contactOf(i, after));
    sections_.push_back(sectionOf(i));
  }
}

double BandSections::shortestSide_mm() const {
  double shortest = HUGE_VAL;
  for (std::size_t i = 0; i < corner_.count(); ++i)
    shortest = std::min({shortest, (point(i, 1) - point(i, 0)).norm(),
                         (point(corner_.after(i), 0) - point(i, 1)).norm()});
  return shortest;
}

double BandSections::contact_mm(std::size_t i) const {
  const Vector3d foot = edgePointAt(corner_.edges[i], strips_[i].setback_mm).point;
  return ((point(i, 0) - foot).norm() + (point(i, 1) - foot).norm()) / 2;
}

int BandSections::number(std::size_t i) const {
  return corner_.edges[i].number;
}

TopoDS_Vertex BandSections::nearVertex(std::size_t i, bool after) const {
  TopoDS_Vertex vertex;
  for (const TopoDS_Edge& arc : rounded_.arcs[after ? i : corner_.before(i)])
    for (const TopoDS_Edge& end : rounded_.band_ends[i])
      if (TopExp::CommonVertex(end, arc, vertex)) return vertex;
  throw CornerRefused(corner_why::filletApart(number(i)));
}

Contact BandSections::contactOf(std::size_t i, bool after) const {
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
  throw CornerRefused(corner_why::filletHasNoEdge(number(i)));
}

Section BandSections::sectionOf(std::size_t i) const {
  const EdgePoint foot = edgePointAt(corner_.edges[i], strips_[i].setback_mm);
  Section section;
  double along = 0;
  for (const std::size_t side : {0, 1}) {
    const Contact& contact = contacts_[2 * i + side];
    const auto beyond = [&](double share) {
      return (contact.point(share) - foot.point).dot(foot.tangent);
    };
    const std::optional<double> share = beyond(0) < 0 ? crossingOf(beyond) : std::nullopt;
    if (!share)
      throw CornerRefused(corner_why::setbackOutside(number(i), strips_[i].setback_mm,
                                                     strips_[i].setback_mm + beyond(0),
                                                     strips_[i].setback_mm + beyond(1)));
    along += coordinate(contact.onBand(*share), runsInU(i)) / 2;
  }
  for (const std::size_t side : {0, 1}) {
    const Contact& contact = contacts_[2 * i + side];
    const double begin = coordinate(contact.onBand(0), runsInU(i)),
                 end = coordinate(contact.onBand(1), runsInU(i));
    const double sense = end > begin ? 1 : -1;
    const std::optional<double> share = crossingOf(
        [&](double at) { return sense * (coordinate(contact.onBand(at), runsInU(i)) - along); });
    if (!share) throw CornerRefused(corner_why::noSection(number(i)));
    section.shares[side] = *share;
    section.vertices[side] = vertexOn(contact, i, *share);
  }
  return section;
}

bool BandSections::runsInU(std::size_t i) const {
  const Contact& contact = contacts_[2 * i];
  const gp_Pnt2d begin = contact.onBand(0), end = contact.onBand(1);
  gp_Pnt point;
  gp_Vec u, v;
  BRepAdaptor_Surface(rounded_.bands[i], false).D1(begin.X(), begin.Y(), point, u, v);
  return std::abs(end.X() - begin.X()) * u.Magnitude() >
         std::abs(end.Y() - begin.Y()) * v.Magnitude();
}

TopoDS_Vertex BandSections::vertexOn(const Contact& contact, std::size_t i, double share) const {
  const gp_Pnt2d at = contact.onBand(share), beside = contact.onFace(share);
  const gp_Pnt on_band = BRepAdaptor_Surface(rounded_.bands[i], false).Value(at.X(), at.Y());
  const gp_Pnt on_face = BRepAdaptor_Surface(contact.face(), false).Value(beside.X(), beside.Y());
  const Vector3d point = contact.point(share);
  const gp_Pnt p(point.x(), point.y(), point.z());
  TopoDS_Vertex vertex;
  BRep_Builder().MakeVertex(
      vertex, p,
      std::max({Precision::Confusion(), 2 * p.Distance(on_band), 2 * p.Distance(on_face)}));
  return vertex;
}

}  // namespace seamwright::occ
