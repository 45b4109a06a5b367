// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace seamwright::python {

void bindAlpha(pybind11::module_& module);
void bindBernstein(pybind11::module_& module);
void bindBezier(pybind11::module_& module);
void bindBlend(pybind11::module_& module);
void bindBuiltModel(pybind11::module_& module);
void bindCornerFillet(pybind11::module_& module);
void bindCurveJoin(pybind11::module_& module);
void bindCurveFairing(pybind11::module_& module);
void bindCurveMatch(pybind11::module_& module);
void bindFill(pybind11::module_& module);
void bindFrameLoft(pybind11::module_& module);
void bindFunctionSpline(pybind11::module_& module);
void bindHole(pybind11::module_& module);
void bindJoin(pybind11::module_& module);
void bindBlendSurface(pybind11::module_& module);
void bindEdgePatches(pybind11::module_& module);
void bindMatch(pybind11::module_& module);
void bindMatrixCurve(pybind11::module_& module);
void bindMeasure(pybind11::module_& module);
void bindMesh(pybind11::module_& module);
void bindModel(pybind11::module_& module);
void bindNearest(pybind11::module_& module);
void bindNuSpline(pybind11::module_& module);
void bindNearestCurve(pybind11::module_& module);
void bindPlanarArc(pybind11::module_& module);
void bindPlanarBiarc(pybind11::module_& module);
void bindPlanarClothoid(pybind11::module_& module);
void bindPlanarConic(pybind11::module_& module);
void bindPlanarSpiral(pybind11::module_& module);
void bindPointFairing(pybind11::module_& module);
void bindPointerBridge(pybind11::module_& module);
void bindRepair(pybind11::module_& module);
void bindSeam(pybind11::module_& module);
void bindSpline(pybind11::module_& module);
void bindSpaceCurve(pybind11::module_& module);
void bindTriangle(pybind11::module_& module);
void bindUmbrella(pybind11::module_& module);

}  // namespace seamwright::python
