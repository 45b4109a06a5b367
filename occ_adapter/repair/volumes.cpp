// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/repair/volumes.hpp>

namespace seamwright::occ {

namespace {

/// Whether the pcurve is straight along u. The quadrature, which sweeps in u, gets nothing from
/// such an edge.
bool runsAlongU(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first = 0, last = 0;
  const auto path = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (path.IsNull()) return false;
  const Geom2dAdaptor_Curve curve(path, first, last);
  return curve.GetType() == GeomAbs_Line && curve.Line().Direction().Y() == 0;
}

/// The face with only those edges that contribute to the quadrature over it, which would waste
/// evaluations on the others. Not thread-safe: edges, even those shared with other faces, are
/// marked as parts of the new wire.
TopoDS_Face sweptPart(const TopoDS_Shape& whole) {
  const BRep_Builder builder;
  const TopoDS_Face face = TopoDS::Face(whole.Oriented(TopAbs_FORWARD));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
    if (const TopoDS_Edge edge = TopoDS::Edge(edges.Current()); !runsAlongU(edge, face))
      builder.Add(wire, edge);
  TopoDS_Face part = TopoDS::Face(face.EmptyCopied());
  builder.Add(part, wire);
  return part;
}

/// A face, whole and reduced to the edges that the quadrature needs.
struct SweptFace {
  explicit SweptFace(const TopoDS_Shape& face) : whole(face), part(sweptPart(face)) {}
  TopoDS_Shape whole;
  TopoDS_Face part;
};

/// Volume of the cone over a face with that apex. (BRepGProp::VolumeProperties chooses its own
/// apex, near the face.)
/// \param error relative error of adaptive quadrature; 0: fixed quadrature, whose error may be a
/// percent for rational faces.
double cone_mm3(const SweptFace& face, const gp_Pnt& tip, double error) {
  BRepGProp_Face surface;
  surface.Load(TopoDS::Face(face.whole));
  BRepGProp_Domain bounds(face.part);
  BRepGProp_Vinert cone;
  cone.SetLocation(tip);
  if (error > 0)
    cone.Perform(surface, bounds, error);
  else
    cone.Perform(surface, bounds);
  return cone.Mass();
}

double area_mm2(const TopoDS_Shape& face) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties);
  return properties.Mass();
}

/// The contribution of a face to the volume of its solid.
struct FaceCone {
  SweptFace was, is;
  gp_Pnt tip;
  double move_mm = 0;
  double before_mm3 = 0, change_mm3 = 0;
  std::exception_ptr failure = {};

  void integrate(double error) {
    try {
      before_mm3 = cone_mm3(was, tip, error);
      change_mm3 = cone_mm3(is, tip, error) - before_mm3;
    } catch (...) {
      failure = std::current_exception();
    }
  }
};

/// The cones over the moved faces of a solid, with one apex.
std::vector<FaceCone> conesOf(const TopoDS_Shape& before, const TopoDS_Shape& after,
                              const TopTools_IndexedMapOfShape& faces,
                              const std::vector<FaceChange>& changes, const gp_Pnt& tip) {
  std::vector<FaceCone> cones;
  TopExp_Explorer was(before, TopAbs_FACE), is(after, TopAbs_FACE);
  for (; was.More(); was.Next(), is.Next()) {
    const auto move = std::ranges::find(changes, faces.FindIndex(was.Current()), &FaceChange::face);
    if (move != changes.end())
      cones.push_back(
          {SweptFace(was.Current()), SweptFace(is.Current()), tip, move->largest_move_mm});
  }
  return cones;
}

/// The volume that may be missing between cones: the gaps of the seams, before and after.
double slits_mm3(const RepairTask& task, const std::vector<SeamResult>& after, double reach_mm) {
  double area_mm2 = 0;
  for (std::size_t i = 0; i < after.size(); ++i)
    for (const SeamResult* seam : {&task.before[i], &after[i]})
      if (const auto& gap = seam->figures.gap_mm)
        area_mm2 += seam->length_mm * gap->upper.value_or(gap->lower);
  return area_mm2 * reach_mm / 3;
}

