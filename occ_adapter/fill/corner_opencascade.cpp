// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepCheck_Analyzer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRep_Tool.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_hole.hpp>
#include <seamwright/occ_adapter/fill/corner_opencascade.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/fill/repaired_solid.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

namespace {

/// Parameters of BRepFilletAPI_MakeFillet::SetParams(), by their names there.
struct FilletParams {
  double tang, tesp, t2d, tapp3d, tolapp2d, fleche;
};

/// Sets of faces, kept from pass to pass.
using FaceList = std::vector<TopoDS_Shape>;

/// A face that a pass made.
struct MadeFace {
  TopoDS_Shape face;
  bool fillet = false;  ///< of an edge; else it closes a corner between fillets
  FaceList beside;      ///< the faces that the fillet touches along its edge
};

/// Fillets of the corner's edges, made in passes, each of them in the solid of the one before.
class FilletPasses {
 public:
  explicit FilletPasses(const Corner& corner) : corner_(corner), solid_(corner.solid) {
    for (TopExp_Explorer face(corner.shell, TopAbs_FACE); face.More(); face.Next())
      given_.emplace_back(face.Current(), face.Current());
    for (const CornerEdge& edge : corner.edges) edges_.push_back(edge.edge);
    skipped_.resize(corner.count());
  }

  /// Rounds these edges at once.
  /// \throws CornerRefused if OpenCASCADE does not, or divides a face.
  void round(const std::vector<std::size_t>& which, const std::vector<CornerStrip>& strips,
             double crease_rad, const FilletParams& with) {
    BRepFilletAPI_MakeFillet fillets(solid_);
    fillets.SetParams(with.tang, with.tesp, with.t2d, with.tapp3d, with.tolapp2d, with.fleche);
    for (const std::size_t i : which) add(i, strips[i].radius_mm, crease_rad, fillets);
    if (fillets.NbContours() == 0) throw CornerRefused(corner_why::openCascadeHasNone());
    requireOwnRadii(which, strips, fillets);
    fillets.Build();
    if (!fillets.IsDone()) throw CornerRefused(corner_why::openCascadeHasNone());
    const TopExp_Explorer solid(fillets.Shape(), TopAbs_SOLID);
    if (!solid.More()) throw CornerRefused(corner_why::openCascadeHasNone());
    follow(fillets, repairedSolid(solid.Current()));
  }

  CornerShell shell() const {
    CornerShell result;
    result.shell = TopoDS::Shell(TopExp_Explorer(solid_, TopAbs_SHELL).Current());
    if (!BRepCheck_Analyzer(solid_).IsValid() || !BRep_Tool::IsClosed(result.shell))
      throw CornerRefused(corner_why::checksFail());
    for (const auto& [was, now] : given_)
      if (!now.IsNull()) result.became.Bind(was, now);
    const TopTools_IndexedMapOfShape faces = partsOf(solid_, TopAbs_FACE),
                                     edges = partsOf(solid_, TopAbs_EDGE);
    for (const Seam& seam : findSeams(solid_).seams)
      if (const auto kind = kindOf(faces(seam.sides[0].face), faces(seam.sides[1].face)))
        result.seams.emplace_back(TopoDS::Edge(edges(seam.edges.front())), *kind);
    return result;
  }

  /// Whether OpenCASCADE leaves the edge as it is, because it is nearly smooth.
  bool skipped(std::size_t i) const { return skipped_[i]; }

 private:
  void add(std::size_t i, double radius_mm, double crease_rad, BRepFilletAPI_MakeFillet& fillets) {
    if (edges_[i].IsNull()) throw CornerRefused(corner_why::openCascadeHasNone());
    const TopoDS_Edge edge = TopoDS::Edge(edges_[i]);
    if (fillets.Contour(edge) == 0) fillets.Add(radius_mm, edge);
    if (fillets.Contour(edge) != 0) return;
    if (std::numbers::pi - corner_.edges[i].opening_rad > crease_rad)
      throw CornerRefused(corner_why::openCascadeHasNone());
    skipped_[i] = true;
  }

