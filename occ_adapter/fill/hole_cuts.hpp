// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/fill/filling.hpp>
#include <seamwright/occ_adapter/fill/side_cut.hpp>
#include <seamwright/occ_adapter/fill/side_fit.hpp>

/// Stage 1 of a fill: the sides of a hole as polynomials. Not a public header.
namespace seamwright::occ {

/// A cut of the hole into sides, and the polynomials fitted to them.
struct HoleCut {
  std::vector<SideInterval> intervals;
  std::vector<FittedSide> sides;
  double misses = 0;  ///< largest ratio of an error of the sides to the accepted one

  std::vector<FillSide> fillSides() const;
};

struct HoleCuts {
  bool is_ring = false;       ///< the hole is filled by a ring of patches around one in its middle
  std::vector<HoleCut> cuts;  ///< at least one, in the order in which they are to be tried
};

/// \throws NotFilled for corners that no fill has, std::invalid_argument and std::domain_error for
/// sides that can't be fitted, Standard_Failure.
HoleCuts cutsOf(const FillTask& task, const FillAttempt& attempt);

/// The sides for the report.
std::vector<FilledSide> filledSides(const Hole& hole, const HoleCut& cut);

/// The causes of too large a distance between the sides and the hole; empty if it is small enough.
std::vector<FillReason> causesOfDistance(const FillTask& task, const HoleCut& cut);

}  // namespace seamwright::occ