struct VolumeChange {
  double change_mm3 = 0, noise_mm3 = 0;

  bool isWithin(double explained_mm3) const {
    return std::abs(change_mm3) <= explained_mm3 + noise_mm3;
  }
};

VolumeChange volumeChange(std::vector<FaceCone>& cones, double error, int jobs,
                          const Progress& progress) {
  runParallel(
      cones.size(), jobs, [&cones, error](std::size_t k) { cones[k].integrate(error); }, progress);
  // Relative error of a volume by fixed quadrature that is accepted as noise.
  constexpr double noise = 1e-6;
  VolumeChange result;
  for (const FaceCone& cone : cones) {
    if (cone.failure) std::rethrow_exception(cone.failure);
    result.change_mm3 += cone.change_mm3;
    result.noise_mm3 += std::max(noise, error) * std::abs(cone.before_mm3);
  }
  return result;
}

/// The change of volume that the moves of points may cause. Areas are costly, so the longest moves
/// come first, and the sum ends once it suffices.
double explainedByMoves_mm3(std::vector<FaceCone> cones, double least_mm3) {
  std::ranges::sort(cones, std::greater{}, &FaceCone::move_mm);
  double explained_mm3 = 0;
  for (const FaceCone& cone : cones) {
    // A hundredth more, as the area is that of the old face and the new one may be a little larger.
    explained_mm3 += 1.01 * area_mm2(cone.was.whole) * cone.move_mm;
    if (explained_mm3 >= least_mm3) break;
  }
  return explained_mm3;
}

/// Unusable faces have no box, and they do not move.
Bnd_Box boxOfUsableFaces(const TopoDS_Shape& solid) {
  const TopTools_IndexedMapOfShape faces = partsOf(solid, TopAbs_FACE);
  const UnusableParts unusable(solid);
  Bnd_Box box;
  for (int f = 1; f <= faces.Extent(); ++f)
    if (unusable.whyLeftOut(f).empty()) BRepBndLib::Add(faces(f), box, false);
  return box;
}

}  // namespace

// Faces that stay contribute the same before and after, so only moved faces are integrated.
// Adaptive quadrature is slow and is used only where the fixed one does not suffice.
RepairReason whyNotVolumes(const RepairTask& task, const std::vector<FaceChange>& changes,
                           const TopoDS_Shape& changed, const std::vector<SeamResult>& after,
                           const Progress& progress) {
  // Relative. A choice: far below the percent by which the fixed quadrature may be off, and not so
  // small that the slow quadrature becomes slower still.
  constexpr double adaptive_error = 1e-5;
  const TopTools_IndexedMapOfShape solids = partsOf(task.shape, TopAbs_SOLID);
  const TopTools_IndexedMapOfShape solids_after = partsOf(changed, TopAbs_SOLID);
  const TopTools_IndexedMapOfShape faces = partsOf(task.shape, TopAbs_FACE);
  for (int s = 1; s <= solids.Extent(); ++s) {
    const Bnd_Box box = boxOfUsableFaces(solids(s));
    if (box.IsVoid()) continue;
    const double reach_mm = std::sqrt(box.SquareExtent()) / 2;
    const gp_Pnt tip((box.CornerMin().XYZ() + box.CornerMax().XYZ()) / 2);
    const double slits = slits_mm3(task, after, reach_mm);
    std::vector<FaceCone> cones = conesOf(solids(s), solids_after(s), faces, changes, tip);
    VolumeChange volume = volumeChange(cones, 0, task.options.jobs, progress);
    if (volume.isWithin(slits)) continue;
    const double explained = slits + explainedByMoves_mm3(cones, std::abs(volume.change_mm3));
    if (!volume.isWithin(explained))
      volume = volumeChange(cones, adaptive_error, task.options.jobs, progress);
    if (volume.isWithin(explained)) continue;
    return why::volumeChanges(s, volume.change_mm3, explained - slits);
  }
  return {};
}

}  // namespace seamwright::occ