  /// OpenCASCADE makes one fillet of a smooth chain. A radius that changes along it would not keep
  /// to that of each edge.
  void requireOwnRadii(const std::vector<std::size_t>& which,
                       const std::vector<CornerStrip>& strips,
                       const BRepFilletAPI_MakeFillet& fillets) const {
    for (const std::size_t i : which) {
      if (skipped_[i]) continue;
      const int chain = fillets.Contour(TopoDS::Edge(edges_[i]));
      for (const std::size_t k : which)
        if (!skipped_[k] && strips[k].radius_mm != strips[i].radius_mm &&
            fillets.Contour(TopoDS::Edge(edges_[k])) == chain)
          throw CornerRefused(corner_why::openCascadeHasNone());
    }
  }

  /// Finds what became of all faces and edges, and the new faces. OpenCASCADE does not name all
  /// fillets by their edges.
  void follow(BRepFilletAPI_MakeFillet& fillets, const RepairedSolid& now) {
    const TopTools_IndexedMapOfShape faces = partsOf(now.solid, TopAbs_FACE),
                                     edges = partsOf(now.solid, TopAbs_EDGE);
    const auto image = [&](const TopoDS_Shape& part) -> TopoDS_Shape {
      if (part.IsNull()) return part;
      const TopTools_ListOfShape& parts = fillets.Modified(part);
      if (parts.Extent() > 1) throw CornerRefused(corner_why::openCascadeHasNone());
      const TopoDS_Shape after = now.imageOf(parts.IsEmpty() ? part : parts.First());
      return faces.Contains(after) || edges.Contains(after) ? after : TopoDS_Shape();
    };
    std::vector<MadeFace> made;
    TopTools_IndexedDataMapOfShapeListOfShape around;
    TopExp::MapShapesAndUniqueAncestors(solid_, TopAbs_EDGE, TopAbs_FACE, around);
    for (int chain = 1; chain <= fillets.NbContours(); ++chain)
      for (int k = 1; k <= fillets.NbEdges(chain); ++k) {
        const TopoDS_Edge edge = fillets.Edge(chain, k);
        FaceList beside;
        for (const TopoDS_Shape& face : around.FindFromKey(edge)) beside.push_back(image(face));
        for (const TopoDS_Shape& face : fillets.Generated(edge))
          made.push_back({now.imageOf(face), true, beside});
        for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
          for (const TopoDS_Shape& face : fillets.Generated(end))
            made.push_back({now.imageOf(face), false, {}});
        beside_any_.insert(beside_any_.end(), beside.begin(), beside.end());
      }
    for (auto& [was, is] : given_) is = image(is);
    for (TopoDS_Shape& edge : edges_) edge = image(edge);
    for (MadeFace& face : made_) {
      face.face = image(face.face);
      for (TopoDS_Shape& beside : face.beside) beside = image(beside);
    }
    for (TopoDS_Shape& face : beside_any_)
      if (!face.IsNull() && !faces.Contains(face)) face = image(face);
    made_.insert(made_.end(), made.begin(), made.end());
    solid_ = now.solid;
  }

  bool isGiven(const TopoDS_Shape& face) const {
    return std::ranges::any_of(given_, [&](const auto& given) {
      return !given.second.IsNull() && given.second.IsSame(face);
    });
  }

  bool isNamed(const TopoDS_Shape& face, bool as_fillet) const {
    return std::ranges::any_of(made_, [&](const MadeFace& made) {
      return made.fillet == as_fillet && !made.face.IsNull() && made.face.IsSame(face);
    });
  }

  bool isPatch(const TopoDS_Shape& face) const {
    return isNamed(face, false) && !isNamed(face, true);
  }

