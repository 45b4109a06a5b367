// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <seamwright/core/bspline/edge_patches.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/python/surfaces.hpp>

namespace seamwright::python {

namespace {

std::vector<BezierPatch> edgePatchesOf(const py::object& surface, const py::object& edge,
                                       const py::object& breaks) {
  return edgePatches(splineSurfaceOf("surface", surface), patchEdgeOf("edge", edge),
                     listOf("breaks", breaks));
}

std::vector<std::pair<BezierPatch, BezierPatch>> edgePairsOf(const py::object& a,
                                                             const py::object& edge_a,
                                                             const py::object& b,
                                                             const py::object& edge_b,
                                                             const py::object& reversed) {
  return edgePairs(splineSurfaceOf("a", a), patchEdgeOf("edge_a", edge_a), splineSurfaceOf("b", b),
                   patchEdgeOf("edge_b", edge_b), flagOf("reversed", reversed));
}

}  // namespace

void bindEdgePatches(py::module_& module) {
  module.def("edge_patches", &edgePatchesOf, py::arg("surface"), py::arg("edge"),
             py::arg("breaks") = py::tuple(),
             R"(The BezierPatches of a BSplineSurface beside one of its boundaries, 'u0', 'u1',
'v0' or 'v1', one for each span along it. Each has the directions of the surface, and the edge of
the same name is its part of the boundary. breaks: shares in (0, 1) at which the boundary is divided
too.)");
  module.def("edge_pairs", &edgePairsOf, py::arg("a"), py::arg("edge_a"), py::arg("b"),
             py::arg("edge_b"), py::arg("reversed") = false,
             R"(Pairs of BezierPatches beside two boundaries of BSplineSurfaces, over spans that
both have, in the order of the first boundary: what join_condition(), blend(), fit_connection() and
continuation() take. Equal shares of both parameter ranges correspond. reversed: edge_b runs the
other way; each function takes the same argument.)");
}

}  // namespace seamwright::python
