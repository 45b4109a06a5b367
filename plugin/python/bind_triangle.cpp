// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/triangle_conversion.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <sstream>

namespace seamwright::python {

namespace {

BezierTriangle makeTriangle(const Array& poles, const std::optional<Array>& weights) {
  const Poles rows = polesOf(poles, 2, "((n+1)(n+2)/2, 3)");
  return weights ? BezierTriangle(rows, weightsOf(*weights, poles)) : BezierTriangle(rows);
}

/// The rows of an array of barycentric coordinates.
std::vector<Barycentric> barycentricRows(const char* name, const Array& array) {
  constexpr double slip = 1e-9;  // far above the rounding of barycentric coordinates
  const Poles rows = polesOf(array, 2, "(number, 3)");
  std::vector<Barycentric> result;
  for (const auto& row : rows.rowwise()) {
    if (std::abs(row.sum() - 1) > slip * std::max(1.0, row.cwiseAbs().maxCoeff()))
      throw py::value_error(std::string(name) + ", row " + std::to_string(result.size()) +
                            " has the sum " + bernstein::text(row.sum()) +
                            ": barycentric coordinates have the sum 1");
    result.emplace_back(row);
  }
  return result;
}

Eigen::Vector3d pointOf(const BezierTriangle& triangle, double l0, double l1) {
  return triangle.point(parameter("l0", l0), parameter("l1", l1));
}

SurfaceJet jetOf(const BezierTriangle& triangle, double l0, double l1) {
  return triangle.jet(parameter("l0", l0), parameter("l1", l1));
}

BezierTriangle subtriangleOf(const BezierTriangle& triangle, const Array& corners) {
  const std::vector<Barycentric> rows = barycentricRows("corners", corners);
  if (rows.size() != 3)
    throw py::value_error("corners are " + std::to_string(rows.size()) + " rows: three are needed");
  return triangle.subtriangle({rows[0], rows[1], rows[2]});
}

Eigen::Vector4d blossomOf(const BezierTriangle& triangle, const Array& arguments) {
  return triangle.blossom(barycentricRows("arguments", arguments));
}

std::optional<double> toleranceArgument(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  return argument<double>("tolerance_mm", value, "a number");
}

BezierTriangle fromPatch(const BezierPatch& patch, const py::object& tolerance_mm) {
  const TriangleRecognition found = recogniseTriangle(patch, toleranceArgument(tolerance_mm));
  if (found.triangle) return *found.triangle;
  std::ostringstream text;
  text << "the patch is no triangle: it is up to " << found.deviation_mm
       << " mm away from the nearest that was "
       << "tried, accepted are " << found.tolerance_mm << " mm";
  throw py::value_error(text.str());
}

}  // namespace

void bindTriangle(py::module_& module) {
  py::class_<BezierTriangle>(module, "BezierTriangle", py::module_local(),
                             "A (rational) Bézier triangle over barycentric coordinates l0 + l1 + "
                             "l2 = 1: poles ((n+1)(n+2)/2, 3), "
                             "weights ((n+1)(n+2)/2,) or None.\n\n"
                             "Poles are in the order i = 0..n, j = 0..n-i, pole (i, j) at (i, j, "
                             "n-i-j)/n: the first is the corner "
                             "P2, the last P0.")
      .def(py::init(&makeTriangle), py::arg("poles"), py::arg("weights") = py::none())
      .def_property_readonly("degree", &BezierTriangle::degree)
      .def_property_readonly("is_rational", &BezierTriangle::isRational)
      .def_property_readonly("poles", &BezierTriangle::poles)
      .def_property_readonly("weights", &BezierTriangle::weights)
      .def("point", &pointOf, py::arg("l0"), py::arg("l1"))
      .def("jet", &jetOf, py::arg("l0"), py::arg("l1"),
           "Point and partials by u = l0, v = l1 to third order, a SurfaceJet.")
      .def("blossom", &blossomOf, py::arg("arguments"),
           "The homogeneous value (4,) of the blossom at as many barycentric points (n, 3) as the "
           "degree.")
      .def(
          "edge_curve",
          [](const BezierTriangle& triangle, const py::object& edge) {
            return triangle.edgeCurve(triangleEdgeOf("edge", edge));
          },
          py::arg("edge"),
          "The boundary 'l0' (from P1 to P2), 'l1' (from P2 to P0) or 'l2' (from P0 to P1).")
      .def("elevated", &BezierTriangle::elevated, "The same triangle with one degree more.")
      .def("permuted", &BezierTriangle::permuted, py::arg("corners"),
           "The same triangle with its corners in another order: corner c of the result is corner "
           "corners[c].")
      .def("subtriangle", &subtriangleOf, py::arg("corners"),
           "The part over the triangle of three barycentric points, the rows of corners (3, 3).")
      .def("split_at", &BezierTriangle::splitAt, py::arg("l0"), py::arg("l1"),
           "Three triangles around a point; the k-th has the point in place of corner k.")
      .def("quartered", &BezierTriangle::quartered,
           "Four triangles between the middles of the edges: the k-th keeps corner k, the last is "
           "the middle "
           "one, whose corner k is the middle of edge k.")
      .def("to_patch", &degeneratePatch, py::arg("apex") = 0,
           "The triangle as one BezierPatch of degrees n, n whose edge u = 0 is the corner apex: "
           "T(1-u, u(1-v), uv) for apex 0. u = 1 is the edge opposite to it, in its own sense.")
      .def("to_patches", &regularPatches,
           "The triangle as three BezierPatch of degrees n, n around its centroid, regular where "
           "the triangle "
           "is. The k-th begins at corner k: (u, v) = (0, 0), (1, 0), (1, 1), (0, 1) are Pk, (Pk + "
           "Pk+1)/2, "
           "the centroid, (Pk + Pk+2)/2.")
      .def_static(
          "from_patch", &fromPatch, py::arg("patch"), py::arg("tolerance_mm") = py::none(),
          "The triangle of lowest degree that a BezierPatch with a collapsed edge is; that edge is "
          "its "
          "corner P0.\n\n"
          "tolerance_mm is how far it may be away at equal parameters; None: the rounding of the "
          "conversion. ValueError, with the distance, if the patch is no triangle.")
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

}  // namespace seamwright::python
