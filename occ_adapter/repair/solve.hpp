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

/// What a repair has to do; not a public header.
namespace seamwright::occ {

/// What has to meet, and what has to stay as it is.
struct RepairTask {
  const TopoDS_Shape& shape;
  const std::vector<Seam>& seams;  ///< of the shape, in the order of the report before
  const std::vector<SeamResult>&
      to_keep;  ///< in the model given, or when repaired; none may get worse
  const std::vector<SeamResult>& before;  ///< in the shape
  const std::vector<FaceChoice>& faces;   ///< from 1
  const std::vector<bool>& sharp;         ///< by seam, see Choice
  const RepairOptions& options;
  const UnusableParts& unusable;          ///< of the shape, whatever moved: such faces stay
  const NeededVariation& needed;          ///< by face
  const MoveLimits& limits_mm;            ///< of the faces beside treated seams
  const TopoDS_Shape& given;              ///< the shape before any move, to which fairness compares
  const std::map<int, double>& moved_mm;  ///< by face that has moved before: by how much
  /// By seam: 0: not treated, it may not become worse; 1: it is to have G1, or, where it is sharp,
  /// to be closed; 2: G2.
  std::vector<int> orders;
  bool neighbours_help = false;  ///< faces that have an end of a treated seam move too

  bool isTreated(std::size_t seam) const { return orders[seam] > 0; }
  bool treatsAny() const {
    return std::ranges::any_of(orders, [](int order) { return order > 0; });
  }
};

/// By how much the tangent planes turn where treated seams end: there other seams can't keep their
/// angle.
class TurnsAtEnds {
 public:
  explicit TurnsAtEnds(const RepairTask& task);

  /// The largest angle of a treated seam that ends where this one does.
  double at_rad(const Seam& seam) const;

 private:
  TopTools_IndexedMapOfShape vertices_;
  std::map<int, double> turns_rad_;  ///< by number of the vertex
};

/// The faces of a shape around its vertices.
class FacesAtVertices {
 public:
  explicit FacesAtVertices(const TopoDS_Shape& shape);

  /// Those that have an end of the seam, and its own.
  std::set<int> of(const Seam& seam) const;

 private:
  TopTools_IndexedMapOfShape faces_;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_vertex_;
};

/// A crease, or a defect that may be one with a gap: its faces keep their angle, whatever it is.
bool isFold(const SeamResult& seam, const ContinuityTolerance& tolerance);

/// No difference of curvature is beyond the tolerance, as relativeDifference() is at most 2: G2 is
/// G1.
inline bool anyCurvatureDoes(const ContinuityTolerance& tolerance) {
  return tolerance.curvature_rel >= 2;
}

/// Why seams are left, by seam.
using Reasons = std::map<std::size_t, std::string>;

std::string whyFailed(const Standard_Failure& failure);

/// The same seams in a shape that withChanges() made of theirs.
std::vector<Seam> seamsIn(const TopoDS_Shape& shape, std::vector<Seam> seams);

/// Other paths for edges, and the treated seams that have none.
struct JoinedPaths {
  std::vector<PathChange> paths;
  Reasons failures;
};

/// Seams of which the gap alone is too large and the surfaces meet near the edge: its paths in the
/// parameter planes are made to run together, between the same ends, along the image of one of them
/// or where the surfaces cut one another. No surface moves. (Paths that stray are mostly
/// approximations of exact curves in files of other programs.)
/// \throws Cancelled.
JoinedPaths joinPaths(const RepairTask& task, const Progress& progress);

}  // namespace seamwright::occ
