// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <ShapeCustom.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/fill/corner_ball.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/fill/repaired_solid.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

/// Directions from the corner into its faces, approximately where a small ball cuts them.
std::vector<Vector3d> directionsInFaces(const Corner& corner) {
  std::vector<Vector3d> directions;
  for (std::size_t i = 0; i < corner.count(); ++i)
    for (int k = 0; k < 8; ++k)
      directions.push_back(
          Eigen::AngleAxisd(corner.faces[i].angle_rad * k / 8, corner.faces[i].normal) *
          corner.edges[i].axis);
  return directions;
}

/// Axes of the ball such that its closing edge, a half circle from pole to pole, is far from the
/// cuts.
gp_Ax2 ballAxes(const Corner& corner) {
  const std::vector<Vector3d> faces = directionsInFaces(corner);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Vector3d best_pole = Vector3d::UnitZ(), best_middle = Vector3d::UnitX();
  double best = 2;
  // Trials and samples are choices. Any half circle that misses the cuts will do, and each trial
  // takes some hundred products. Fixed random numbers give the same ball each time.
  constexpr int trials = 500;
  for (int trial = 0; trial < trials; ++trial) {
    const Vector3d middle = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Vector3d pole = middle.unitOrthogonal();
    double nearest = -1;
    for (int k = -6; k <= 6; ++k) {
      const double angle = k * std::numbers::pi / 12;
      const Vector3d at = std::cos(angle) * middle + std::sin(angle) * pole;
      for (const Vector3d& direction : faces) nearest = std::max(nearest, at.dot(direction));
    }
    if (nearest >= best) continue;
    best = nearest;
    best_pole = pole;
    best_middle = middle;
  }
  return {gp_Pnt(corner.point.x(), corner.point.y(), corner.point.z()), directionOf(best_pole),
          directionOf(best_middle)};
}

/// Edges of the ball, each with the face on its other side.
using BallBoundary = std::vector<std::pair<TopoDS_Edge, TopoDS_Face>>;

/// Whether one of the edges ends at the vertex.
bool endsAt(const std::vector<TopoDS_Edge>& arcs, const TopoDS_Vertex& vertex) {
  return std::ranges::any_of(arcs, [&](const TopoDS_Edge& arc) {
    return TopExp::FirstVertex(arc).IsSame(vertex) || TopExp::LastVertex(arc).IsSame(vertex);
  });
}

/// The edges that lead from one of some arcs to one of others; empty if there are none.
BallBoundary pathBetween(const BallBoundary& edges, const std::vector<TopoDS_Edge>& from,
                         const std::vector<TopoDS_Edge>& to) {
  for (const auto& start : edges)
    for (const TopoDS_Vertex& end :
         {TopExp::FirstVertex(start.first), TopExp::LastVertex(start.first)}) {
      if (!endsAt(from, end)) continue;
      BallBoundary path = {start};
      TopoDS_Vertex at = otherEnd(start.first, end);
      while (!endsAt(to, at)) {
        const auto next = std::ranges::find_if(edges, [&](const auto& entry) {
          return !entry.first.IsSame(path.back().first) &&
                 (TopExp::FirstVertex(entry.first).IsSame(at) ||
                  TopExp::LastVertex(entry.first).IsSame(at));
        });
        if (next == edges.end() || path.size() == edges.size()) break;
        path.push_back(*next);
        at = otherEnd(next->first, at);
      }
      if (endsAt(to, at)) return path;
    }
  return {};
}

class OutsideRounder {
 public:
  /// \param direct the corner's solid with the same numbers, possibly converted to have no faces on
  /// left-handed surfaces.
  OutsideRounder(const Corner& corner, const std::vector<CornerStrip>& strips, double ball_mm,
                 TopoDS_Shape direct)
      : corner_(corner),
        strips_(strips),
        ball_mm_(ball_mm),
        direct_(std::move(direct)),
        ball_(BRepPrimAPI_MakeSphere(ballAxes(corner), ball_mm).Shape()),
        cut_(direct_, ball_) {}

