// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fairness.hpp"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <GeomLProp_SLProps.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "shapes.hpp"

namespace seamwright::test {

double variationByOpenCascade(const TopoDS_Face& face,
                              const opencascade::handle<Geom_Surface>& surface) {
  constexpr int lines = 40, samples = 400;
  double first_u = 0, last_u = 0, first_v = 0, last_v = 0;
  BRepTools::UVBounds(face, first_u, last_u, first_v, last_v);
  BRepTopAdaptor_FClass2d inside(face, 1e-9);
  double sum = 0;
  int count = 0;
  for (const bool along_u : {true, false})
    for (int line = 0; line < lines; ++line) {
      double total = 0, before = 0;
      int seen = 0;
      for (int k = 0; k < samples; ++k) {
        const double along = (k + 0.5) / samples, across = (line + 0.5) / lines;
        const double u = first_u + (last_u - first_u) * (along_u ? along : across);
        const double v = first_v + (last_v - first_v) * (along_u ? across : along);
        if (inside.Perform(gp_Pnt2d(u, v)) != TopAbs_IN) continue;
        const double mean = GeomLProp_SLProps(surface, u, v, 2, 1e-12).MeanCurvature();
        if (seen++ > 0) total += std::abs(mean - before);
        before = mean;
      }
      if (seen < 2) continue;
      sum += total;
      ++count;
    }
  return sum / count;
}

namespace {

double diagonal_mm(const TopoDS_Face& face) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(face, box, false, false);
  return box.CornerMin().Distance(box.CornerMax());
}

/// The largest angle over width of the treated seams of a face.
double neededTurn_per_mm(int number, const TopoDS_Face& face, const occ::RepairReport& report) {
  GProp_GProps area;
  BRepGProp::SurfaceProperties(face, area);
  double largest = 0;
  for (const occ::SeamRepair& seam : report.seams) {
    const auto& [a, b] = seam.before.faces;
    if (!seam.treated || (a != number && b != number) || !seam.before.figures.angle_rad) continue;
    const double width_mm = std::min(diagonal_mm(face), area.Mass() / seam.before.length_mm);
    largest = std::max(largest, upper(seam.before.figures.angle_rad) / width_mm);
  }
  return largest;
}

}  // namespace

std::vector<FaceFairness> fairnessOfChanges(const TopoDS_Shape& before,
                                            const occ::RepairReport& report,
                                            const ContinuityTolerance& tolerance) {
  constexpr double times = 1.5;
  const TopTools_IndexedMapOfShape was = partsOf(before, TopAbs_FACE),
                                   is = partsOf(report.model.shape, TopAbs_FACE);
  std::vector<FaceFairness> faces;
  for (int f = 1; f <= was.Extent(); ++f) {
    const TopoDS_Face &old_face = TopoDS::Face(was(f)), &new_face = TopoDS::Face(is(f));
    const auto old_surface = BRep_Tool::Surface(old_face),
               new_surface = BRep_Tool::Surface(new_face);
    if (old_surface == new_surface) continue;
    FaceFairness face{f, variationByOpenCascade(old_face, old_surface),
                      variationByOpenCascade(new_face, new_surface), 0};
    face.limit_per_mm = times * face.before_per_mm +
                        3 * tolerance.angle_rad / diagonal_mm(old_face) +
                        3 * neededTurn_per_mm(f, old_face, report);
    faces.push_back(face);
  }
  return faces;
}

}  // namespace seamwright::test
