// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <seamwright/core/seam/measure.hpp>
#include <seamwright/plugin/python/bindings.hpp>

namespace py = pybind11;

namespace seamwright::python {

namespace {

Eigen::Vector3d normalOf(const SurfaceJet& jet) {
  if (const auto normal = unitNormal(jet)) return *normal;
  throw py::value_error("the jet has no tangent plane: " + std::string(name(degeneracy(jet))));
}

py::dict measure(const SurfaceJet& a, const SurfaceJet& b) {
  const PairMeasure pair = measurePair({a, {}}, {b, {}});
  py::dict result;
  result["gap_mm"] = pair.gap_mm;
  result["angle_rad"] = pair.angle_rad;
  const auto value = [&](double CurvatureDifference::*member) {
    return pair.curvature ? py::cast((*pair.curvature).*member) : py::none();
  };
  result["curvature_per_mm"] = value(&CurvatureDifference::difference_per_mm);
  result["norm_a_per_mm"] = value(&CurvatureDifference::norm_a_per_mm);
  result["norm_b_per_mm"] = value(&CurvatureDifference::norm_b_per_mm);
  result["degenerate_a"] = name(pair.degenerate_a);
  result["degenerate_b"] = name(pair.degenerate_b);
  return result;
}

}  // namespace

void bindMeasure(py::module_& module) {
  module.def("measure_pair", &measure, py::arg("a"), py::arg("b"),
             "Gap, angle of the tangent planes (0..pi/2) and curvature difference of two surface jets, as a "
             "dict; None "
             "where a side has no tangent plane, which degenerate_a and degenerate_b then name.");
  module.def(
      "curvature_tensor", [](const SurfaceJet& jet) { return curvatureTensor(jet, normalOf(jet)); },
      py::arg("jet"),
      "The curvature tensor (3, 3) in 1/mm: d.W d is the normal curvature in the unit tangent direction d.");
  module.def(
      "principal_curvatures",
      [](const SurfaceJet& jet) {
        const PrincipalCurvatures k = principalCurvatures(jet, normalOf(jet));
        return py::make_tuple(k.k1, k.k2, k.direction1, k.direction2);
      },
      py::arg("jet"), "(k1, k2, direction1, direction2) with k1 >= k2, in 1/mm.");
}

}  // namespace seamwright::python
