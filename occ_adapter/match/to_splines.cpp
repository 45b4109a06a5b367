// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include <seamwright/occ_adapter/convert/polynomial_surface.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/convert/surface_kind.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/match/to_splines.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>

namespace seamwright::occ {

bool hasPoles(const TopoDS_Face& face) {
  TopLoc_Location location;
  const auto surface = BRep_Tool::Surface(face, location);
  return !clampedSpline(surface, location).IsNull();
}

ConvertedModel withSplines(const TopoDS_Shape& model, const std::vector<int>& faces,
                           double gap_mm) {
  const TopTools_IndexedMapOfShape all = partsOf(model, TopAbs_FACE);
  ConvertedModel converted{model, {}};
  std::vector<FaceChange> changes;
  for (const int number : faces) {
    const TopoDS_Face face = TopoDS::Face(all(number));
    if (hasPoles(face)) continue;
    // withChanges() takes a move of less than a thousandth of the gap for none.
    const PolynomialSurface spline = polynomialSurface(face, gap_mm / 1000);
    changes.push_back({number, opencascade::handle<Geom_Surface>(spline.surface), spline.error_mm});
    match_why::add(converted.remarks,
                   match_why::faceConverted(number, kindOf(face), spline.error_mm));
  }
  if (!changes.empty()) converted.shape = withChanges(model, changes, gap_mm);
  return converted;
}

}  // namespace seamwright::occ
