// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <numeric>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <vector>

/// Arguments that are one parameter or an array of parameters.
namespace seamwright::python {

/// Shape of an array; empty for a single number.
using Shape = std::vector<pybind11::ssize_t>;

/// A finite number, or an array of finite numbers of any shape.
class Parameters {
 public:
  /// \throws ValueError that names the argument and its value.
  Parameters(const char* name, const pybind11::object& value);
  explicit Parameters(Array values) : values_(std::move(values)) {}

  bool isSingle() const { return values_.ndim() == 0; }
  pybind11::ssize_t size() const { return values_.size(); }
  double operator[](pybind11::ssize_t i) const { return values_.data()[i]; }
  Shape shape() const { return Shape(values_.shape(), values_.shape() + values_.ndim()); }
  const Array& values() const { return values_; }

 private:
  Array values_;
};

/// Two arguments, broadcast to one shape as numpy does it.
struct ParameterPairs {
  Parameters first, second;

  /// \throws ValueError that names the arguments and their shapes.
  ParameterPairs(const char* first_name, const pybind11::object& first_value,
                 const char* second_name, const pybind11::object& second_value);
};

/// The order of derivatives, 0 to \p most. The bound limits the time: the quotient rule takes
/// order^2 steps.
int derivativeOrder(const pybind11::object& order, int most = 1000);

/// The values of a function at \p count parameters as an array of shape \p shape + \p each.
/// \param value  at the i-th parameter; its data are contiguous, in the order of \p each.
template <class Value>
Array valuesOf(const Shape& shape, const Shape& each, const Value& value) {
  Shape whole = shape;
  whole.insert(whole.end(), each.begin(), each.end());
  const auto product = [](const Shape& s) {
    return std::accumulate(s.begin(), s.end(), pybind11::ssize_t{1}, std::multiplies<>());
  };
  const pybind11::ssize_t count = product(shape), size = product(each);
  Array result(whole);
  for (pybind11::ssize_t i = 0; i < count; ++i) {
    const auto numbers = value(i);
    std::copy(numbers.data(), numbers.data() + size, result.mutable_data() + i * size);
  }
  return result;
}

/// A result at each parameter; for an array one result with arrays.
template <class Result>
pybind11::object resultsAt(const char* name, const Parameters& parameters, const Result& result) {
  if (parameters.isSingle()) return result(0);
  pybind11::list results;
  for (pybind11::ssize_t i = 0; i < parameters.size(); ++i) results.append(result(i));
  return stackedResults(name, results, parameters.shape());
}

/// Objects at the parameters: one, or an array of objects.
template <class Object>
pybind11::object objectsAt(const Parameters& parameters, const Object& object) {
  if (parameters.isSingle()) return pybind11::cast(object(0));
  pybind11::array objects(pybind11::dtype("O"), parameters.shape());
  const pybind11::object flat = objects.attr("reshape")(-1);
  for (pybind11::ssize_t i = 0; i < parameters.size(); ++i)
    flat[pybind11::int_(i)] = pybind11::cast(object(i));
  return objects;
}

}  // namespace seamwright::python
