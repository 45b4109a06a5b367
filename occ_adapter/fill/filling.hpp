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

/// The reason that prevents a hole from being filled.
class NotFilled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The text of a failure of OpenCASCADE, with the operation that failed.
std::string failureText(const std::string& doing, const Standard_Failure& failure);

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
FillHoleReport filledByPatches(const Model& model, const Hole& hole, const FillHoleOptions& options,
                               const FaceNames& names, const FillAttempt& attempt,
                               const Progress& progress);

/// Fills the hole with a given face, which is regular and bounded by copies of the hole's edges.
FillHoleReport filledByFace(const Model& model, const Hole& hole, const FillHoleOptions& options,
                            const FaceNames& names, const TopoDS_Face& face,
                            const Progress& progress);

}  // namespace seamwright::occ
