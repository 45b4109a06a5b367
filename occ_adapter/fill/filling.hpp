// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <TopoDS_Face.hxx>
#include <optional>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

/// Makes one attempt to fill a hole. Not a public header.
namespace seamwright::occ {

/// A hole is not filled, for a reason.
class NotFilled : public std::runtime_error {
 public:
  explicit NotFilled(FillReason reason)
      : std::runtime_error(textOf(reason)), reason_(std::move(reason)) {}
  const FillReason& reason() const { return reason_; }

 private:
  FillReason reason_;
};

/// \throws std::invalid_argument for options that are invalid, also for this model.
void requireOptions(const Model& model, const FillHoleOptions& options);

/// \throws std::invalid_argument for no faces, unknown faces, and a face that is given twice.
void requireRemovable(const Model& model, const std::vector<int>& faces);

/// The reason for a failure of OpenCASCADE, with the operation that failed.
FillReason reasonOf(const std::string& doing, const Standard_Failure& failure);

/// The errors of the sides and of the corners may each be the tolerance over this number, so that
/// the sum of all errors is well within the tolerance.
inline constexpr double fit_share = 20;

/// If tangents at a corner leave a side's tangent plane by more than this, no smooth surface
/// contains both: the side has position only.
inline constexpr double most_planar_rad = 0.1;

/// A fill, the hole and what is asked for. All is kept by reference.
struct FillTask {
  const Model& model;
  const Hole& hole;
  const FillHoleOptions& options;
  const FaceNames& names;

  int firstNewFace() const { return model.faceCount() + 1; }
  /// Whether the number is one of a new face, in the shape before sewing.
  bool isNew(int face) const { return face >= firstNewFace(); }
  std::string nameOf(int face) const { return isNew(face) ? "the fill" : names(face); }
};

/// Parameters of an attempt.
struct FillAttempt {
  int most_degree = 9;  ///< largest degree of the polynomials fitted to the sides
  /// The freedom that G1 leaves minimises the jumps of curvature, in a degree that is higher by at
  /// most this number. Nothing: the freedom goes into fairness.
  std::optional<int> curvature_raise = std::nullopt;
};

/// Whether the new faces are regular, sewn, and within their size limit: at most three times the
/// size of the hole.
bool isSound(const FillHoleReport& report);

/// Fills the hole with new patches.
FillHoleReport filledByPatches(const FillTask& task, const FillAttempt& attempt,
                               const Progress& progress);

/// Fills the hole with a given face, which is regular and bounded by copies of the hole's edges.
FillHoleReport filledByFace(const FillTask& task, const TopoDS_Face& face,
                            const Progress& progress);

/// Fills the hole with one face on a spline graph, if graphFace() makes one.
std::optional<FillHoleReport> filledByGraph(const FillTask& task, const Progress& progress);

/// Fills the hole with one face on a spline between four sides, if SheetFaces has one. Finer ones
/// are made until one reaches the target.
std::optional<FillHoleReport> filledBySheet(const FillTask& task, const Progress& progress);

}  // namespace seamwright::occ
