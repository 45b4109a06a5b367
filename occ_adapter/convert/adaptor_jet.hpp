// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Adaptor3d_Surface.hxx>

#include <seamwright/core/differential/jet.hpp>

namespace seamwright::occ {

/// Point and derivatives up to the second order, by OpenCASCADE. Not a public header.
SurfaceJet jetOn(const Adaptor3d_Surface& surface, double u, double v);

}  // namespace seamwright::occ
