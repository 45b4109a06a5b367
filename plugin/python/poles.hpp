// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <string>

/// Arguments that are arrays of real numbers. Integers are converted; complex numbers, booleans and
/// text are refused. Every error is a ValueError that names the argument.
namespace seamwright::python {

using Array = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

Array arrayOf(const std::string& name, const pybind11::handle& value);

/// "(2, 3)".
std::string shapeText(const pybind11::array& array);

/// The rows of an array of shape (..., 3). \param wanted the required shape as text.
Poles polesOf(const std::string& name, const Array& array, pybind11::ssize_t dimensions,
              const char* wanted);

/// The rows of an argument of shape (n, 3).
Poles rowsOf(const std::string& name, const pybind11::handle& value, const char* wanted = "(n, 3)");

/// One weight for each pole, or ones for None.
Eigen::VectorXd weightsOf(const pybind11::object& weights, const Array& poles);

/// Homogeneous poles as an array, and back: the state of a pickled curve or surface.
Array homogeneousArray(const HomogeneousPoles& poles);
HomogeneousPoles homogeneousRows(const Array& state);

}  // namespace seamwright::python
