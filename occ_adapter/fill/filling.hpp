// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <TopoDS_Face.hxx>
#include <optional>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

/// One attempt to fill a hole; not a public header.
namespace seamwright::occ {

/// What keeps a hole from being filled.
class NotFilled : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What OpenCASCADE says of a failure, with what was done.
std::string failureText(const std::string& doing, const Standard_Failure& failure);

/// How a fill is tried.
struct FillAttempt {
  int most_degree = 9;  ///< of the polynomials that stand for the sides
  /// What G1 leaves free is spent on small jumps of curvature, in a degree higher by so much at
  /// most; nothing: on fairness.
  std::optional<int> curvature_raise = std::nullopt;
};

/// The new faces are regular, and no larger than befits the hole.
bool isSound(const FillHoleReport& report);

/// The hole with patches built for it.
FillHoleReport filledByPatches(const Model& model, const Hole& hole, const FillHoleOptions& options,
                               const FaceNames& names, const FillAttempt& attempt,
                               const Progress& progress);

/// The hole with a face that is there already, regular, and bounded by copies of the hole's edges.
FillHoleReport filledByFace(const Model& model, const Hole& hole, const FillHoleOptions& options,
                            const FaceNames& names, const TopoDS_Face& face,
                            const Progress& progress);

}  // namespace seamwright::occ
