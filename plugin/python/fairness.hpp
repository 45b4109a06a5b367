// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fair/curvature_variation.hpp>
#include <seamwright/core/fair/fair_curve.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/planar.hpp>

/// What the bindings of fairing share.
namespace seamwright::python {

inline constexpr NamedValue<HeldEnds> held_ends[] = {{"nothing", HeldEnds::Nothing},
                                                     {"position", HeldEnds::Position},
                                                     {"tangent", HeldEnds::Tangent},
                                                     {"curvature", HeldEnds::Curvature}};

py::object curveFairnessResult(const CurveFairness& fairness);
py::object curvatureVariationResult(const CurvatureVariation& variation);

}  // namespace seamwright::python
