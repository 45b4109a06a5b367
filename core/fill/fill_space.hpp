// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fill/fill_fields.hpp>

/// The space of all fills of a hole with exact joins; not a public header.
namespace seamwright::fill {

/// The poles of all patches as affine functions of unknown points: poles = coefficients * unknowns
/// + constants, with unknowns #U by 3.
struct FillSpace {
  int patches = 0;
  int degree = 0;
  Eigen::MatrixXd coefficients;  ///< #P by #U
  Poles constants;               ///< #P by 3
  /// Index of the unknown that is the centre; the two unknowns after it span the tangents of the
  /// spokes. Nothing: they are no unknowns.
  std::optional<Eigen::Index> centre = 0;
  Poles middles;  ///< middles of the sides, where the spokes end

  Eigen::Index row(int patch, int i, int j) const {
    return (static_cast<Eigen::Index>(patch) * (degree + 1) + i) * (degree + 1) + j;
  }
};

/// Source: docs/theory/fills.md F2.4 to F2.6.
FillSpace fillSpace(const std::vector<FillSide>& sides, const CrossBoundaryDerivatives& fields,
                    SpokeLaw law, int degree);

/// Poles of neighbours along a spoke are bitwise the same.
std::vector<BezierPatch> patchesOf(const FillSpace& space, const Poles& unknowns);

}  // namespace seamwright::fill
