// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/planar/fairing_run.hpp>

/// Not a public header.
namespace seamwright {

/// The least variation with the curve on the side to which the circles through three points turn,
/// then fewer inflections and extrema at up to twice that variation.
/// \param now the run with fair points.
/// \param most_variation_per_mm3 what fewer turns may cost at most; infinite if nothing is known.
FairingSearch fewerTurns(const FairingRun& run, const RunFairing& fairing, FairingState now,
                         const PlanarPoints& fair_points, double most_variation_per_mm3);

}  // namespace seamwright
