// SPDX-License-Identifier: LGPL-2.1-or-later Passes shapes by pointer. FreeCAD gives and takes
// pointers to TopoDS_Shape through SWIG's table of types, if a module has put that type into the
// table. This file puts it there, unless another module did so before.
#include <Python.h>
#include <swigpyrun.h>
#include <memory>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/plugin/python/bindings.hpp>

namespace py = pybind11;

namespace seamwright::python {

namespace {

/// SWIG's entry for TopoDS_Shape. It is static, because the table keeps its address.
swig_type_info* shapeType() {
  static swig_type_info type = {"_p_TopoDS_Shape", "TopoDS_Shape *", nullptr, nullptr, nullptr, 0};
  // The last member is a pointer before SWIG's runtime 5 and a number since; {} fits both.
  static swig_cast_info cast = {&type, nullptr, nullptr, {}};
  static swig_type_info* types[] = {&type};
  static swig_module_info table = {types, 1, nullptr, nullptr, nullptr, nullptr};
  static swig_type_info* found = nullptr;
  if (found != nullptr) return found;
  swig_module_info* head = SWIG_GetModule(nullptr);
  if (head != nullptr) found = SWIG_TypeQueryModule(head, head, "TopoDS_Shape *");
  if (found != nullptr) return found;
  type.cast = &cast;
  if (head == nullptr) {
    table.next = &table;
    SWIG_SetModule(nullptr, &table);
  } else {
    table.next = head->next;
    head->next = &table;
  }
  return found = &type;
}

occ::Model modelFromPointer(const py::object& pointer) {
  void* address = nullptr;
  if (SWIG_ConvertPtr(pointer.ptr(), &address, shapeType(), SWIG_POINTER_DISOWN) < 0 ||
      address == nullptr)
    throw py::type_error("not a pointer to a shape");
  // FreeCAD passed ownership of the handle; the shape behind it stays shared.
  const std::unique_ptr<TopoDS_Shape> shape(static_cast<TopoDS_Shape*>(address));
  return occ::modelFromShape(*shape);
}

py::object pointerFromModel(const occ::Model& model) {
  // FreeCAD copies the handle and does not take ownership of the pointer. The caller keeps the
  // model alive until FreeCAD has copied.
  return py::reinterpret_steal<py::object>(
      SWIG_NewPointerObj(const_cast<TopoDS_Shape*>(&model.shape), shapeType(), 0));
}

}  // namespace

void bindPointerBridge(py::module_& module) {
  module.def("_ensure_shape_type", [] { shapeType(); });
  module.def("_model_from_pointer", &modelFromPointer);
  module.def("_pointer_from_model", &pointerFromModel);
}

}  // namespace seamwright::python
