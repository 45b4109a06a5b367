// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <seamwright/occ_adapter/convert/surface_kind.hpp>
#include <seamwright/occ_adapter/match/boundary.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/model/compound.hpp>
#include <seamwright/occ_adapter/model/edge_curves.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

/// Of the edge; of a matched seam, of its interval of the first edge.
double lengthOf_mm(const Seam& seam) {
  const BRepAdaptor_Curve curve(seam.sides[0].edge);
  const double length = GCPnts_AbscissaPoint::Length(curve);
  const std::vector<double>& shares = seam.correspondence.a;
  return shares.empty() ? length : (shares.back() - shares.front()) * length;
}

/// BRepExtrema does not survive edges without a curve in space, so the distance is given only if
/// all have one.
MatchReason whyNoBoundary(const std::array<TopoDS_Face, 2>& faces, double match_mm) {
  if (!allEdgesHaveCurves(faces[0]) || !allEdgesHaveCurves(faces[1]))
    return match_why::noCommonBoundary(match_mm);
  const BRepExtrema_DistShapeShape distance(faces[0], faces[1]);
  return distance.IsDone() ? match_why::noCommonBoundary(match_mm, distance.Value())
                           : match_why::noCommonBoundary(match_mm);
}

/// Seams between the two faces; edges by their numbers in the model.
std::vector<Seam> seamsBetween(const TopoDS_Shape& model, const TopoDS_Shape& pair,
                               const FaceMatchOptions& options, const Progress& progress) {
  SeamGraph graph = findSeams(pair);
  matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph,
                 progress);
  TopTools_IndexedMapOfShape edges, edges_of_model;
  TopExp::MapShapes(pair, TopAbs_EDGE, edges);
  TopExp::MapShapes(model, TopAbs_EDGE, edges_of_model);
  std::vector<Seam> seams;
  for (Seam& seam : graph.seams) {
    if (seam.sides[0].face == seam.sides[1].face) continue;
    for (int& edge : seam.edges) edge = edges_of_model.FindIndex(edges(edge));
    seams.push_back(std::move(seam));
  }
  return seams;
}

std::vector<Seam>::iterator chosen(std::vector<Seam>& seams, int edge) {
  if (edge == 0)
    return std::ranges::max_element(seams, {}, [](const Seam& seam) { return lengthOf_mm(seam); });
  const auto found = std::ranges::find_if(
      seams, [edge](const Seam& seam) { return std::ranges::count(seam.edges, edge) > 0; });
  if (found != seams.end()) return found;
  std::vector<int> common;
  for (const Seam& seam : seams) common.insert(common.end(), seam.edges.begin(), seam.edges.end());
  throw std::invalid_argument(
      fmt::format("edge {} is not a common boundary of the faces; these are: {}", edge,
                  fmt::join(common, ", ")));
}

/// Smallest box of the parameter plane that holds points.
struct Box {
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;
  void add(const Eigen::Array2d& point) {
    low = low.min(point);
    high = high.max(point);
  }
};

/// Points at which a path is compared with a parameter line and with its edge: sides that are
/// natural are lines with few bends, if any.
constexpr int points_of_a_path = 65;

std::vector<Eigen::Array2d> pointsOf(const Geom2d_Curve& path, double first, double last) {
  std::vector<Eigen::Array2d> points;
  for (int k = 0; k < points_of_a_path; ++k) {
    const gp_Pnt2d point = path.Value(first + (last - first) * k / (points_of_a_path - 1));
    points.emplace_back(point.X(), point.Y());
  }
  return points;
}

Box boxOfFace(const TopoDS_Face& face) {
  Box box;
  for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
    double first = 0, last = 0;
    const handle<Geom2d_Curve> path =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(it.Current()), face, first, last);
    if (path.IsNull()) continue;
    for (const Eigen::Array2d& point : pointsOf(*path, first, last)) box.add(point);
  }
  return box;
}

Box boxOfPath(const std::vector<Eigen::Array2d>& points) {
  Box box;
  for (const Eigen::Array2d& point : points) box.add(point);
  return box;
}

