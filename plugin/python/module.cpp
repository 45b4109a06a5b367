// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Version.hxx>
#include <algorithm>
#include <seamwright/plugin/python/bindings.hpp>

namespace seamwright::python {

namespace {

namespace py = pybind11;

/// Protocols 0 and 1 of pickle construct the base type of pybind11, which ends the process. So they
/// store what protocol 2 stores.
py::object reduced(const py::object& value, int protocol) {
  const py::handle base(reinterpret_cast<PyObject*>(&PyBaseObject_Type));
  return base.attr("__reduce_ex__")(value, std::max(protocol, 2));
}

/// Types that define __reduce_ex__ themselves keep it.
void defineReduction(const py::module_& module) {
  const py::type metaclass = py::type::of(module.attr("BezierCurve"));
  for (const auto& [name, value] : py::dict(module.attr("__dict__")))
    if (py::type::of(value).is(metaclass) && !value.attr("__dict__").contains("__reduce_ex__"))
      py::setattr(value, "__reduce_ex__",
                  py::cpp_function(&reduced, py::name("__reduce_ex__"), py::is_method(value),
                                   py::arg("protocol")));
}

}  // namespace

}  // namespace seamwright::python

PYBIND11_MODULE(_core, module) {
  using namespace seamwright::python;
  module.doc() = "The compiled part of seamwright.";
  module.attr("__version__") = SEAMWRIGHT_VERSION;
  module.attr("OCCT_VERSION") = OCC_VERSION_COMPLETE;
  bindBernstein(module);
  bindBezier(module);
  bindTriangle(module);
  bindMeasure(module);
  bindSeam(module);
  bindSpaceCurve(module);
  bindJoin(module);
  bindUmbrella(module);
  bindCurveJoin(module);
  bindNearest(module);
  bindEdgePatches(module);
  bindNearestCurve(module);
  bindFill(module);
  bindSpline(module);
  bindNuSpline(module);
  bindAlpha(module);
  bindBlend(module);
  bindCurveMatch(module);
  bindFrameLoft(module);
  bindPlanarArc(module);
  bindPlanarBiarc(module);
  bindPlanarConic(module);
  bindPlanarClothoid(module);
  bindPlanarSpiral(module);
  bindPointFairing(module);
  bindCurveFairing(module);
  bindFunctionSpline(module);
  bindMatrixCurve(module);
  bindModel(module);
  bindBuiltModel(module);
  bindMesh(module);
  bindMatch(module);
  bindBlendSurface(module);
  bindCornerFillet(module);
  bindRepair(module);
  bindHole(module);
  bindPointerBridge(module);
  defineReduction(module);
}
