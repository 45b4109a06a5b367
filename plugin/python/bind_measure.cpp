// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <seamwright/core/bezier/surface_shape.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/parameters.hpp>

namespace seamwright::python {

namespace {

Eigen::Vector3d normalOf(const SurfaceJet& jet) {
  if (const auto normal = unitNormal(jet)) return *normal;
  throw py::value_error("the jet has no tangent plane: " + std::string(name(degeneracy(jet))));
}

const SurfaceJet& jetOf(const char* name, const py::object& value) {
  return objectOf<SurfaceJet>(name, value, "a SurfaceJet");
}

py::object measurePairOf(const py::object& a, const py::object& b) {
  const PairMeasure pair = measurePair({jetOf("a", a), {}}, {jetOf("b", b), {}});
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
  return resultOf("PairMeasure", result);
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
  const Eigen::Vector3d given = vectorOf("direction", value).stableNormalized();
  const Eigen::Vector3d along = given - normal.dot(given) * normal;
  if (!(along.norm() > 1e-6))
    throw py::value_error("direction is " + shown(value) + ": it must not lie along the normal");
  return along.normalized();
}

py::object shapeAt(const py::object& patch, double u, double v, const py::object& direction) {
  const SurfaceShape shape = shapeOf(patch, u, v);
  py::dict dict;
  dict["degeneracy"] = name(shape.degeneracy);
  for (const char* key : {"normal", "normal_error_rad", "tensor", "tensor_error_per_mm",
                          "principal_curvatures_per_mm", "curvature_change_per_mm2",
                          "curvature_change_error_per_mm2"})
    dict[key] = py::none();
  if (shape.degeneracy != Degeneracy::None) return resultOf("SurfaceShape", dict);
  dict["normal"] = shape.normal;
  dict["normal_error_rad"] = shape.normal_error_rad;
  dict["tensor"] = shape.tensor;
  dict["tensor_error_per_mm"] = shape.tensor_error_per_mm;
  const PrincipalCurvatures k = principalCurvatures(shape.jet, shape.normal);
  dict["principal_curvatures_per_mm"] = py::make_tuple(k.k1, k.k2);
  if (direction.is_none()) return resultOf("SurfaceShape", dict);
  const BoundedChange change = curvatureChange(shape, tangentDirection(direction, shape.normal));
  dict["curvature_change_per_mm2"] = change.value_per_mm2;
  dict["curvature_change_error_per_mm2"] = change.error_per_mm2;
  return resultOf("SurfaceShape", dict);
}

py::object surfaceShapeOf(const py::object& patch, const py::object& u, const py::object& v,
                          const py::object& direction) {
  const ParameterPairs at("u", u, "v", v);
  return resultsAt("SurfaceShape", at.first, [&](py::ssize_t i) {
    return shapeAt(patch, at.first[i], at.second[i], direction);
  });
}

py::tuple principalOf(const py::object& jet) {
  const SurfaceJet& given = jetOf("jet", jet);
  const PrincipalCurvatures k = principalCurvatures(given, normalOf(given));
  return py::make_tuple(k.k1, k.k2, k.direction1, k.direction2);
}

}  // namespace

void bindMeasure(py::module_& module) {
  module.def(
      "measure_pair", &measurePairOf, py::arg("a"), py::arg("b"),
      R"(How two surface jets differ, a PairMeasure: gap, angle of the tangent planes, curvature.

Angle and curvature are None where a side has no tangent plane, which degenerate_a and degenerate_b
then name. TypeError for anything but a SurfaceJet.)");
  module.def(
      "curvature_tensor",
      [](const py::object& jet) {
        const SurfaceJet& given = jetOf("jet", jet);
        return curvatureTensor(given, normalOf(given));
      },
      py::arg("jet"),
      "The curvature tensor (3, 3) in 1/mm: d.W d is the normal curvature in the unit tangent "
      "direction d. ValueError for a jet without tangent plane.");
  module.def("principal_curvatures", &principalOf, py::arg("jet"),
             "(k1, k2, direction1, direction2) with k1 >= k2 in 1/mm, and unit directions (3,). "
             "ValueError for a jet without tangent plane.");
  module.def(
      "surface_shape", &surfaceShapeOf, py::arg("patch"), py::arg("u"), py::arg("v"),
      py::arg("direction") = py::none(),
      R"(Normal and curvature of a BezierPatch, or of a BezierTriangle at l0, l1: a SurfaceShape.

u, v: parameters, or arrays that broadcast; the values are then arrays with nan for None. direction
(3,): also the change of curvature along its part in the tangent plane.

Errors are bounded, also where weights differ so much that partial derivatives lose their digits.
The bounds hold for the patch in memory, where products of weights and poles have been rounded.
TypeError for another class; ValueError for parameters that are not finite and a direction along
the normal.)");
}

}  // namespace seamwright::python