/// Lengths of both partials of a surface, the largest at points.
Eigen::Array2d speeds(const Geom_BSplineSurface& surface,
                      const std::vector<Eigen::Array2d>& points) {
  Eigen::Array2d longest = Eigen::Array2d::Zero();
  for (const Eigen::Array2d& at : points) {
    gp_Pnt point;
    gp_Vec u, v;
    surface.D1(at[0], at[1], point, u, v);
    longest = longest.max(Eigen::Array2d(u.Magnitude(), v.Magnitude()));
  }
  return longest;
}

bool isMonotonous(const std::vector<Eigen::Array2d>& points, int parameter) {
  const bool up = points.front()[parameter] < points.back()[parameter];
  for (std::size_t i = 1; i < points.size(); ++i)
    if ((points[i - 1][parameter] < points[i][parameter]) != up) return false;
  return true;
}

/// Finds whether the boundary is a whole side of a spline surface or can be made one by cutting it
/// off.
class NaturalSide {
 public:
  NaturalSide(MatchSide& side, double noise_mm)
      : side_(side), points_(pointsOf(*side.pcurve.curve, side.pcurve.first, side.pcurve.last)) {
    const Eigen::Array2d speed = speeds(*side.spline, points_);
    noise_ = Eigen::Array2d::Constant(noise_mm) / speed.max(std::numeric_limits<double>::min());
    side.spline->Bounds(range_.low[0], range_.high[0], range_.low[1], range_.high[1]);
  }

  /// Sets the side's edge and cuts its spline.
  /// \returns why that cannot be; empty if it was done.
  MatchReason set() {
    const Box path = boxOfPath(points_), face = boxOfFace(side_.face);
    const Eigen::Array2d width = path.high - path.low;
    int across = 0;
    if (width[1] <= noise_[1] && (width[0] > noise_[0] || width[1] < width[0])) across = 1;
    if (width[across] > noise_[across]) return match_why::isTrimmed();
    const int along = 1 - across;
    const bool at_low = path.low[across] <= face.low[across] + noise_[across];
    if (!at_low && path.high[across] < face.high[across] - noise_[across])
      return match_why::goesOn();
    if (face.low[along] < path.low[along] - noise_[along] ||
        face.high[along] > path.high[along] + noise_[along])
      return match_why::sideIsLonger();
    if (((face.low < range_.low - noise_) || (face.high > range_.high + noise_)).any())
      return match_why::reachesBeyond();
    if (!isMonotonous(points_, along)) return match_why::boundaryTurnsBack();
    cut(across, at_low, face);
    setEdge(across, at_low);
    return {};
  }

 private:
  void setEdge(int across, bool at_low) {
    side_.edge = across == 0 ? (at_low ? PatchEdge::U0 : PatchEdge::U1)
                             : (at_low ? PatchEdge::V0 : PatchEdge::V1);
    side_.with_edge = points_.front()[1 - across] < points_.back()[1 - across];
  }

  /// Where the face ends, so that no path of it leaves the surface.
  void cut(int across, bool at_low, const Box& face) {
    Box kept = range_;
    const auto keep = [&](int parameter, double& bound, double value) {
      if (std::abs(value - bound) > noise_[parameter]) bound = value;
    };
    keep(across, at_low ? kept.low[across] : kept.high[across],
         (at_low ? face.low : face.high)[across]);
    keep(1 - across, kept.low[1 - across], face.low[1 - across]);
    keep(1 - across, kept.high[1 - across], face.high[1 - across]);
    if ((kept.low == range_.low).all() && (kept.high == range_.high).all()) return;
    side_.spline->Segment(kept.low[0], kept.high[0], kept.low[1], kept.high[1]);
  }

  MatchSide& side_;
  std::vector<Eigen::Array2d> points_;
  Eigen::Array2d noise_;
  Box range_;
};

