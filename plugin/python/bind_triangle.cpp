// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/triangle_conversion.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/parameters.hpp>
#include <sstream>

namespace seamwright::python {

namespace {

BezierTriangle makeTriangle(const py::object& poles, const py::object& weights) {
  const Array array = arrayOf("poles", poles);
  return {polesOf("poles", array, 2, "((n+1)(n+2)/2, 3)"), weightsOf(weights, array)};
}

/// The rows of an array of barycentric coordinates.
std::vector<Barycentric> barycentricRows(const char* name, const py::object& array) {
  constexpr double slip = 1e-9;  // far above the rounding of barycentric coordinates
  const Poles rows = rowsOf(name, array, "(number, 3)");
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

Array trianglePoint(const BezierTriangle& triangle, const py::object& l0, const py::object& l1) {
  const ParameterPairs at("l0", l0, "l1", l1);
  return valuesOf(at.first.shape(), {3},
                  [&](py::ssize_t i) { return triangle.point(at.first[i], at.second[i]); });
}

py::object triangleJet(const BezierTriangle& triangle, const py::object& l0, const py::object& l1) {
  const ParameterPairs at("l0", l0, "l1", l1);
  return objectsAt(at.first,
                   [&](py::ssize_t i) { return triangle.jet(at.first[i], at.second[i]); });
}

std::array<int, 3> cornersOf(const py::object& corners) {
  const std::vector<int> numbers = wholeNumbers("corners", corners);
  if (numbers.size() != 3)
    throw py::value_error("corners is " + shown(corners) + ": three whole numbers are needed");
  return {numbers[0], numbers[1], numbers[2]};
}

std::array<BezierTriangle, 3> partsAround(const BezierTriangle& triangle, const py::object& l0,
                                          const py::object& l1) {
  return triangle.splitAt(parameter("l0", l0), parameter("l1", l1));
}

BezierTriangle subtriangleOf(const BezierTriangle& triangle, const py::object& corners) {
  const std::vector<Barycentric> rows = barycentricRows("corners", corners);
  if (rows.size() != 3)
    throw py::value_error("corners are " + std::to_string(rows.size()) + " rows: three are needed");
  return triangle.subtriangle({rows[0], rows[1], rows[2]});
}

Eigen::Vector4d blossomOf(const BezierTriangle& triangle, const py::object& arguments) {
  return triangle.blossom(barycentricRows("arguments", arguments));
}

BezierTriangle fromPatch(const py::object& patch, const py::object& tolerance_mm) {
  const TriangleRecognition found =
      recogniseTriangle(objectOf<BezierPatch>("patch", patch, "a BezierPatch"),
                        optionalNumber("tolerance_mm", tolerance_mm));
  if (found.triangle) return *found.triangle;
  std::ostringstream text;
  text << "the patch is not a triangle: it is up to " << found.deviation_mm
       << " mm away from the nearest one tried; the tolerance is " << found.tolerance_mm << " mm";
  throw py::value_error(text.str());
}

void bindMembers(py::class_<BezierTriangle>& type) {
  type.def(py::init(&makeTriangle), py::arg("poles"), py::arg("weights") = py::none())
      .def_property_readonly("degree", &BezierTriangle::degree, "n: an edge has n + 1 poles.")
      .def_property_readonly("is_rational", &BezierTriangle::isRational,
                             "Whether the weights differ.")
      .def_property_readonly("poles", &BezierTriangle::poles, "((n+1)(n+2)/2, 3), in mm.")
      .def_property_readonly("weights", &BezierTriangle::weights, "((n+1)(n+2)/2,).")
      .def("point", &trianglePoint, py::arg("l0"), py::arg("l1"),
           "The point (3,) at (l0, l1); arrays broadcast to a shape s: points s + (3,).")
      .def("jet", &triangleJet, py::arg("l0"), py::arg("l1"),
           "Point and partials by u = l0, v = l1 to third order, a SurfaceJet; for arrays an array "
           "of them.")
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
      .def(py::pickle(
          [](const BezierTriangle& triangle) {
            return homogeneousArray(triangle.homogeneousPoles());
          },
          [](const Array& state) {
            return BezierTriangle::fromHomogeneous(homogeneousRows(state));
          }))
      .def("__repr__",
           [](const BezierTriangle& triangle) {
             return "<BezierTriangle of degree " + std::to_string(triangle.degree()) +
                    (triangle.isRational() ? ", rational>" : ">");
           })
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

void bindParts(py::class_<BezierTriangle>& type) {
  type.def("elevated", &BezierTriangle::elevated, "The same triangle with one degree more.")
      .def(
          "permuted",
          [](const BezierTriangle& triangle, const py::object& corners) {
            return triangle.permuted(cornersOf(corners));
          },
          py::arg("corners"),
          "The same triangle with its corners in another order: corner c of the result is corner "
          "corners[c].")
      .def("subtriangle", &subtriangleOf, py::arg("corners"),
           "The part over the triangle of three barycentric points, the rows of corners (3, 3).")
      .def("split_at", &partsAround, py::arg("l0"), py::arg("l1"),
           "Three triangles around a point; the k-th has the point in place of corner k.")
      .def("quartered", &BezierTriangle::quartered,
           "Four triangles between the middles of the edges: the k-th keeps corner k, the last is "
           "the middle one, whose corner k is the middle of edge k.")
      .def(
          "to_patch",
          [](const BezierTriangle& triangle, const py::object& apex) {
            return degeneratePatch(triangle, wholeNumber("apex", apex));
          },
          py::arg("apex") = 0,
          "The triangle as one BezierPatch of degrees n, n whose edge u = 0 is the corner apex: "
          "T(1-u, u(1-v), uv) for apex 0. u = 1 is the edge opposite to it, in its own sense.")
      .def("to_patches", &regularPatches,
           "The triangle as three BezierPatch of degrees n, n around its centroid, regular where "
           "the triangle is. The k-th begins at corner k: (u, v) = (0, 0), (1, 0), (1, 1), (0, 1) "
           "are Pk, (Pk + Pk+1)/2, the centroid, (Pk + Pk+2)/2.")
      .def_static(
          "from_patch", &fromPatch, py::arg("patch"), py::arg("tolerance_mm") = py::none(),
          "The triangle of lowest degree that a BezierPatch with a collapsed edge is; that edge is "
          "its corner P0.\n\n"
          "tolerance_mm is how far it may be away at equal parameters; None: the rounding of the "
          "conversion. ValueError, with the distance, if the patch is not a triangle.");
}

}  // namespace

void bindTriangle(py::module_& module) {
  py::class_<BezierTriangle> type(
      module, "BezierTriangle", py::module_local(),
      R"(A (rational) Bézier triangle over barycentric coordinates l0 + l1 + l2 = 1: poles
((n+1)(n+2)/2, 3) in mm, weights ((n+1)(n+2)/2,) or None.

Poles are in the order i = 0..n, j = 0..n-i, pole (i, j) at (i, j, n-i-j)/n: the first is the
corner P2, the last P0. ValueError, with index and value, for a pole that is not finite and a
weight that is not positive.)");
  bindMembers(type);
  bindParts(type);
}

}  // namespace seamwright::python
