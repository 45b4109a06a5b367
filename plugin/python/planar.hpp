// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/planar/conic.hpp>
#include <seamwright/core/planar/spiral.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/parameters.hpp>
#include <string>
#include <utility>
#include <vector>

/// What the bindings of curves of the plane share: arguments, chains, evaluation at parameters.
namespace seamwright::python {

/// Two finite numbers.
Eigen::Vector2d planarPointOf(const char* name, const py::object& value);

/// The rows of an argument of shape (count, 2).
PlanarPoints planarPointsOf(const char* name, const py::handle& value);

/// Points with directions, by the names of their arguments.
HermiteEnds hermiteEndsOf(const py::object& start, const py::object& start_direction_rad,
                          const py::object& end, const py::object& end_direction_rad);

/// A list of numbers as an array.
Eigen::VectorXd arrayOfNumbers(const std::vector<double>& numbers);

/// A spline with its proven distance as a result.
py::object splineWithinResult(const SplineWithin& spline);

/// A positive finite number.
double positiveNumber(const char* name, const py::object& value);

template <class Value>
struct NamedValue {
  const char* name;
  Value value;
};

/// The value with the name that is given. \throws ValueError that lists the names.
template <class Value, std::size_t count>
Value choiceOf(const char* name, const py::object& given, const NamedValue<Value> (&known)[count]) {
  const auto text = argument<std::string>(name, given, "a name");
  std::string names;
  for (std::size_t i = 0; i < count; ++i) {
    if (text == known[i].name) return known[i].value;
    names += (i == 0           ? ""
              : i + 1 == count ? " and "
                               : ", ") +
             ("'" + std::string(known[i].name)) + "'";
  }
  throw py::value_error(std::string(name) + " is " + shown(given) + ": known are " + names);
}

/// An angle by which a curve turns that is not too large. A choice that bounds time and memory: an
/// arc has a Bézier segment for each started 2 pi / 3, a clothoid a step of quadrature for each 3
/// rad.
inline constexpr double most_turn_rad = 1e4;
void requireTurn(double turn_rad);

/// Curves end to end, with the arc length as parameter.
template <class Piece>
class PlanarChain {
 public:
  PlanarChain(std::vector<Piece> pieces, bool closed)
      : pieces_(std::move(pieces)), closed_(closed) {
    for (const Piece& piece : pieces_) {
      starts_mm_.push_back(length_mm_);
      length_mm_ += piece.length_mm;
    }
  }

  const std::vector<Piece>& pieces() const { return pieces_; }
  bool closed() const { return closed_; }
  double length_mm() const { return length_mm_; }

  /// The piece at an arc length, the later one at a joint, and the arc length from its start.
  std::pair<const Piece&, double> at(double s_mm) const {
    const auto after = std::upper_bound(starts_mm_.begin() + 1, starts_mm_.end(), s_mm);
    const auto i = static_cast<std::size_t>(after - starts_mm_.begin()) - 1;
    return {pieces_[i], s_mm - starts_mm_[i]};
  }
  Eigen::Vector2d point(double s_mm) const {
    const auto [piece, local_mm] = at(s_mm);
    return piece.point(local_mm);
  }
  double directionAt_rad(double s_mm) const {
    const auto [piece, local_mm] = at(s_mm);
    return piece.directionAt_rad(local_mm);
  }

  bool operator==(const PlanarChain& other) const = default;

 private:
  std::vector<Piece> pieces_;
  std::vector<double> starts_mm_;
  double length_mm_ = 0;
  bool closed_ = false;
};

using ClothoidChain = PlanarChain<Clothoid>;

class ArcChain : public PlanarChain<PlanarArc> {
 public:
  ArcChain(std::vector<PlanarArc> arcs, bool closed, std::vector<int> corners = {})
      : PlanarChain(std::move(arcs), closed), corners_(std::move(corners)) {}

  /// Arcs that begin at a corner.
  const std::vector<int>& corners() const { return corners_; }

  bool operator==(const ArcChain& other) const = default;

