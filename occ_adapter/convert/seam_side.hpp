// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/seam.hpp>

namespace seamwright::occ {

/// The side of a seam for enclosures: OpenCASCADE's numbers as values of core, exact except for the
/// rounding of locations.
///
/// Surfaces: planes, cylinders, cones, spheres, tori, Bezier and B-spline surfaces (rational,
/// periodic), surfaces of revolution and of extrusion, offsets of all these, trimmed or not. Curves
/// (pcurves, and the curves of revolution and extrusion): lines, circles, ellipses, hyperbolas,
/// parabolas, Bezier and B-spline curves, trimmed or not.
///
/// s runs with the pcurve over its whole range. The result is not thread-safe.
/// \throws std::domain_error if the surface or a curve is of another kind, with its name;
/// std::invalid_argument if a number is not finite.
SeamSide seamSide(const Coedge& use, const Pcurve& pcurve);

}  // namespace seamwright::occ
