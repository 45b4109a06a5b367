// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/model/usable.hpp>
#include <seamwright/occ_adapter/repair/change.hpp>
#include <seamwright/occ_adapter/repair/choose.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/repair_reason.hpp>

/// The task of a repair. Not a public header.
namespace seamwright::occ {

/// The seams that have to meet and the figures that have to stay.
struct RepairTask {
  const TopoDS_Shape& shape;
  const std::vector<Seam>& seams;  ///< of the shape, in the order of the report before
  /// By seam: figures in the given model, or at its repair; no seam may get worse than these.
  const std::vector<SeamResult>& to_keep;
  const std::vector<SeamResult>& before;  ///< figures in the shape
  const std::vector<FaceChoice>& faces;   ///< from 1
  const std::vector<bool>& sharp;         ///< by seam, see Choice
  const RepairOptions& options;
  /// Parts of the shape that can't be computed with; their faces stay in every task.
  const UnusableParts& unusable;
  const NeededVariation& needed;          ///< by face
  const MoveLimits& limits_mm;            ///< of the faces beside treated seams
  const TopoDS_Shape& given;              ///< the shape before any move; fairness compares with it
  const std::map<int, double>& moved_mm;  ///< by face that moved before: its move so far
  /// By seam: 0: not treated, it may not become worse; 1: it is to reach G1, or G0 if it is sharp;
  /// 2: it is to reach G2.
  std::vector<int> orders;
  bool neighbours_help = false;  ///< faces at the ends of treated seams move too

  bool isTreated(std::size_t seam) const { return orders[seam] > 0; }
  bool treatsAny() const {
    return std::ranges::any_of(orders, [](int order) { return order > 0; });
  }
};

/// Turns of the tangent planes at the ends of treated seams. Other seams can't keep their angle
/// there.
class TurnsAtEnds {
 public:
  explicit TurnsAtEnds(const RepairTask& task);

  /// The largest angle of a treated seam that ends at an end of this seam.
  double at_rad(const Seam& seam) const;

 private:
  TopTools_IndexedMapOfShape vertices_;
  std::map<int, double> turns_rad_;  ///< by number of the vertex
};

/// The faces of a shape around its vertices.
class FacesAtVertices {
 public:
  explicit FacesAtVertices(const TopoDS_Shape& shape);

  /// The faces at the ends of the seam, and its own faces.
  std::set<int> of(const Seam& seam) const;

 private:
  TopTools_IndexedMapOfShape faces_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_vertex_;
};

/// Whether the seam is a crease, or a defect that may be a crease with a gap. Its faces keep their
/// angle, whatever it is.
bool isFold(const SeamResult& seam, const ContinuityTolerance& tolerance);

/// Whether every difference of curvature is within the tolerance, because relativeDifference() is
/// at most 2. Then G2 is the same as G1.
inline bool anyCurvatureDoes(const ContinuityTolerance& tolerance) {
  return tolerance.curvature_rel >= 2;
}

/// By seam: why it is left as it was.
using Reasons = std::map<std::size_t, RepairReason>;

/// The same seams in a shape that withChanges() made from theirs.
std::vector<Seam> seamsIn(const TopoDS_Shape& shape, std::vector<Seam> seams);

/// New pcurves for edges, and the treated seams for which none was found.
struct JoinedPaths {
  std::vector<PathChange> paths;
  Reasons failures;
};

/// Gives new pcurves to the edges of treated seams whose gap alone is too large and whose surfaces
/// meet near the edge. The new pcurves have the same ends and images that run together, along the
/// image of one old pcurve or along the intersection of the surfaces. No surface moves. (Pcurves
/// that stray are mostly approximations of exact curves in files of other programs.)
/// \throws Cancelled.
JoinedPaths joinPaths(const RepairTask& task, const Progress& progress);

}  // namespace seamwright::occ