/// The pcurve that the edge has on the face, if it stays within the larger of that distance and the
/// edge's tolerance from the curve in space; else null. A side of a surface is the boundary also
/// where a gap parts it from the edge.
Pcurve storedPath(const Coedge& use, double match_mm) {
  Pcurve path;
  path.curve = BRep_Tool::CurveOnSurface(use.edge, use.shape, path.first, path.last);
  double first = 0, last = 0;
  const handle<Geom_Curve> curve = BRep_Tool::Curve(use.edge, first, last);
  if (path.curve.IsNull() || curve.IsNull()) return path;
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(use.shape, location);
  const double near_mm = std::max(match_mm, BRep_Tool::Tolerance(use.edge));
  for (int k = 0; k < points_of_a_path; ++k) {
    const double share = static_cast<double>(k) / (points_of_a_path - 1);
    const gp_Pnt2d uv = path.curve->Value(path.first + share * (path.last - path.first));
    const gp_Pnt on_face = surface->Value(uv.X(), uv.Y()).Transformed(location.Transformation());
    if (on_face.Distance(curve->Value(first + share * (last - first))) > near_mm) return {};
  }
  return path;
}

}  // namespace

TopoDS_Shape pairOf(const std::array<TopoDS_Face, 2>& faces) {
  return compoundOf({faces[0], faces[1]});
}

CommonBoundary commonBoundary(const TopoDS_Shape& model, const std::array<TopoDS_Face, 2>& faces,
                              const FaceMatchOptions& options, const Progress& progress) {
  CommonBoundary boundary;
  std::vector<Seam> seams = seamsBetween(model, pairOf(faces), options, progress);
  if (seams.empty()) {
    boundary.failure = whyNoBoundary(faces, options.match_mm);
    return boundary;
  }
  Seam& seam = *chosen(seams, options.edge);
  if (seams.size() > 1) {
    std::vector<int> common;
    for (const Seam& each : seams)
      if (std::ranges::count(common, each.edges.front()) == 0) common.push_back(each.edges.front());
    boundary.remark = match_why::oneOfSeveralEdges(common, seam.edges.front(), options.edge == 0);
  }
  boundary.seam = std::move(seam);
  return boundary;
}

MatchReason whyApart(const Seam& seam, const FaceMatchOptions& options) {
  const double near_mm = std::max(options.match_mm, options.tolerance.gap_mm);
  // What is shorter is not a seam by itself, and may be left out: see shortestSeam_mm().
  constexpr double left_out = 4;
  for (const int which : {0, 1}) {
    const std::vector<double>& shares = which == 0 ? seam.correspondence.a : seam.correspondence.b;
    if (shares.empty()) continue;
    const BRepAdaptor_Curve curve(seam.sides[which].edge);
    const auto [low, high] = std::minmax(shares.front(), shares.back());
    const auto length_mm = [&](double from, double to) {
      const double first = curve.FirstParameter(), range = curve.LastParameter() - first;
      return GCPnts_AbscissaPoint::Length(curve, first + from * range, first + to * range);
    };
    if (std::max(length_mm(0, low), length_mm(high, 1)) <= left_out * near_mm) continue;
    return match_why::boundariesApart(near_mm, length_mm(low, high), length_mm(0, 1));
  }
  return {};
}

MatchSide matchSide(const TopoDS_Face& face, const Coedge& use, const FaceMatchOptions& options) {
  MatchSide side{face, use, storedPath(use, options.match_mm), {}, PatchEdge::U0, true, {}};
  const bool is_stored = !side.pcurve.curve.IsNull();
  if (!is_stored) side.pcurve = pcurveOf(use.edge, use.shape, options.tolerance.gap_mm);
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
  side.spline = clampedSpline(surface, location);
  if (side.spline.IsNull()) {
    side.cannot_move = match_why::hasNoPoles(kindOf(face));
    return side;
  }
  // A hundredth of the gap is negligible, and above the rounding of pcurves in files.
  side.cannot_move = NaturalSide(side, options.tolerance.gap_mm / 100).set();
  if (side.cannot_move.empty()) return side;
  side.spline.Nullify();
  if (is_stored) side.pcurve = pcurveOf(use.edge, use.shape, options.tolerance.gap_mm);
  return side;
}

}  // namespace seamwright::occ
