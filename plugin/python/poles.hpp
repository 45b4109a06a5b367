// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright::python {

using Array = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// The rows of an array of shape (..., 3). \param wanted that shape in words.
/// \throws ValueError naming the shape if it has another number of dimensions or columns.
Poles polesOf(const Array& array, pybind11::ssize_t dimensions, const char* wanted);

/// \throws ValueError naming the shapes unless there is one weight for each pole.
Eigen::VectorXd weightsOf(const Array& weights, const Array& poles);

}  // namespace seamwright::python
