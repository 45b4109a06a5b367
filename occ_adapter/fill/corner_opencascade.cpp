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
#include <array>
#include <map>
#include <optional>
#include <set>

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

/// The fillets of a corner's edges, with the faces of its shell.
class WholeFillet {
 public:
  WholeFillet(const Corner& corner, const std::vector<CornerStrip>& strips,
              const FilletParams& with)
      : corner_(corner), fillets_(corner.solid) {
    fillets_.SetParams(with.tang, with.tesp, with.t2d, with.tapp3d, with.tolapp2d, with.fleche);
    for (std::size_t i = 0; i < corner.count(); ++i) add(corner.edges[i], strips[i].radius_mm);
    fillets_.Build();
    if (!fillets_.IsDone()) throw CornerRefused(corner_why::openCascadeHasNone());
    TopExp_Explorer solid(fillets_.Shape(), TopAbs_SOLID);
    if (!solid.More()) throw CornerRefused(corner_why::openCascadeHasNone());
    made_ = repairedSolid(solid.Current());
    TopExp::MapShapes(made_.solid, TopAbs_FACE, faces_);
  }

  CornerShell shell() {
    const TopExp_Explorer shell(made_.solid, TopAbs_SHELL);
    CornerShell result;
    result.shell = TopoDS::Shell(shell.Current());
    if (!BRepCheck_Analyzer(made_.solid).IsValid() || !BRep_Tool::IsClosed(result.shell))
      throw CornerRefused(corner_why::checksFail());
    for (TopExp_Explorer given(corner_.shell, TopAbs_FACE); given.More(); given.Next()) {
      const int now = imageOf(given.Current());
      if (now == 0) continue;
      result.became.Bind(given.Current(), faces_(now));
      given_.insert(now);
    }
    readChains();
    for (const Seam& seam : findSeams(made_.solid).seams)
      if (const auto kind = kindOf(seam))
        result.seams.emplace_back(TopoDS::Edge(partsOf(made_.solid, TopAbs_EDGE)(seam.edges[0])),
                                  *kind);
    return result;
  }

 private:
  void add(const CornerEdge& edge, double radius_mm) {
    if (const int chain = fillets_.Contour(edge.edge); chain > 0) {
      if (fillets_.Radius(chain) != radius_mm)
        throw CornerRefused(corner_why::openCascadeHasNone());
      return;
    }
    fillets_.Add(radius_mm, edge.edge);
    if (fillets_.Contour(edge.edge) == 0) throw CornerRefused(corner_why::openCascadeHasNone());
  }

  /// The number of the face that the given one became; 0 if it is gone.
  int imageOf(const TopoDS_Shape& given) {
    const TopTools_ListOfShape& parts = fillets_.Modified(given);
    if (parts.Extent() > 1) throw CornerRefused(corner_why::openCascadeHasNone());
    return faces_.FindIndex(made_.imageOf(parts.IsEmpty() ? given : parts.First()));
  }

  std::set<int> generatedBy(const TopoDS_Shape& part) {
    std::set<int> numbers;
    for (const TopoDS_Shape& face : fillets_.Generated(part))
      if (const int number = faces_.FindIndex(made_.imageOf(face)); number > 0)
        numbers.insert(number);
    return numbers;
  }

  /// Finds the faces that close corners, and the faces that each fillet touches. OpenCASCADE does
  /// not name all fillets by their edges. The others may touch all faces beside the edges.
  void readChains() {
    TopTools_IndexedDataMapOfShapeListOfShape around;
    TopExp::MapShapesAndUniqueAncestors(corner_.shell, TopAbs_EDGE, TopAbs_FACE, around);
    for (int chain = 1; chain <= fillets_.NbContours(); ++chain)
      for (int k = 1; k <= fillets_.NbEdges(chain); ++k) {
        const TopoDS_Edge edge = fillets_.Edge(chain, k);
        for (const TopoDS_Vertex& end : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)})
          patches_.merge(generatedBy(end));
        std::set<int> beside;
        for (const TopoDS_Shape& face : around.FindFromKey(edge))
          if (const int now = imageOf(face); now > 0) beside.insert(now);
        for (const int fillet : generatedBy(edge))
          touched_[fillet].insert(beside.begin(), beside.end());
        beside_any_.merge(beside);
      }
    for (const auto& [fillet, beside] : touched_) patches_.erase(fillet);
  }

  bool touches(int fillet, int face) const {
    const auto named = touched_.find(fillet);
    return (named == touched_.end() ? beside_any_ : named->second).count(face) != 0;
  }

  /// Nothing for seams that were there before, and for the far ends of fillets.
  std::optional<CornerSeamKind> kindOf(const Seam& seam) const {
    const std::array<int, 2> sides = {seam.sides[0].face, seam.sides[1].face};
    if (sides[0] == sides[1]) return std::nullopt;
    const auto count = [&sides](const std::set<int>& faces) {
      return faces.count(sides[0]) + faces.count(sides[1]);
    };
    const std::size_t given = count(given_), patches = count(patches_);
    if (given == 2) return std::nullopt;
    if (patches == 2) return CornerSeamKind::Spoke;
    if (patches == 1) return given == 1 ? CornerSeamKind::Spring : CornerSeamKind::Section;
    if (given == 0) return CornerSeamKind::Fillets;
    const std::size_t face = given_.count(sides[0]) != 0 ? 0 : 1;
    if (touches(sides[1 - face], sides[face])) return CornerSeamKind::Contact;
    return std::nullopt;
  }

  const Corner& corner_;
  BRepFilletAPI_MakeFillet fillets_;
  RepairedSolid made_;
  TopTools_IndexedMapOfShape faces_;  ///< of the result; the sets have their numbers
  std::set<int> given_, patches_, beside_any_;
  std::map<int, std::set<int>> touched_;  ///< faces beside its edges, by fillet
};

std::vector<CornerFilletEdge> describedEdges(const Corner& corner,
                                             const std::vector<CornerStrip>& strips) {
  std::vector<CornerFilletEdge> edges;
  for (std::size_t i = 0; i < corner.count(); ++i) {
    const CornerEdge& edge = corner.edges[i];
    edges.push_back(
        {edge.number, edge.convex, edge.opening_rad, strips[i].radius_mm, strips[i].contact_mm});
  }
  return edges;
}

}  // namespace

RoundedCorner openCascadeCorner(const Corner& given, const CornerFilletOptions& options) {
  const std::pair<Corner, bool> alone = ofShellAlone(given);
  const std::vector<CornerStrip> strips = cornerStrips(alone.first, options);
  // A tenth of the default tolerances makes smoother seams; the default ones succeed more often.
  constexpr std::array<FilletParams, 2> params = {
      {{1e-3, 1e-5, 1e-6, 1e-5, 1e-6, 1e-4}, {1e-2, 1e-4, 1e-5, 1e-4, 1e-5, 1e-3}}};
  CornerReason reason;
  for (const FilletParams& with : params) {
    try {
      RoundedCorner made;
      made.shell = WholeFillet(alone.first, strips, with).shell();
      made.edges = describedEdges(alone.first, strips);
      made.filler = CornerFiller::OpenCascade;
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
