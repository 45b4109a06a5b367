// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <seamwright/core/bezier/surface_shape.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <vector>

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

SurfaceShape shapeOf(const py::object& patch, double u, double v) {
  if (py::isinstance<BezierTriangle>(patch))
    return surfaceShape(py::cast<const BezierTriangle&>(patch), u, v);
  if (py::isinstance<BezierPatch>(patch))
    return surfaceShape(py::cast<const BezierPatch&>(patch), u, v);
  throw py::type_error("patch is " + shown(patch) +
                       ": a BezierPatch or a BezierTriangle is needed");
}

/// The projection of \p value onto the tangent plane, normalised.
Eigen::Vector3d tangentDirection(const py::object& value, const Eigen::Vector3d& normal) {
  constexpr const char* kind = "a sequence of three numbers";
  const auto numbers = argument<std::vector<double>>("direction", value, kind);
  if (numbers.size() != 3)
    throw py::value_error("direction is " + shown(value) + ": " + kind + " is needed");
  const Eigen::Vector3d given =
      Eigen::Vector3d(numbers[0], numbers[1], numbers[2]).stableNormalized();
  const Eigen::Vector3d along = given - normal.dot(given) * normal;
  if (!(along.norm() > 1e-6))
    throw py::value_error("direction is " + shown(value) + ": it must not lie along the normal");
  return along.normalized();
}

py::dict shapeDict(const py::object& patch, const py::object& u, const py::object& v,
                   const py::object& direction) {
  const SurfaceShape shape =
      shapeOf(patch, argument<double>("u", u, "a number"), argument<double>("v", v, "a number"));
  py::dict dict;
  dict["degeneracy"] = name(shape.degeneracy);
  for (const char* key : {"normal", "normal_error_rad", "tensor", "tensor_error_per_mm",
                          "principal_curvatures_per_mm", "curvature_change_per_mm2",
                          "curvature_change_error_per_mm2"})
    dict[key] = py::none();
  if (shape.degeneracy != Degeneracy::None) return dict;
  dict["normal"] = shape.normal;
  dict["normal_error_rad"] = shape.normal_error_rad;
  dict["tensor"] = shape.tensor;
  dict["tensor_error_per_mm"] = shape.tensor_error_per_mm;
  const PrincipalCurvatures k = principalCurvatures(shape.jet, shape.normal);
  dict["principal_curvatures_per_mm"] = py::make_tuple(k.k1, k.k2);
  if (direction.is_none()) return dict;
  const BoundedChange change = curvatureChange(shape, tangentDirection(direction, shape.normal));
  dict["curvature_change_per_mm2"] = change.value_per_mm2;
  dict["curvature_change_error_per_mm2"] = change.error_per_mm2;
  return dict;
}

}  // namespace

void bindMeasure(py::module_& module) {
  module.def("measure_pair", &measure, py::arg("a"), py::arg("b"),
             "Gap, angle of the tangent planes (0..pi/2) and curvature difference of two surface "
             "jets, as a "
             "dict; None "
             "where a side has no tangent plane, which degenerate_a and degenerate_b then name.");
  module.def(
      "curvature_tensor", [](const SurfaceJet& jet) { return curvatureTensor(jet, normalOf(jet)); },
      py::arg("jet"),
      "The curvature tensor (3, 3) in 1/mm: d.W d is the normal curvature in the unit tangent "
      "direction d.");
  module.def(
      "principal_curvatures",
      [](const SurfaceJet& jet) {
        const PrincipalCurvatures k = principalCurvatures(jet, normalOf(jet));
        return py::make_tuple(k.k1, k.k2, k.direction1, k.direction2);
      },
      py::arg("jet"), "(k1, k2, direction1, direction2) with k1 >= k2, in 1/mm.");
  module.def("surface_shape", &shapeDict, py::arg("patch"), py::arg("u"), py::arg("v"),
             py::arg("direction") = py::none(),
             "Normal and curvature of a BezierPatch, or of a BezierTriangle at l0, l1, with bounds "
             "of their errors, "
             "also where weights differ so much that partial derivatives lose their digits. The "
             "bounds hold for the "
             "patch in memory, where products of weights and poles have been rounded. A dict of "
             "degeneracy, normal, "
             "normal_error_rad, tensor, "
             "tensor_error_per_mm, principal_curvatures_per_mm and, along the direction, "
             "curvature_change_per_mm2 "
             "and curvature_change_error_per_mm2.");
}

}  // namespace seamwright::python