  RoundedOutside run() {
    TopExp_Explorer solid(cut_.Shape(), TopAbs_SOLID);
    if (!cut_.IsDone() || !solid.More()) throw CornerRefused(corner_why::ballStays(ball_mm_));
    BRepFilletAPI_MakeFillet fillets(solid.Current());
    // A tenth of the default tolerances, because the patches of the corner must meet the bands.
    fillets.SetParams(1e-3, 1e-5, 1e-6, 1e-5, 1e-6, 1e-4);
    solid.Next();
    if (solid.More()) throw CornerRefused(corner_why::ballDividesSolid(ball_mm_));
    for (std::size_t i = 0; i < corner_.count(); ++i) add(i, fillets);
    fillets.Build();
    if (!fillets.IsDone()) throw CornerRefused(whyNotRounded(fillets));
    TopExp_Explorer rounded(fillets.Shape(), TopAbs_SOLID);
    if (!rounded.More()) throw CornerRefused(corner_why::noSolid(ball_mm_));
    repaired_ = repairedSolid(rounded.Current());
    result_.solid = repaired_.solid;
    follow(fillets);
    readBall();
    return std::move(result_);
  }

 private:
  /// The edge, and the one whose contact lines ask for so large a ball: the edge itself if none is
  /// wider but for rounding.
  corner_why::EdgeOutside outside(std::size_t i) const {
    const std::size_t widest = static_cast<std::size_t>(
        std::ranges::max_element(strips_, {}, &CornerStrip::contact_mm) - strips_.begin());
    const bool own = strips_[widest].contact_mm <= (1 + 1e-9) * strips_[i].contact_mm;
    const std::size_t cause = own ? i : widest;
    return {.edge = corner_.edges[i].number,
            .cause = corner_.edges[cause].number,
            .cause_radius_mm = strips_[cause].radius_mm,
            .ball_mm = ball_mm_};
  }

  TopoDS_Shape directEdge(const TopoDS_Edge& edge) const {
    return partsOf(direct_, TopAbs_EDGE)(partsOf(corner_.solid, TopAbs_EDGE).FindIndex(edge));
  }

  void add(std::size_t i, BRepFilletAPI_MakeFillet& fillets) {
    const TopTools_ListOfShape& parts = cut_.Modified(directEdge(corner_.edges[i].edge));
    if (parts.Extent() != 1)
      throw CornerRefused(corner_why::edgeInParts(outside(i), parts.Extent()));
    const TopoDS_Edge edge = TopoDS::Edge(parts.First());
    if (fillets.Contour(edge) > 0) throw CornerRefused(corner_why::edgeContinues(outside(i)));
    fillets.Add(strips_[i].radius_mm, edge);
    if (fillets.Contour(edge) == 0) throw CornerRefused(corner_why::edgeHasNoFillet(outside(i)));
    edges_.push_back(edge);
  }

  CornerReason whyNotRounded(const BRepFilletAPI_MakeFillet& fillets) const {
    std::vector<int> edges;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (fillets.StripeStatus(fillets.Contour(edges_[i])) != ChFiDS_Ok)
        edges.push_back(corner_.edges[i].number);
    std::vector<Vector3d> points;
    for (int k = 1; k <= fillets.NbFaultyVertices(); ++k)
      points.push_back(vector(BRep_Tool::Pnt(fillets.FaultyVertex(k)).XYZ()));
    return corner_why::notRounded(ball_mm_, edges, points);
  }

  /// The face after both steps; a null face if it is gone or split.
  TopoDS_Face imageOf(const TopoDS_Shape& face, BRepFilletAPI_MakeFillet& fillets) {
    TopoDS_Shape now = face;
    if (const TopTools_ListOfShape& parts = cut_.Modified(face); !parts.IsEmpty()) {
      if (parts.Extent() > 1) return {};
      now = parts.First();
    }
    if (const TopTools_ListOfShape& parts = fillets.Modified(now); !parts.IsEmpty()) {
      if (parts.Extent() > 1) return {};
      now = parts.First();
    }
    const int index = faces_.FindIndex(repaired_.imageOf(now));
    return index == 0 ? TopoDS_Face() : TopoDS::Face(faces_(index));
  }

  void follow(BRepFilletAPI_MakeFillet& fillets) {
    TopExp::MapShapes(result_.solid, TopAbs_FACE, faces_);
    const TopTools_IndexedMapOfShape direct = partsOf(direct_, TopAbs_FACE);
    for (int face = 1; face <= direct.Extent(); ++face)
      if (const TopoDS_Face now = imageOf(direct(face), fillets); !now.IsNull())
        result_.became.emplace(face, now);
    for (TopExp_Explorer face(ball_, TopAbs_FACE); face.More(); face.Next()) {
      TopTools_ListOfShape parts = cut_.Modified(face.Current());
      if (parts.IsEmpty()) parts.Append(face.Current());
      for (const TopoDS_Shape& part : parts) {
        TopTools_ListOfShape now = fillets.Modified(part);
        if (now.IsEmpty()) now.Append(part);
        for (const TopoDS_Shape& cap : now)
          if (const int index = faces_.FindIndex(repaired_.imageOf(cap)); index > 0)
            result_.caps.push_back(TopoDS::Face(faces_(index)));
      }
    }
    if (result_.caps.empty()) throw CornerRefused(corner_why::ballIsGone(ball_mm_));
  }

