// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/plugin/python/fairness.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

py::object curveFairnessResult(const CurveFairness& fairness) {
  py::dict dict;
  dict["energy"] = fairness.energy;
  dict["extrema"] = fairness.extrema;
  dict["extrema_at_knots"] = fairness.extrema_at_knots;
  dict["inflections"] = fairness.inflections;
  dict["undecided_spans"] = fairness.undecided_spans;
  return resultOf("CurveFairness", dict);
}

py::object curvatureVariationResult(const CurvatureVariation& variation) {
  py::dict dict;
  dict["energy_per_mm3"] = variation.energy_per_mm3;
  dict["extrema"] = variation.extrema;
  dict["extrema_at_joints"] = variation.extrema_at_joints;
  dict["inflections"] = variation.inflections;
  dict["undecided_segments"] = variation.undecided_segments;
  return resultOf("CurvatureVariation", dict);
}

}  // namespace seamwright::python
