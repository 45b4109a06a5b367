// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BoundedSurface.hxx>
#include <Precision.hxx>
#include <TopoDS_Face.hxx>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright::occ {

/// A face on the whole of a Bézier surface, or of a B-spline surface that is clamped and not
/// periodic. The face shares the surface. Its edges are the sides of the surface: curves with
/// their poles, weights and knots.
///
///   1. A side whose poles lie within \p tolerance_mm of its first one is a point: a degenerated
///      edge, with one vertex, which reaches to these poles.
///   2. Opposite sides with the same weights, whose poles lie within \p tolerance_mm of each other
///      in pairs, are one edge with two pcurves, whose tolerance is their distance.
///
/// Other tolerances are Precision::Confusion(), 1e-7.
/// \param tolerance_mm not negative.
/// \throws std::domain_error for a surface of another kind, with its name; std::invalid_argument as
/// requireArea().
TopoDS_Face naturalFace(const opencascade::handle<Geom_BoundedSurface>& surface,
                        double tolerance_mm = Precision::Confusion());

/// \throws std::invalid_argument if all poles lie within \p tolerance_mm of one line, with that
/// tolerance, so that a face with these poles has no area.
void requireArea(const Poles& poles, double tolerance_mm);

}  // namespace seamwright::occ
