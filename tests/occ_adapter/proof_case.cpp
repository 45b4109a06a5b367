// SPDX-License-Identifier: LGPL-2.1-or-later
#include "proof_case.hpp"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>

#include "grids.hpp"

#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::test {

namespace {

Spline surfaceOf(const Strip& strip, std::size_t number) {
  constexpr double width = 20, half = 15, across_per_mm = 0.01;
  const double x0 = width * static_cast<double>(number - 1),
               rise = width * std::tan(strip.kink) / 5;
  // Bezier ordinates over x, which end with three noughts, and over y those of a parabola.
  const std::array<double, 6> of_x = {
      strip.step_mm,
      strip.step_mm + rise,
      strip.step_mm + 2 * rise + strip.bend_per_mm * width * width / 20,
      0,
      0,
      0};
  const double arch = across_per_mm * half * half / 2;
  const std::array<double, 3> y = {-half, 0, half}, of_y = {arch, -arch, arch};
  TColgp_Array2OfPnt poles(1, 6, 1, 3);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 3; ++j)
      poles(i + 1, j + 1) = gp_Pnt(x0 + width * i / 5, y[j], of_x[i] + of_y[j]);
  return splineOf(poles, 5, 2);
}

std::vector<Spline> surfacesOf(const std::vector<Strip>& strips) {
  std::vector<Spline> surfaces;
  for (std::size_t k = 0; k < strips.size(); ++k) surfaces.push_back(surfaceOf(strips[k], k + 1));
  return surfaces;
}

std::set<int> allFaces(const TopoDS_Shape& shape) {
  std::set<int> faces;
  for (int face = 1; face <= partsOf(shape, TopAbs_FACE).Extent(); ++face) faces.insert(face);
  return faces;
}

}  // namespace

TopoDS_Shape chain(const std::vector<Strip>& strips, double tolerance_mm) {
  Patches patches;
  for (const Spline& surface : surfacesOf(strips)) patches.push_back({surface});
  return gridOf(patches, tolerance_mm);
}

TopoDS_Shape looseChain(const std::vector<Strip>& strips) {
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const Spline& surface : surfacesOf(strips)) builder.Add(compound, wholeFace(surface));
  return compound;
}

ProofCase::ProofCase(const TopoDS_Shape& shape, const occ::RepairOptions& options)
    : shape_(shape), options_(options), unusable_(shape) {
  const occ::Model model = occ::modelFromShape(shape);
  report_ = occ::analyze(model, occ::analyzeOptions(options));
  occ::SeamGraph graph = occ::findSeams(shape);
  if (options.match_mm > 0)
    occ::matchFreeEdges({.match_mm = options.match_mm, .gap_mm = options.tolerance.gap_mm}, graph,
                        {});
  seams_ = std::move(graph.seams);
  choice_ = occ::choose(model, report_, options);
  needed_ = occ::neededVariation(shape, report_.seams, choice_.treated);
  limits_mm_ = occ::moveLimits(shape, report_.seams, allFaces(shape), choice_.treated, options);
}

occ::RepairTask ProofCase::task() const {
  std::vector<int> orders;
  for (const bool is_treated : choice_.treated) orders.push_back(is_treated ? options_.order : 0);
  return {.shape = shape_,
          .seams = seams_,
          .to_keep = report_.seams,
          .before = report_.seams,
          .faces = choice_.faces,
          .sharp = choice_.sharp,
          .options = options_,
          .unusable = unusable_,
          .needed = needed_,
          .limits_mm = limits_mm_,
          .given = shape_,
          .moved_mm = moved_,
          .orders = std::move(orders)};
}

occ::FaceChange ProofCase::changed(int number, const Strip& strip) const {
  const Spline after = surfaceOf(strip, static_cast<std::size_t>(number));
  const Spline before = Spline::DownCast(BRep_Tool::Surface(face(shape_, number)));
  double largest_mm = 0;
  for (int i = 1; i <= after->NbUPoles(); ++i)
    for (int j = 1; j <= after->NbVPoles(); ++j)
      largest_mm = std::max(largest_mm, after->Pole(i, j).Distance(before->Pole(i, j)));
  return {number, handle<Geom_Surface>(after), largest_mm};
}

TopoDS_Shape ProofCase::withChanges(const std::vector<occ::FaceChange>& changes) const {
  return occ::withChanges(shape_, changes, options_.tolerance.gap_mm);
}

occ::Proof ProofCase::proofOf(const std::vector<occ::FaceChange>& changes) const {
  return proofOf(task(), changes);
}

occ::Proof ProofCase::proofOf(const occ::RepairTask& task,
                              const std::vector<occ::FaceChange>& changes,
                              occ::MeasuredSeams* known) const {
  occ::MeasuredSeams none;
  return occ::prove(task, changes, withChanges(changes), known ? *known : none, {});
}

occ::Proof ProofCase::proofOf(const occ::RepairTask& task,
                              const std::vector<occ::FaceChange>& changes,
                              const TopoDS_Shape& changed) const {
  occ::MeasuredSeams none;
  return occ::prove(task, changes, changed, none, {});
}

std::string textOf(const occ::Proof& proof) {
  std::string text;
  for (const auto& [seam, why] : proof.unrepaired)
    text += "unrepaired " + std::to_string(seam) + ": " + why.text + "\n";
  for (const auto& [seam, why] : proof.worse)
    text += "worse " + std::to_string(seam) + ": " + why.text + "\n";
  for (const auto& [face, why] : proof.faces)
    text += "face " + std::to_string(face) + ": " + why.text + "\n";
  return text + proof.whole.text;
}

}  // namespace seamwright::test