  BallBoundary ballBoundary() const {
    TopTools_IndexedDataMapOfShapeListOfShape around;
    TopExp::MapShapesAndUniqueAncestors(result_.solid, TopAbs_EDGE, TopAbs_FACE, around);
    BallBoundary boundary;
    for (const TopoDS_Face& cap : result_.caps)
      for (TopExp_Explorer edge(cap, TopAbs_EDGE); edge.More(); edge.Next())
        for (const TopoDS_Shape& face : around.FindFromKey(edge.Current()))
          if (std::ranges::none_of(result_.caps,
                                   [&](const TopoDS_Face& own) { return own.IsSame(face); }))
            boundary.emplace_back(TopoDS::Edge(edge.Current().Oriented(TopAbs_FORWARD)),
                                  TopoDS::Face(face));
    return boundary;
  }

  /// Divides the edges of the ball among the faces of the corner and the fillets between them.
  /// OpenCASCADE does not name the faces that it makes of every edge; so a fillet is what leads
  /// along the ball from the face before its edge to the face after it.
  void readBall() {
    const BallBoundary boundary = ballBoundary();
    BallBoundary beside_fillets = boundary;
    for (std::size_t i = 0; i < corner_.count(); ++i) {
      const auto now = result_.became.find(numberOf(corner_.faces[i].face));
      const auto is_arc = [&](const auto& entry) {
        return now != result_.became.end() && entry.second.IsSame(now->second);
      };
      std::vector<TopoDS_Edge> arcs;
      for (const auto& entry : boundary)
        if (is_arc(entry)) arcs.push_back(entry.first);
      std::erase_if(beside_fillets, is_arc);
      result_.arcs.push_back(std::move(arcs));
    }
    std::size_t left = beside_fillets.size();
    for (std::size_t i = 0; i < corner_.count(); ++i) {
      const std::size_t before = (i + corner_.count() - 1) % corner_.count();
      const BallBoundary path = pathBetween(beside_fillets, result_.arcs[before], result_.arcs[i]);
      if (path.empty()) throw CornerRefused(corner_why::filletMissesBall(outside(i)));
      std::vector<TopoDS_Edge> ends;
      for (const auto& [edge, face] : path) {
        if (!face.IsSame(path.front().second))
          throw CornerRefused(corner_why::filletInSeveralFaces(ball_mm_));
        ends.push_back(edge);
      }
      left -= ends.size();
      result_.band_ends.push_back(std::move(ends));
      result_.bands.push_back(path.front().second);
    }
    if (left != 0)
      throw CornerRefused(
          corner_why::ballNotSurrounded(ball_mm_, boundary.size(), boundary.size() - left));
  }

  int numberOf(const TopoDS_Face& face) const {
    return partsOf(corner_.solid, TopAbs_FACE).FindIndex(face);
  }

  const Corner& corner_;
  const std::vector<CornerStrip>& strips_;
  const double ball_mm_;
  TopoDS_Shape direct_;
  TopoDS_Shape ball_;
  BRepAlgoAPI_Cut cut_;
  std::vector<TopoDS_Edge> edges_;  ///< what is left of the corner's edges
  RepairedSolid repaired_;
  TopTools_IndexedMapOfShape faces_;
  RoundedOutside result_;
};

}  // namespace

RoundedOutside roundedOutside(const Corner& corner, const std::vector<CornerStrip>& strips,
                              double ball_mm) {
  try {
    // OpenCASCADE's Boolean operations fail for some faces on left-handed surfaces, and for some
    // converted ones. So the given solid is tried first, then the converted one.
    try {
      return OutsideRounder(corner, strips, ball_mm, corner.solid).run();
    } catch (const CornerRefused&) {
      const TopoDS_Shape turned = ShapeCustom::DirectFaces(corner.solid);
      if (turned.IsSame(corner.solid)) throw;
      return OutsideRounder(corner, strips, ball_mm, turned).run();
    }
  } catch (const Standard_Failure& failure) {
    throw CornerRefused(corner_why::ballFailed(ball_mm, failure));
  }
}

}  // namespace seamwright::occ