 private:
  std::vector<int> corners_;
};

/// The chain as a spline with the arc length as parameter: the same points.
BezierSpline exactSpline(const ArcChain& chain);

/// The arcs of a sequence, of a chain or of a result with a chain. \throws TypeError.
std::vector<PlanarArc> arcsOf(const char* name, const py::object& value);

/// The objects of a sequence. \throws TypeError that names the argument and the index.
/// \param kind "a Clothoid"
template <class Piece>
std::vector<Piece> piecesOf(const std::string& name, const py::object& value, const char* kind) {
  if (!isSequence(value))
    throw py::type_error(name + " is " + shown(value) + ": a sequence is needed, each item " +
                         kind);
  std::vector<Piece> pieces;
  for (const py::handle item : value)
    pieces.push_back(objectOf<Piece>(name + "[" + std::to_string(pieces.size()) + "]", item, kind));
  return pieces;
}

/// Whether each piece ends where the next one starts, the last one of a closed chain at the start.
/// \throws ValueError with the joint and the gap, and for no pieces.
template <class Piece>
void requireJoined(const char* what, const std::vector<Piece>& pieces, bool closed, double gap_mm) {
  if (pieces.empty()) throw py::value_error(std::string(what) + " are []: at least one is needed");
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i + 1 == pieces.size() && !closed) break;
    const double found_mm = (pieces[(i + 1) % pieces.size()].start - pieces[i].end()).norm();
    if (!(found_mm <= gap_mm))
      throw py::value_error(std::string(what) + ": the end of " + std::to_string(i) + " is " +
                            shown(py::float_(found_mm)) + " mm from the start of " +
                            std::to_string((i + 1) % pieces.size()) + ", more than gap_mm " +
                            shown(py::float_(gap_mm)));
  }
}

// The range of the parameter, which starts at 0, and the curvature there.

inline double lastParameter(const PlanarArc& arc) {
  return arc.length_mm;
}
inline double lastParameter(const Clothoid& clothoid) {
  return clothoid.length_mm;
}
inline double lastParameter(const LogSpiral& spiral) {
  return spiral.turn_rad;
}
inline double lastParameter(const PlanarConic&) {
  return 1;
}
template <class Piece>
double lastParameter(const PlanarChain<Piece>& chain) {
  return chain.length_mm();
}

inline double curvatureAt_per_mm(const PlanarArc& arc, double) {
  return arc.curvature_per_mm;
}
inline double curvatureAt_per_mm(const Clothoid& clothoid, double s_mm) {
  return clothoid.curvatureAt_per_mm(s_mm);
}
inline double curvatureAt_per_mm(const LogSpiral& spiral, double u_rad) {
  return 1 / spiral.radiusAt_mm(u_rad);
}
inline double curvatureAt_per_mm(const PlanarConic& conic, double t) {
  return conic.curvatureAt_per_mm(t);
}
template <class Piece>
double curvatureAt_per_mm(const PlanarChain<Piece>& chain, double s_mm) {
  const auto [piece, local_mm] = chain.at(s_mm);
  return curvatureAt_per_mm(piece, local_mm);
}

/// Parameters between 0 and \p last. \throws ValueError that names the argument and its value.
Parameters parametersWithin(const char* name, const py::object& value, double last);

/// A number at each parameter: one, or an array of their shape.
template <class Value>
py::object numbersAt(const Parameters& parameters, const Value& value) {
  if (parameters.isSingle()) return py::float_(value(parameters[0]));
  return valuesOf(parameters.shape(), {},
                  [&](py::ssize_t i) { return std::array{double(value(parameters[i]))}; });
}

/// The members point, direction_at_rad and curvature_at_per_mm, by the parameter \p name.
template <class Curve>
void bindEvaluation(py::class_<Curve>& type, const char* name) {
  type.def(
          "point",
          [name](const Curve& curve, const py::object& value) {
            const Parameters at = parametersWithin(name, value, lastParameter(curve));
            return valuesOf(at.shape(), {2}, [&](py::ssize_t i) { return curve.point(at[i]); });
          },
          py::arg(name), "The point (2,); for an array of shape s, points s + (2,).")
      .def(
          "direction_at_rad",
          [name](const Curve& curve, const py::object& value) {
            return numbersAt(parametersWithin(name, value, lastParameter(curve)),
                             [&](double at) { return curve.directionAt_rad(at); });
          },
          py::arg(name), "The angle of the tangent against the first axis; for an array, an array.")
      .def(
          "curvature_at_per_mm",
          [name](const Curve& curve, const py::object& value) {
            return numbersAt(parametersWithin(name, value, lastParameter(curve)),
                             [&](double at) { return curvatureAt_per_mm(curve, at); });
          },
          py::arg(name), "The curvature, above 0 to the left; for an array, an array.");
}

/// Comparison by the numbers; values that can change have no hash.
template <class Curve>
void bindEquality(py::class_<Curve>& type) {
  type.def(py::self == py::self).attr("__hash__") = py::none();
}

}  // namespace seamwright::python