  /// A fillet that is not named may touch all faces beside the edges.
  bool touches(const TopoDS_Shape& fillet, const TopoDS_Shape& face) const {
    const auto holds = [&face](const FaceList& faces) {
      return std::ranges::any_of(
          faces, [&](const TopoDS_Shape& one) { return !one.IsNull() && one.IsSame(face); });
    };
    if (!isNamed(fillet, true)) return holds(beside_any_);
    return std::ranges::any_of(made_, [&](const MadeFace& made) {
      return made.fillet && !made.face.IsNull() && made.face.IsSame(fillet) && holds(made.beside);
    });
  }

  /// Nothing for seams that were there before, for those inside one face, and for the far ends of
  /// fillets.
  std::optional<CornerSeamKind> kindOf(const TopoDS_Shape& a, const TopoDS_Shape& b) const {
    const bool a_given = isGiven(a), b_given = isGiven(b);
    if (a.IsSame(b) || (a_given && b_given)) return std::nullopt;
    const bool a_patch = isPatch(a), b_patch = isPatch(b);
    if (a_patch && b_patch) return CornerSeamKind::Spoke;
    if (a_patch || b_patch)
      return a_given || b_given ? CornerSeamKind::Spring : CornerSeamKind::Section;
    if (!a_given && !b_given) return CornerSeamKind::Fillets;
    if (a_given ? touches(b, a) : touches(a, b)) return CornerSeamKind::Contact;
    return std::nullopt;
  }

  const Corner& corner_;
  TopoDS_Shape solid_;
  std::vector<std::pair<TopoDS_Shape, TopoDS_Shape>> given_;  ///< faces, and what they became
  std::vector<TopoDS_Shape> edges_;                           ///< of the corner, as they are now
  std::vector<bool> skipped_;
  std::vector<MadeFace> made_;
  FaceList beside_any_;
};

/// A way to round the corner: the edges of each pass.
struct FilletPlan {
  std::vector<std::vector<std::size_t>> passes;
  FilletParams params;
};

/// All edges at once, then one of them before the others, whose fillets roll on around its end. A
/// tenth of the default tolerances makes smoother seams; the default ones succeed more often.
std::vector<FilletPlan> plansFor(std::size_t count) {
  constexpr FilletParams fine = {1e-3, 1e-5, 1e-6, 1e-5, 1e-6, 1e-4},
                         usual = {1e-2, 1e-4, 1e-5, 1e-4, 1e-5, 1e-3};
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<FilletPlan> plans = {{{all}, fine}, {{all}, usual}};
  for (const std::size_t first : all) {
    std::vector<std::size_t> others = all;
    std::erase(others, first);
    plans.push_back({{{first}, others}, fine});
  }
  return plans;
}

RoundedCorner carriedOut(const FilletPlan& plan, const Corner& corner,
                         const std::vector<CornerStrip>& strips, double crease_rad) {
  FilletPasses fillets(corner);
  for (const std::vector<std::size_t>& pass : plan.passes)
    fillets.round(pass, strips, crease_rad, plan.params);
  RoundedCorner made;
  made.shell = fillets.shell();
  made.filler = CornerFiller::OpenCascade;
  for (std::size_t i = 0; i < corner.count(); ++i) {
    const CornerEdge& edge = corner.edges[i];
    made.edges.push_back({edge.number, edge.convex, edge.opening_rad, strips[i].radius_mm,
                          strips[i].contact_mm, 0, !fillets.skipped(i)});
  }
  return made;
}

}  // namespace

RoundedCorner openCascadeCorner(const Corner& given, const CornerFilletOptions& options) {
  const std::pair<Corner, bool> alone = ofShellAlone(given);
  const std::vector<CornerStrip> strips = cornerStrips(alone.first, options);
  CornerReason reason;
  for (const FilletPlan& plan : plansFor(given.count())) {
    try {
      RoundedCorner made = carriedOut(plan, alone.first, strips, options.tolerance.crease_rad);
      return alone.second ? turnedBack(std::move(made)) : made;
    } catch (const CornerRefused& refused) {
      reason = refused.reason();
    } catch (const Standard_Failure&) {
      reason = corner_why::openCascadeHasNone();
    }
  }
  throw CornerRefused(reason);
}

}  // namespace seamwright::occ
