// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepCheck_Analyzer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <map>
#include <set>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/fill/clearance.hpp>
#include <seamwright/occ_adapter/fill/corner_reasons.hpp>
#include <seamwright/occ_adapter/fill/corner_solid.hpp>
#include <seamwright/occ_adapter/fill/corner_verdict.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>

namespace seamwright::occ {

namespace {

AnalyzeOptions cornerAnalysis(const CornerFilletOptions& options) {
  AnalyzeOptions result;
  result.tolerance = options.tolerance;
  result.jobs = options.jobs;
  return result;
}

std::vector<CornerSeam> measured(const TopoDS_Shape& shape, const CornerShell& made,
                                 const CornerFilletOptions& options, const Progress& progress) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  std::map<int, CornerSeamKind> kinds;
  for (const auto& [edge, kind] : made.seams) kinds.emplace(edges.FindIndex(edge), kind);
  std::vector<Seam> found;
  for (const Seam& seam : findSeams(shape).seams)
    if (kinds.count(seam.edges.front()) != 0) found.push_back(seam);
  std::vector<CornerSeam> seams(found.size());
  const AnalyzeOptions asked = cornerAnalysis(options);
  runParallel(
      found.size(), options.jobs,
      [&](std::size_t k) {
        seams[k] = {kinds.at(found[k].edges.front()), measureSeam(found[k], asked)};
      },
      progress);
  return seams;
}

/// The face of the new shell that a given face is or became.
TopoDS_Shape imageOf(const TopoDS_Shape& given, const CornerShell& made) {
  return made.became.IsBound(given) ? made.became.Find(given) : given;
}

/// The attributes of faces and solids that are still there, with the new face numbers.
std::vector<ShapeAttribute> attributesAfter(const Model& model, const TopoDS_Shape& shape,
                                            const CornerShell& made) {
  TopTools_IndexedMapOfShape before, after;
  TopExp::MapShapes(model.shape, TopAbs_FACE, before);
  TopExp::MapShapes(shape, TopAbs_FACE, after);
  std::vector<ShapeAttribute> attributes;
  for (ShapeAttribute attribute : model.attributes) {
    if (attribute.kind == TopAbs_FACE) {
      const TopoDS_Shape& old = before(attribute.index);
      attribute.index = after.FindIndex(imageOf(old, made));
      if (attribute.index == 0) continue;
    } else if (attribute.kind > TopAbs_SHELL) {
      continue;
    }
    attributes.push_back(std::move(attribute));
  }
  return attributes;
}

/// Numbers of the fillets and patches: of the faces that no given face became.
std::set<int> freshFaces(const TopoDS_Shape& shape, const Corner& corner, const CornerShell& made) {
  TopTools_IndexedMapOfShape old;
  for (TopExp_Explorer face(corner.shell, TopAbs_FACE); face.More(); face.Next())
    old.Add(imageOf(face.Current(), made));
  const TopTools_IndexedMapOfShape all = partsOf(shape, TopAbs_FACE);
  std::set<int> fresh;
  for (TopExp_Explorer face(made.shell, TopAbs_FACE); face.More(); face.Next())
    if (!old.Contains(face.Current())) fresh.insert(all.FindIndex(face.Current()));
  return fresh;
}

/// The number that a face has in the given shape; 0 for a new face.
int givenNumber(const TopoDS_Shape& face, const Corner& corner, const CornerShell& made) {
  for (int f = 1; f <= corner.given_faces.Extent(); ++f)
    if (imageOf(corner.given_faces(f), made).IsSame(face)) return f;
  return 0;
}

/// That a new face runs into a face of the solid; empty if none does. Other solids of an assembly
/// do not count: they may touch the solid from the beginning.
CornerReason runsInto(const Corner& corner, const CornerShell& made) {
  const TopoDS_Shape solid = withShell(corner.solid, corner.shell, made.shell);
  const auto touching = touchingFaces(solid, freshFaces(solid, corner, made));
  if (!touching) return {};
  return corner_why::runsIntoFace(
      givenNumber(partsOf(solid, TopAbs_FACE)(touching->second), corner, made));
}

/// Why the result is not a valid rounded corner; empty if it is one.
CornerReason shortfallOf(const CornerFillet& result, const Corner& corner,
                         const CornerShell& made) {
  if (!result.valid) return corner_why::checksFail();
  if (result.filler == CornerFiller::Patches && !result.fill.regular) return corner_why::mayFold();
  if (CornerReason touching = runsInto(corner, made); !touching.empty()) return touching;
  const TopTools_IndexedMapOfShape faces = partsOf(result.model.shape, TopAbs_FACE);
  for (const CornerSeam& seam : result.seams) {
    if (seam.result.verdict.level >= Level::G1) continue;
    int face = 0;
    for (const int side : seam.result.faces)
      if (face == 0) face = givenNumber(faces(side), corner, made);
    return corner_why::missesTarget(seam.kind, face, figuresText(seam.result));
  }
  return {};
}

}  // namespace

CornerFillet judgedCorner(const Model& model, const Corner& corner, RoundedCorner made,
                          const CornerFilletOptions& options, const Progress& progress) {
  CornerFillet result;
  result.model = model;
  result.filler = made.filler;
  result.edges = std::move(made.edges);
  result.fill = std::move(made.fill);
  result.section_error_mm = made.section_error_mm;
  result.model.shape = withShell(model.shape, corner.shell, made.shell.shell);
  result.model.attributes = attributesAfter(model, result.model.shape, made.shell);
  const std::set<int> fresh = freshFaces(result.model.shape, corner, made.shell);
  result.faces.assign(fresh.begin(), fresh.end());
  result.seams = measured(result.model.shape, made.shell, options, progress);
  result.valid = BRepCheck_Analyzer(made.shell.shell).IsValid();
  result.shortfall = shortfallOf(result, corner, made.shell);
  return result;
}

}  // namespace seamwright::occ
