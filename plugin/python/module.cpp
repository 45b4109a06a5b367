// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Version.hxx>
#include <seamwright/plugin/python/bindings.hpp>

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
  bindNearestCurve(module);
  bindFill(module);
  bindSpline(module);
  bindNuSpline(module);
  bindAlpha(module);
  bindPlanarArc(module);
  bindPlanarBiarc(module);
  bindPlanarConic(module);
  bindPlanarClothoid(module);
  bindPlanarSpiral(module);
  bindPointFairing(module);
  bindCurveFairing(module);
  bindModel(module);
  bindMesh(module);
  bindMatch(module);
  bindCornerFillet(module);
  bindRepair(module);
  bindHole(module);
  bindPointerBridge(module);
}
