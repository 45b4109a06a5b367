// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright::python {

/// An array of real numbers. An argument may hold integers and real numbers; complex numbers,
/// booleans and text are refused with a ValueError.
class Array
    : public pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast> {
 public:
  using array_t::array_t;
};

Array arrayOf(const pybind11::handle& value);

/// The rows of an array of shape (..., 3). \param wanted the required shape as text.
/// \throws ValueError that names the shape, if the array has another number of dimensions or
/// columns.
Poles polesOf(const Array& array, pybind11::ssize_t dimensions, const char* wanted);

/// \throws ValueError that names the shapes, unless there is one weight for each pole.
Eigen::VectorXd weightsOf(const Array& weights, const Array& poles);

}  // namespace seamwright::python

namespace pybind11::detail {

template <>
struct type_caster<seamwright::python::Array> {
  PYBIND11_TYPE_CASTER(seamwright::python::Array, const_name("numpy.ndarray[numpy.float64]"));

  bool load(handle source, bool) {
    value = seamwright::python::arrayOf(source);
    return true;
  }
  static handle cast(const seamwright::python::Array& array, return_value_policy, handle) {
    return array.inc_ref();
  }
};

}  // namespace pybind11::detail
